#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "contact_state.hpp"
#include "first_root.hpp"
#include "lanes.hpp"

namespace sigmasweep {

/// Taylor orders by type: with steps of h |s|_max = reach, |s|_max the largest rate of the chain's modes, the first
/// term left out is reach^(order+1)/(order+1)! of the largest.
template <class Real> struct TaylorOrder { static constexpr int value = 40; };           // Quad: 7e-38
template <> struct TaylorOrder<double> { static constexpr int value = 24; };             // 2e-18
template <> struct TaylorOrder<long double> { static constexpr int value = 28; };        // 6e-23
inline constexpr double taylor_reach = 2.0;

/// A run of neighbouring contacts, some closed and some open, propagated together. With F_k = K_k x_k + C_k x_k' where
/// k is closed and 0 where it is open,
///     x_k'' = F_{k-1} - w_k F_k + F_{k+1},   w_k = 2 (1 for the wall contact, whose wall does not move),
/// a linear system with constant coefficients: its Taylor series about the step's start is exact to rounding.
template <class Real>
class TaylorGroup {
 public:
  static constexpr int order = TaylorOrder<Real>::value;

  /// `contacts` to propagate; room for them is kept between uses.
  void resize(std::size_t contacts) {
    contacts_ = contacts;
    blocks_ = (contacts + Block::count - 1) / Block::count;
    a_.resize((order + 1) * blocks_);
    if (lowest_.size() < blocks_) lowest_.resize(blocks_);
    if (force_.size() < blocks_ + 2) force_.resize(blocks_ + 2);
    for (auto* v : {&K_, &C_, &w_, &sign_}) v->assign(blocks_, Block());
  }

  /// The law of contact i of the group: its spring and dashpot if closed, and its inertia w.
  void set_law(std::size_t i, bool closed, const Real& K, const Real& C, const Real& w) {
    at(K_, i) = closed ? K : Real(0);
    at(C_, i) = closed ? C : Real(0);
    at(w_, i) = w;
    at(sign_, i) = closed ? Real(1) : Real(-1);
  }

  /// The series in t/h, t from a step's start with overlaps x and rates u: term p is x_k^(p) h^p/p!.
  void expand(std::span<const Real> x, std::span<const Real> u, const Real& h) {
    h_ = h;
    for (std::size_t b = 0; b < blocks_; ++b) {
      const std::size_t first = b * Block::count, count = std::min(Block::count, contacts_ - first);
      Block x0, u0;
      for (std::size_t i = 0; i < count; ++i) {
        x0[i] = x[first + i];
        u0[i] = u[first + i];
      }
      term(0, b) = x0;
      term(1, b) = u0 * Block(h);
    }
    if (blocks_ == 1)
      expand_one();
    else if (blocks_ == 2)
      expand_two();
    else
      expand_many();
  }

  struct Crossing {
    Real when;            ///< in units of h, 0 to 1
    std::size_t contact;  ///< which contact opens or closes
  };
  /// The first contact to change its state within the step.
  std::optional<Crossing> first_crossing() {
    for (std::size_t b = 0; b < blocks_; ++b) rule_out(b);
    std::optional<Crossing> first;
    typename FirstRoot<Real, order>::Coefficients p;
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (at(lowest_, i) > 0) continue;
      const Real sign = at(sign_, i);
      for (int n = 0; n <= order; ++n) p[std::size_t(n)] = sign * coefficient(n, i);
      // A root that rounding put just before the step's start.
      if (p[0] < 0) p[0] = 0;
      if (const auto when = FirstRoot<Real, order>::find(p); when && (!first || *when < first->when)) first = {*when, i};
    }
    return first;
  }

  /// Overlaps and rates at t = s h.
  void evaluate(const Real& s, std::span<Real> x, std::span<Real> u) const {
    for (std::size_t b = 0; b < blocks_; ++b) {
      Block value, slope;
      for (int p = order; p >= 0; --p) {
        slope = slope * Block(s) + value;
        value = value * Block(s) + term(p, b);
      }
      slope = slope * Block(1 / h_);
      const std::size_t first = b * Block::count, count = std::min(Block::count, contacts_ - first);
      for (std::size_t i = 0; i < count; ++i) {
        x[first + i] = value[i];
        u[first + i] = slope[i];
      }
    }
  }

  /// Overlap and rate of contact i at the step's start.
  ContactState<Real> start(std::size_t i) const { return {coefficient(0, i), coefficient(1, i) / h_}; }

  /// The overlap of contact i where its rate changes sign within (0, s h).
  Real deepest(std::size_t i, const Real& s) const {
    Real low = 0, high = s, t = s / 2, x = 0;
    for (int iteration = 0; iteration < 60; ++iteration) {
      Real slope = 0, half_curvature = 0;
      x = 0;
      for (int p = order; p >= 0; --p) {
        half_curvature = half_curvature * t + slope;
        slope = slope * t + x;
        x = x * t + coefficient(p, i);
      }
      (slope > 0 ? low : high) = t;
      Real next = t - slope / (2 * half_curvature);
      if (!(next > low && next < high)) next = (low + high) / 2;
      const Real change = next > t ? Real(next - t) : Real(t - next);
      if (change * change < std::numeric_limits<Real>::epsilon() * s * s) break;  // x is flat here: error change^2
      t = next;
    }
    return x;
  }

