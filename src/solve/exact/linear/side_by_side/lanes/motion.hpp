#pragma once

#include <cfloat>

#include "solve/exact/linear/side_by_side/lanes/series.hpp"

namespace sigmasweep::side_by_side {

/// Root mean square of a rounding error, in units of the last place, is that of a uniform number: a sign times this.
inline constexpr double rounding = 0.57735 * DBL_EPSILON;

/// Contact k of lane l closes or opens at overlap exactly 0. A disturbed column does so earlier or later by -dx_k/u_k,
/// and for so long feels, or lacks, the force C u_k: its rates jump by what that does.
template <int W>
SIGMASWEEP_LANEWISE void change_contact(Columns<W>& c, int k, int l) {
  const double handed_on = (k == 0 ? c.wall_dashpot[l] : c.dashpot[l]) * c.dx[k][l];
  const double impulse = c.closed[k][l] ? -handed_on : handed_on;
  c.du[k][l] -= k == 0 ? impulse : impulse + impulse;
  if (k > 0) c.du[k - 1][l] += impulse;
  if (k + 1 < c.N) c.du[k + 1][l] += impulse;
  c.x[k][l] = 0.0;
  c.closed[k][l] = ~c.closed[k][l];
  c.closed_bits[l] ^= std::uint64_t(1) << k;
  if (c.closed[k][l]) return;
  ++c.contacts[l];
  if (k == 0) c.wall_opened[l] = c.clock[l];
}

/// Random signs: bit j of each lane's word, times `size`.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> signed_by(typename Vectors<W>::Bits words, int j, Pack<W> size) {
  return negated_where(Mask<W>{words << j}, size);
}

/// Rounding may leave a contact on the wrong side of 0.
template <int W>
SIGMASWEEP_LANEWISE void put_right(Columns<W>& c) {
  using P = Pack<W>;
  const P zero(0.0);
  for (int k = 0; k < c.N; ++k) {
    const P x = P::load(c.x[k]);
    const Mask<W> closed = Mask<W>::load(c.closed[k]);
    const Mask<W> wrong = (closed & (x < zero)) | (~closed & (x > zero));
    select(wrong, zero, x).store(c.x[k]);
  }
}

/// Where nothing touches all gaps fly uniformly, until the first of them closes.
template <int W>
[[gnu::noinline]] void fly(Columns<W>& c, Mask<W> free) {
  using P = Pack<W>;
  const P zero(0.0), never(__builtin_inf());
  P first = never, contact(0.0);
  for (int k = 0; k < c.N; ++k) {
    const P u = P::load(c.u[k]);
    const P when = select(u > zero, (zero - P::load(c.x[k])) / u, never);
    contact = select(when < first, P(double(k)), contact);
    first = least(when, first);
  }
  const Mask<W> flies = free & (first < never), ends = free & ~flies;
  const P t = where(flies, first);
  typename Vectors<W>::Bits words;
  __builtin_memcpy(&words, c.noise, sizeof words);
  for (int k = 0; k < c.N; ++k) {
    const P x = P::load(c.x[k]), u = P::load(c.u[k]), way = u * t;
    const P rounded = where(flies, signed_by<W>(words, 2 * k, P(rounding) * (magnitude(x) + magnitude(way))));
    (x + way).store(c.x[k]);
    (fma(P::load(c.du[k]), t, P::load(c.dx[k])) + rounded).store(c.dx[k]);
  }
  (P::load(c.clock) + t).store(c.clock);
  (Mask<W>::load(c.separated) | ends).store(c.separated);
  (Mask<W>::load(c.active) & ~ends).store(c.active);
  double contacts[W];
  contact.store(contacts);
  const unsigned lanes = lanes_of(flies);
  for (int l = 0; l < W; ++l)
    if (lanes >> l & 1) change_contact(c, int(contacts[l]), l);
}

