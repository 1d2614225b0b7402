#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "contact_state.hpp"
#include "first_root.hpp"

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
  static constexpr int screen = 12;  ///< degree of the Bernstein polynomial that rules out most roots
  using Root = FirstRoot<Real, order>;

  /// `contacts` to propagate; room for them is kept between uses.
  void resize(std::size_t contacts) {
    contacts_ = contacts;
    width_ = (contacts + lanes - 1) / lanes * lanes;
    a_.resize((order + 1) * width_);
    for (auto* v : {&K_, &C_, &w_, &sign_, &rest_, &lowest_}) v->assign(width_, Real(0));
    force_.assign(width_ + 2 * lanes, Real(0));
    bernstein_.resize((screen + 1) * width_);
  }
  std::size_t size() const { return contacts_; }

  /// Contact i of the group: its law if closed, its inertia w, its overlap and rate at the start of the step.
  void set(std::size_t i, bool closed, const Real& K, const Real& C, const Real& w, const Real& x, const Real& u) {
    K_[i] = closed ? K : Real(0);
    C_[i] = closed ? C : Real(0);
    w_[i] = w;
    sign_[i] = closed ? Real(1) : Real(-1);
    a_[i] = x;
    a_[width_ + i] = u;
  }

  /// The series in t/h, t from the step's start: row p holds x_k^(p) h^p/p!.
  void expand(const Real& h) {
    h_ = h;
    Real* const f = force_.data() + lanes;
    for (std::size_t i = 0; i < width_; ++i) a_[width_ + i] *= h;
    for (int p = 0; p + 2 <= order; ++p) {
      const Real spring = h * h / Real((p + 1) * (p + 2)), dashpot = h / Real(p + 2);
      const Real* const a0 = row(p);
      const Real* const a1 = row(p + 1);
      Real* const a2 = row(p + 2);
      for (std::size_t i = 0; i < width_; ++i) f[i] = K_[i] * (spring * a0[i]) + C_[i] * (dashpot * a1[i]);
      for (std::size_t i = 0; i < width_; ++i) a2[i] = f[std::ptrdiff_t(i) - 1] + f[i + 1] - w_[i] * f[i];
    }
  }

  struct Crossing {
    Real when;            ///< in units of h, 0 to 1
    std::size_t contact;  ///< which contact opens or closes
  };
  /// The first contact to change its state within the step.
  std::optional<Crossing> first_crossing() {
    rule_out();
    std::optional<Crossing> first;
    std::array<Real, order + 1> p;
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (lowest_[i] > 0) continue;
      for (int n = 0; n <= order; ++n) p[std::size_t(n)] = sign_[i] * row(n)[i];
      // A root that rounding put just before the step's start.
      if (p[0] < 0) p[0] = 0;
      if (const auto when = Root::find(p); when && (!first || *when < first->when)) first = {*when, i};
    }
    return first;
  }

  /// Overlaps and rates at t = s h.
  void evaluate(const Real& s, std::span<Real> x, std::span<Real> u) const {
    value_.assign(width_, Real(0));
    slope_.assign(width_, Real(0));
    Real* const value = value_.data();
    Real* const slope = slope_.data();
    for (int p = order; p >= 0; --p) {
      const Real* const a = row(p);
      for (std::size_t i = 0; i < width_; ++i) {
        slope[i] = slope[i] * s + value[i];
        value[i] = value[i] * s + a[i];
      }
    }
    for (std::size_t i = 0; i < contacts_; ++i) {
      x[i] = value[i];
      u[i] = slope[i] / h_;
    }
  }

  /// Overlap and rate of contact i at the step's start.
  ContactState<Real> start(std::size_t i) const { return {row(0)[i], row(1)[i] / h_}; }

  /// The overlap of contact i where its rate changes sign within (0, s h).
  Real deepest(std::size_t i, const Real& s) const {
    Real low = 0, high = s, t = s / 2, x = 0;
    for (int iteration = 0; iteration < 60; ++iteration) {
      Real slope = 0, half_curvature = 0;
      x = 0;
      for (int p = order; p >= 0; --p) {
        half_curvature = half_curvature * t + slope;
        slope = slope * t + x;
        x = x * t + row(p)[i];
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
  static constexpr std::size_t lanes = 8;
  Real* row(int p) { return a_.data() + std::size_t(p) * width_; }
  const Real* row(int p) const { return a_.data() + std::size_t(p) * width_; }

  /// lowest_[i] > 0 where contact i cannot change its state: a lower bound of sign x_i(t) from the Bernstein
  /// coefficients of the series cut at degree `screen`, less the sum of the terms beyond.
  void rule_out() {
    Real* const low = lowest_.data();
    Real* const rest = rest_.data();
    std::fill(rest_.begin(), rest_.end(), Real(0));
    for (int p = screen + 1; p <= order; ++p) {
      const Real* const a = row(p);
      for (std::size_t i = 0; i < width_; ++i) rest[i] += a[i] < 0 ? -a[i] : a[i];
    }
    Real binomial = 1;
    for (int p = 0; p <= screen; ++p) {
      const Real* const a = row(p);
      Real* const b = bernstein_.data() + std::size_t(p) * width_;
      const Real factor = 1 / binomial;
      for (std::size_t i = 0; i < width_; ++i) b[i] = sign_[i] * a[i] * factor;
      binomial = binomial * Real(screen - p) / Real(p + 1);
    }
    for (int level = 1; level <= screen; ++level)
      for (int p = screen; p >= level; --p) {
        Real* const b = bernstein_.data() + std::size_t(p) * width_;
        const Real* const below = b - width_;
        for (std::size_t i = 0; i < width_; ++i) b[i] += below[i];
      }
    std::copy(bernstein_.begin(), bernstein_.begin() + std::ptrdiff_t(width_), lowest_.begin());
    for (int p = 1; p <= screen; ++p) {
      const Real* const b = bernstein_.data() + std::size_t(p) * width_;
      for (std::size_t i = 0; i < width_; ++i) low[i] = b[i] < low[i] ? b[i] : low[i];
    }
    for (std::size_t i = 0; i < width_; ++i) low[i] -= rest[i];
  }

  std::size_t contacts_ = 0, width_ = 0;
  Real h_{};
  std::vector<Real> a_, K_, C_, w_, sign_, force_, rest_, lowest_, bernstein_;
  mutable std::vector<Real> value_, slope_;
};

}  // namespace sigmasweep
