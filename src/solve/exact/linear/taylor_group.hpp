#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "contact/contact_state.hpp"
#include "numerics/first_root.hpp"
#include "numerics/simd_pack.hpp"

namespace sigmasweep {

class DoubleDouble;

/// Taylor orders by type: with steps of h |s|_max = reach, |s|_max the largest rate of the chain's modes, the first
/// term left out is reach^(order+1)/(order+1)! of the largest.
template <class Real>
struct TaylorOrder {
  static constexpr int value = 40;
};  // Quad: 7e-38
template <>
struct TaylorOrder<double> {
  static constexpr int value = 24;
};  // 2e-18
template <>
struct TaylorOrder<long double> {
  static constexpr int value = 28;
};  // 6e-23
template <>
struct TaylorOrder<DoubleDouble> {
  static constexpr int value = 36;
};  // 1e-32
inline constexpr double taylor_reach = 2.0;
/// For loose tolerances: 3e-8.
inline constexpr int low_order = 14;

/// How the forces F of neighbouring contacts drive one another, in blocks of contacts. Beads of equal mass 1:
///     x_k'' = F_{k-1} - w_k F_k + F_{k+1},   w_k = 2 (1 for the wall contact, whose wall does not move).
template <class Block, bool HasUnequalMasses>
struct Coupling {
  Block w;
  Block operator()(const Block& below, const Block& F, const Block& above) const { return below + above - w * F; }
};
/// Beads of masses m_k, bead k-1 below contact k and bead k above it (1/m = 0 for the wall):
///     x_k'' = (F_{k-1} - F_k)/m_{k-1} + (F_{k+1} - F_k)/m_k.
template <class Block>
struct Coupling<Block, true> {
  Block bead_below, bead_above;  ///< 1/m
  Block operator()(const Block& below, const Block& F, const Block& above) const {
    return bead_below * (below - F) + bead_above * (above - F);
  }
};

/// A run of neighbouring contacts, some closed and some open, propagated together. With F_k = K_k x_k + C_k x_k' where
/// k is closed and 0 where it is open, and coupled as above, they are a linear system with constant coefficients: its
/// Taylor series about the step's start is exact to rounding.
/// Several motions go through the same maps side by side: the column's own, number 0, and `Tangents` linearised
/// disturbances of it. Driven: the first contact of the column's own motion may be accelerated from outside, too.
template <class Real, int Tangents, bool HasUnequalMasses = false, int Order = TaylorOrder<Real>::value,
          bool Driven = false>
class TaylorGroup {
 public:
  static constexpr int order = Order, motions = 1 + Tangents;
  /// Two digits of a disturbance are enough for an error bar: reach^11/11! = 5e-5.
  static constexpr int disturbed_order = std::min(Order, 10);

  /// `contacts` to propagate; room for them is kept between uses.
  void resize(std::size_t contacts) {
    contacts_ = contacts;
    blocks_ = (contacts + Block::count - 1) / Block::count;
    a_.resize((order + 1) * motions * blocks_);
    for (auto* v : {&suspect_, &examined_, &highest_})
      if (v->size() < blocks_) v->resize(blocks_);
    if (force_.size() < motions * (blocks_ + 2)) force_.resize(motions * (blocks_ + 2));
    for (auto* v : {&K_, &C_, &sign_}) v->assign(blocks_, Block());
    coupling_.assign(blocks_, {});
  }

  /// The law of contact i of the group: its spring and dashpot if closed, and its inertia w.
  void set_law(std::size_t i, bool closed, const Real& K, const Real& C, const Real& w) requires(!HasUnequalMasses) {
    set_force(i, closed, K, C);
    coupling_[i / Block::count].w[i % Block::count] = w;
  }
  /// The same with 1/m of the beads below (0: the wall) and above.
  void set_law(std::size_t i, bool closed, const Real& K, const Real& C, const Real& below,
               const Real& above) requires HasUnequalMasses {
    set_force(i, closed, K, C);
    coupling_[i / Block::count].bead_below[i % Block::count] = below;
    coupling_[i / Block::count].bead_above[i % Block::count] = above;
  }

  /// Where a motion starts the step of at most h: overlaps x and rates u.
  void start(int motion, std::span<const Real> x, std::span<const Real> u, const Real& h) {
    if (motion == 0) live_ = 0;
    for (std::size_t b = 0; b < blocks_; ++b) {
      const std::size_t first = b * Block::count, count = std::min(Block::count, contacts_ - first);
      Block x0, u0;
      bool rests = true;
      for (std::size_t i = 0; i < count; ++i) {
        x0[i] = x[first + i];
        u0[i] = u[first + i];
        rests = rests && x0[i] == 0 && u0[i] == 0;
      }
      if (!rests) live_ = std::max(live_, b + 1);
      term(0, motion, b) = x0;
      term(1, motion, b) = u0 * Block(h);
    }
  }