  const Real& step() const { return h_; }

 private:
  using Block = Lanes<Real>;  ///< eight neighbouring contacts
  using Blocks = std::vector<Block>;
  static constexpr int screen = 12;  ///< degree of the Bernstein polynomial that rules out most roots

  Block& term(int p, std::size_t block) { return a_[std::size_t(p) * blocks_ + block]; }
  const Block& term(int p, std::size_t block) const { return a_[std::size_t(p) * blocks_ + block]; }
  static Real& at(Blocks& v, std::size_t i) { return v[i / Block::count][i % Block::count]; }
  Real coefficient(int p, std::size_t i) const { return term(p, i / Block::count)[i % Block::count]; }

  /// What takes the terms p and p + 1 to the force's term p times h^2/((p+1)(p+2)).
  struct Weights {
    Real spring, dashpot;
  };
  Weights weights(int p) const { return {h_ * h_ / Real((p + 1) * (p + 2)), h_ / Real(p + 2)}; }

  // One and two blocks stay in registers.
  void expand_one() {
    const Block zero, K = K_[0], C = C_[0], w = w_[0];
    Block a = term(0, 0), b = term(1, 0);
    for (int p = 0; p + 2 <= order; ++p) {
      const auto [spring, dashpot] = weights(p);
      const Block f = (K * Block(spring)) * a + (C * Block(dashpot)) * b;
      a = b;
      b = shifted_up(zero, f) + shifted_down(f, zero) - w * f;
      term(p + 2, 0) = b;
    }
  }
  void expand_two() {
    const Block zero, K0 = K_[0], C0 = C_[0], w0 = w_[0], K1 = K_[1], C1 = C_[1], w1 = w_[1];
    Block a0 = term(0, 0), a1 = term(0, 1), b0 = term(1, 0), b1 = term(1, 1);
    for (int p = 0; p + 2 <= order; ++p) {
      const auto [spring, dashpot] = weights(p);
      const Block f0 = (K0 * Block(spring)) * a0 + (C0 * Block(dashpot)) * b0;
      const Block f1 = (K1 * Block(spring)) * a1 + (C1 * Block(dashpot)) * b1;
      a0 = b0;
      a1 = b1;
      b0 = shifted_up(zero, f0) + shifted_down(f0, f1) - w0 * f0;
      b1 = shifted_up(f0, f1) + shifted_down(f1, zero) - w1 * f1;
      term(p + 2, 0) = b0;
      term(p + 2, 1) = b1;
    }
  }
  void expand_many() {
    force_[0] = force_[blocks_ + 1] = Block();
    for (int p = 0; p + 2 <= order; ++p) {
      const auto [spring, dashpot] = weights(p);
      for (std::size_t b = 0; b < blocks_; ++b)
        force_[b + 1] = (K_[b] * Block(spring)) * term(p, b) + (C_[b] * Block(dashpot)) * term(p + 1, b);
      for (std::size_t b = 0; b < blocks_; ++b)
        term(p + 2, b) =
            shifted_up(force_[b], force_[b + 1]) + shifted_down(force_[b + 1], force_[b + 2]) - w_[b] * force_[b + 1];
    }
  }

  /// lowest_ > 0 where a contact cannot change its state: a lower bound of sign x_i(t) (of sign x_i(t)/t if x_i(0) = 0)
  /// from the Bernstein coefficients of the series cut at degree `screen`, less the sum of the terms beyond.
  void rule_out(std::size_t block) {
    static const auto weight = [] {
      std::array<Real, screen + 1> w;  // 1/C(screen, p)
      Real binomial = 1;
      for (int p = 0; p <= screen; ++p) {
        w[std::size_t(p)] = 1 / binomial;
        binomial = binomial * Real(screen - p) / Real(p + 1);
      }
      return w;
    }();
    Block rest;
    for (int p = screen + 1; p <= order; ++p) rest = rest + magnitude(term(p, block));
    const Block start = term(0, block), sign = sign_[block];
    std::array<Block, screen + 1> b;
#pragma GCC unroll 16
    for (int p = 0; p <= screen; ++p)
      b[std::size_t(p)] = (sign * Block(weight[std::size_t(p)])) * where_zero(start, term(p + 1, block), term(p, block));
#pragma GCC unroll 16
    for (std::size_t level = 1; level <= screen; ++level)
#pragma GCC unroll 16
      for (std::size_t p = screen; p >= level; --p) b[p] = b[p] + b[p - 1];
    Block low = b[0];
#pragma GCC unroll 16
    for (std::size_t p = 1; p <= screen; ++p) low = smaller(low, b[p]);
    lowest_[block] = low - rest;
  }

  std::size_t contacts_ = 0, blocks_ = 0;
  Real h_{};
  Blocks a_, K_, C_, w_, sign_, lowest_, force_;
};

}  // namespace sigmasweep