/// The largest of x_max and the overlap of contact k within [0, s]. Its rate is looked at in four places, and where it
/// goes from positive to negative between two of them the maximum is located; x is flat there, so that Newton's method
/// has all digits after few iterations.
template <int W>
[[gnu::noinline]] void look_for_deepest(Columns<W>& c, int k, Pack<W> s, Mask<W> wanted) {
  using P = Pack<W>;
  const P zero(0.0);
  P largest = P::load(c.x_max), before(0.0), slope_before = P::load(c.a[c.N + k]);
  for (int place = 1; place <= 4; ++place) {
    const P here = s * P(0.25 * place);
    const Jet<W> at_here = jet<W, order>(c.a, c.N, k, here);
    largest = select(wanted, most(at_here.x, largest), largest);
    const Mask<W> turns = wanted & (slope_before > zero) & (at_here.slope < zero);
    if (any(turns)) {
      P t = before + (here - before) * (slope_before / (slope_before - at_here.slope));
      for (int iteration = 0; iteration < 6; ++iteration) {
        P value(0.0), slope(0.0), curvature(0.0);
        for (int p = order; p >= 0; --p) {
          curvature = fma(curvature, t, slope);
          slope = fma(slope, t, value);
          value = fma(value, t, P::load(c.a[p * c.N + k]));
        }
        largest = select(turns, most(value, largest), largest);
        const P next = t - slope / (curvature + curvature);
        t = select((next > before) & (next < here), next, t);
      }
    }
    before = here;
    slope_before = at_here.slope;
  }
  largest.store(c.x_max);
}

/// Where contact k, which flies uniformly, gets within s, and the disturbance.
template <int W>
struct Flown {
  Pack<W> x, u, dx, du;
  Pack<W> of_x, of_u;  ///< the leading terms' size, with which rounding errors scale
};
template <int W>
SIGMASWEEP_LANEWISE Flown<W> flown(const Columns<W>& c, int k, Pack<W> s) {
  using P = Pack<W>;
  const P x = P::load(c.x[k]), u = P::load(c.u[k]), du = P::load(c.du[k]);
  return {fma(u, s, x), u, fma(du, s, P::load(c.dx[k])), du, magnitude(x) + magnitude(u) * s, magnitude(u)};
}
/// The same of a contact by its series.
template <int W>
SIGMASWEEP_LANEWISE Flown<W> flown_in_series(const Columns<W>& c, int k, Pack<W> s) {
  using P = Pack<W>;
  const int N = c.N;
  const Jet<W> now = jet<W, order>(c.a, N, k, s), disturbance = jet<W, disturbed_order>(c.d, N, k, s);
  const P s2 = s * s, u = magnitude(P::load(c.a[N + k])), a2 = magnitude(P::load(c.a[2 * N + k])),
          a3 = magnitude(P::load(c.a[3 * N + k]));
  const P of_x = (magnitude(P::load(c.a[k])) + u * s) + fma(a2, s2, a3 * (s2 * s));
  return {now.x, now.slope, disturbance.x, disturbance.slope, of_x, fma(s, fma(P(2.0), a2, P(3.0) * (s * a3)), u)};
}

template <int W>
SIGMASWEEP_LANEWISE void put_down(Columns<W>& c, int k, const Flown<W>& now, typename Vectors<W>::Bits words,
                                  Mask<W> moves) {
  using P = Pack<W>;
  now.x.store(c.x[k]);
  now.u.store(c.u[k]);
  (now.dx + where(moves, signed_by<W>(words, 2 * k, P(rounding) * now.of_x))).store(c.dx[k]);
  (now.du + where(moves, signed_by<W>(words, 2 * k + 1, P(rounding) * now.of_u))).store(c.du[k]);
}

/// All contacts to the end of the step.
template <int W>
SIGMASWEEP_LANEWISE void move(Columns<W>& c) {
  using P = Pack<W>;
  const Mask<W> active = Mask<W>::load(c.active);
  const P s = P::load(c.length);
  const Mask<W> moves = active & (s > P(0.0));
  typename Vectors<W>::Bits words;
  __builtin_memcpy(&words, c.noise, sizeof words);
  int k = 0;
  for (int r = 0; r <= c.run_count; ++r) {
    const int first = r < c.run_count ? c.runs[r].first : c.N;
    for (; k < first; ++k) put_down<W>(c, k, flown<W>(c, k, s), words, moves);
    if (r == c.run_count) break;
    for (; k <= c.runs[r].last; ++k) {
      const Mask<W> deeper = active & Mask<W>::load(c.closed[k]) & (P::load(c.highest[k]) > P::load(c.x_max));
      if (any(deeper)) look_for_deepest(c, k, s, deeper);
      put_down<W>(c, k, flown_in_series<W>(c, k, s), words, moves);
    }
  }
  (P::load(c.clock) + where(active, s)).store(c.clock);
}

}  // namespace sigmasweep::side_by_side