  /// Term p, for p = 0 to order - 2, of what accelerates contact 0 besides the contacts' forces, in t/h: sum_p
  /// terms[p] (t/h)^p. Without terms: nothing.
  void drive(std::span<const Real> terms, const Real& h) requires Driven {
    for (std::size_t p = 0; p < drive_.size(); ++p)
      drive_[p][0] = terms.empty() ? Real(0) : terms[p] * h * h / Real((p + 1) * (p + 2));
  }

  /// The series in t/h, t from the step's start: term p is x_k^(p) h^p/p!.
  void expand(const Real& h) {
    h_ = h;
    live_ = blocks_ <= 2 ? blocks_ : std::min(blocks_, live_ + halo);
    if (blocks_ == 1)
      expand_in_registers<1>();
    else if (blocks_ == 2)
      expand_in_registers<2>();
    else
      expand_many();
  }

  struct Crossing {
    Real when;            ///< in units of h, 0 to 1
    std::size_t contact;  ///< which contact opens or closes
  };
  /// The first contact to change its state within the step. Of the contacts that cannot be ruled out the one that
  /// seems to be first is looked at closely; its root bounds the interval in which the others must be ruled out.
  std::optional<Crossing> first_crossing() {
    for (std::size_t b = 0; b < live_; ++b) examined_[b] = Block();
    std::optional<Crossing> first;
    Real limit = 1;
    for (bool shorter = true;;) {
      if (shorter)
        for (std::size_t b = 0; b < live_; ++b) rule_out(b, limit);
      std::size_t candidate = 0;
      Real earliest = never;
      for (std::size_t i = 0, n = std::min(contacts_, live_ * Block::count); i < n; ++i)
        if (at(suspect_, i) < earliest) {
          earliest = at(suspect_, i);
          candidate = i;
        }
      if (earliest == Real(never)) return first;
      at(suspect_, candidate) = Real(never);
      at(examined_, candidate) = Real(1);
      const auto when = FirstRoot<Real, order>::find(distance(candidate), limit);
      shorter = when.has_value();
      if (!when) continue;
      first = {*when, candidate};
      limit = *when;
      if (limit == Real(0)) return first;
    }
  }

  /// Overlaps and rates at t = s h.
  void evaluate(int motion, const Real& s, std::span<Real> x, std::span<Real> u) const {
    const std::size_t moving = std::min(contacts_, live_ * Block::count);
    std::fill(x.begin() + std::ptrdiff_t(moving), x.begin() + std::ptrdiff_t(contacts_), Real(0));
    std::fill(u.begin() + std::ptrdiff_t(moving), u.begin() + std::ptrdiff_t(contacts_), Real(0));
    for (std::size_t b = 0; b < live_; ++b) {
      Block value, slope;
      for (int p = motion == 0 ? order : disturbed_order; p >= 0; --p) {
        slope = slope * Block(s) + value;
        value = value * Block(s) + term(p, motion, b);
      }
      slope = slope / Block(h_);  // not times 1/h: that would be off the same way at every step
      const std::size_t first = b * Block::count, count = std::min(Block::count, contacts_ - first);
      for (std::size_t i = 0; i < count; ++i) {
        x[first + i] = value[i];
        u[first + i] = slope[i];
      }
    }
  }

  /// Overlap and rate of contact i at the step's start.
  ContactState<Real> start(std::size_t i) const { return {coefficient(0, i), coefficient(1, i) / h_}; }

  /// How large the leading terms of contact i's overlap and rate at t = s h are: what their rounding errors scale with.
  ContactState<Real> magnitude_of(std::size_t i, const Real& s) const {
    using std::abs;
    if (i >= live_ * Block::count) return {};
    const Real a0 = abs(coefficient(0, i)), a1 = abs(coefficient(1, i)) * s, a2 = abs(coefficient(2, i)) * s * s;
    const Real a3 = abs(coefficient(3, i)) * s * s * s;
    return {a0 + a1 + a2 + a3, (a1 + 2 * a2 + 3 * a3) / (s * h_)};
  }

  /// The largest of `known` and the overlap of contact i within [0, s h]. Its rate is looked at in a few places, and
  /// where it goes from positive to negative between two of them the overlap's maximum is located. After
  /// first_crossing(), which bounds the overlaps from above: few need the look.
  Real deepest(std::size_t i, const Real& s, const Real& known) const {
    if (i >= live_ * Block::count || !(at(highest_, i) > known)) return known;
    constexpr int places = 4;
    Real largest = known, before = 0;
    Jet at_before = jet(i, before);
    for (int place = 1; place <= places; ++place) {
      const Real here = s * Real(place) / Real(places);
      const Jet at_here = jet(i, here);
      largest = std::max(largest, at_here.x);
      if (at_before.slope > 0 && at_here.slope < 0) largest = std::max(largest, maximum(i, before, here));
      before = here;
      at_before = at_here;
    }
    return largest;
  }

  const Real& step() const { return h_; }

  /// The first term that the series leave out, of the largest: reach^(order+1)/(order+1)!.
  static Real left_out() {
    Real term = 1;
    for (int n = 1; n <= order + 1; ++n) term *= Real(taylor_reach) / Real(n);
    return term;
  }

 private:
  using Block = SimdPack<Real>;  ///< eight neighbouring contacts
  using Blocks = std::vector<Block>;
  static constexpr int screen = 12;  ///< degree of the Bernstein polynomial that rules out most roots
  static constexpr double never = 1e9;
  /// Blocks that a motion can reach within a step: each term of the series brings it one contact on.
  static constexpr std::size_t halo = (order + Block::count - 1) / Block::count;

  Block& term(int p, int motion, std::size_t block) { return a_[std::size_t(p * motions + motion) * blocks_ + block]; }
  const Block& term(int p, int motion, std::size_t block) const {
    return a_[std::size_t(p * motions + motion) * blocks_ + block];
  }
  void set_force(std::size_t i, bool closed, const Real& K, const Real& C) {
    at(K_, i) = closed ? K : Real(0);
    at(C_, i) = closed ? C : Real(0);
    at(sign_, i) = closed ? Real(1) : Real(-1);
  }
  static Real& at(Blocks& v, std::size_t i) { return v[i / Block::count][i % Block::count]; }
  static Real at(const Blocks& v, std::size_t i) { return v[i / Block::count][i % Block::count]; }
  Real coefficient(int p, std::size_t i) const { return term(p, 0, i / Block::count)[i % Block::count]; }

  /// What takes the terms p and p + 1 to the force's term p times h^2/((p+1)(p+2)).
  struct Weights {
    Real spring, dashpot;
  };
  Weights weights(int p) const { return {h_ * h_ / Real((p + 1) * (p + 2)), h_ / Real(p + 2)}; }

  template <int InRegisters>
  void expand_in_registers() {
    constexpr int chains = motions * InRegisters;  // chain c: motion c / InRegisters, block c % InRegisters
    const Block zero;
    std::array<Block, InRegisters> K, C;
    std::array<Coupling<Block, HasUnequalMasses>, InRegisters> coupling;
    std::array<Block, chains> a, b, f;
    for (int r = 0; r < InRegisters; ++r) {
      K[r] = K_[r];
      C[r] = C_[r];
      coupling[r] = coupling_[r];
    }
    for (int c = 0; c < chains; ++c) {
      a[c] = term(0, c / InRegisters, c % InRegisters);
      b[c] = term(1, c / InRegisters, c % InRegisters);
    }
    const auto next_terms = [&](int p, auto first) {
      constexpr int these = decltype(first)::value;
      const auto [spring, dashpot] = weights(p);
      SIGMASWEEP_UNROLL
      for (int c = 0; c < these; ++c)
        f[c] = (K[c % InRegisters] * Block(spring)) * a[c] + (C[c % InRegisters] * Block(dashpot)) * b[c];
      SIGMASWEEP_UNROLL
      for (int c = 0; c < these; ++c) {
        const int r = c % InRegisters;
        a[c] = b[c];
        b[c] = coupling[r](shifted_up(r > 0 ? f[c - (r > 0)] : zero, f[c]), f[c],
                           shifted_down(f[c], r + 1 < InRegisters ? f[c + (r + 1 < InRegisters)] : zero));
        if constexpr (Driven)
          if (c == 0) b[c] = b[c] + drive_[std::size_t(p)];
        term(p + 2, c / InRegisters, r) = b[c];
      }
    };
    int p = 0;
    for (; p + 2 <= disturbed_order; ++p) next_terms(p, std::integral_constant<int, chains>());
    for (; p + 2 <= order; ++p) next_terms(p, std::integral_constant<int, InRegisters>());
  }
  void expand_many() {
    const std::size_t stride = blocks_ + 2;
    for (int m = 0; m < motions; ++m) force_[m * stride] = force_[m * stride + live_ + 1] = Block();
    for (int p = 0; p + 2 <= order; ++p) {
      const auto [spring, dashpot] = weights(p);
      for (int m = 0; m < (p + 2 <= disturbed_order ? motions : 1); ++m) {
        Block* const f = force_.data() + m * stride + 1;
        for (std::size_t b = 0; b < live_; ++b)
          f[b] = (K_[b] * Block(spring)) * term(p, m, b) + (C_[b] * Block(dashpot)) * term(p + 1, m, b);
        for (std::size_t b = 0; b < live_; ++b)
          term(p + 2, m, b) = coupling_[b](shifted_up(f[b - 1], f[b]), f[b], shifted_down(f[b], f[b + 1]));
        if constexpr (Driven)
          if (m == 0) term(p + 2, 0, 0) = term(p + 2, 0, 0) + drive_[std::size_t(p)];
      }
    }
  }

  struct Jet {
    Real x{}, slope{}, half_curvature{};
  };
  Jet jet(std::size_t i, const Real& t) const {
    Jet j;
    for (int p = order; p >= 0; --p) {
      j.half_curvature = j.half_curvature * t + j.slope;
      j.slope = j.slope * t + j.x;
      j.x = j.x * t + coefficient(p, i);
    }
    return j;
  }

  /// The overlap of contact i where its rate changes from positive at `low` to negative at `high`.
  Real maximum(std::size_t i, Real low, Real high) const {
    const Real width = high - low;
    Real t = (low + high) / 2;
    for (int iteration = 0;; ++iteration) {
      const Jet j = jet(i, t);
      (j.slope > 0 ? low : high) = t;
      Real next = t - j.slope / (2 * j.half_curvature);
      if (!(next > low && next < high)) next = (low + high) / 2;
      const Real change = next - t;  // x is flat here: its error is change^2
      if (iteration == 60 || change * change < std::numeric_limits<Real>::epsilon() * width * width) return j.x;
      t = next;
    }
  }

  /// sign x_i(t) as a polynomial in t/h: what must stay positive for contact i to stay as it is.
  typename FirstRoot<Real, order>::Coefficients distance(std::size_t i) {
    typename FirstRoot<Real, order>::Coefficients p;
    const Real sign = at(sign_, i);
    for (int n = 0; n <= order; ++n) p[std::size_t(n)] = sign * coefficient(n, i);
    if (p[0] < 0) p[0] = 0;  // a root that rounding put just before the step's start
    return p;
  }

  /// suspect_ = never where a contact cannot change its state on [0, limit h]: the Bernstein coefficients of sign
  /// x_i(t) (of sign x_i(t)/t if x_i(0) = 0), cut at degree `screen`, all exceed the sum of the terms beyond. Elsewhere
  /// the index of the first coefficient that does not.
  void rule_out(std::size_t block, const Real& limit) {
    static const auto weight = [] {
      std::array<Real, screen + 1> w;  // 1/C(screen, p)
      Real binomial = 1;
      for (int p = 0; p <= screen; ++p) {
        w[std::size_t(p)] = 1 / binomial;
        binomial = binomial * Real(screen - p) / Real(p + 1);
      }
      return w;
    }();
    const Block start = term(0, 0, block), sign = sign_[block];
    std::array<Block, screen + 1> b;
    Real power = 1;
    for (int p = 0; p <= screen; ++p) {
      b[std::size_t(p)] =
          (sign * Block(weight[std::size_t(p)] * power)) * where_zero(start, term(p + 1, 0, block), term(p, 0, block));
      power *= limit;
    }
    Block rest;
    for (int p = screen + 1; p <= order; ++p) rest = rest + magnitude(term(p, 0, block));
    rest = rest * Block(power / limit);  // limit^p <= limit^screen
    SIGMASWEEP_UNROLL
    for (std::size_t level = 1; level <= screen; ++level) SIGMASWEEP_UNROLL
    for (std::size_t p = screen; p >= level; --p) b[p] = b[p] + b[p - 1];
    if (limit == Real(1)) {  // the same coefficients bound a closed contact's overlap (of x(t)/t >= x(t)) from above
      Block highest = b[0];
      for (std::size_t p = 1; p <= screen; ++p) highest = where_above(highest, b[p], highest, b[p]);
      highest_[block] = highest + rest;
    }
    Block suspect{Real(never)};
    for (std::size_t p = screen + 1; p-- > 0;) suspect = where_above(b[p], rest, suspect, Block(Real(double(p))));
    suspect_[block] = where_zero(examined_[block], suspect, Block(Real(never)));
  }

  std::size_t contacts_ = 0, blocks_ = 0;
  std::size_t live_ = 0;  ///< blocks from here on rest during this step, in touch, not reached by the motion below
  Real h_{};
  Blocks a_, K_, C_, sign_, suspect_, examined_, highest_, force_;
  std::vector<Coupling<Block, HasUnequalMasses>> coupling_;
  std::array<Block, Driven ? order - 1 : 0> drive_;
};

}  // namespace sigmasweep
