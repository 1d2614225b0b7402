#pragma once

#include <cfloat>

#include "solve/exact/linear/side_by_side/lanes/series.hpp"

namespace sigmasweep::side_by_side {

/// Root mean square of a rounding error, in units of the last place, is that of a uniform number: a sign times this.
/// The unit of the disturbances.
inline constexpr double rounding = 0.57735 * DBL_EPSILON;

/// Contact k of lane l closes or opens at overlap exactly 0. A disturbed column does so earlier or later by -dx_k/u_k,
/// and for so long feels, or lacks, the force C u_k: its rates jump by what that does.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void change_contact(Columns<W, HasUnequalMasses>& c, int k, int l) {
  const double below = k > 0 ? c.inverse_mass[k - 1][l] : 0.0, above = c.inverse_mass[k][l];
  const bool closes = !c.closed[k][l];
  for (int place = l; place < disturbances * W; place += W) {
    const auto handed_on = static_cast<float>(c.dashpot[k][l]) * c.d[0][k][place];
    const float impulse = closes ? handed_on : -handed_on;
    c.d[1][k][place] -= static_cast<float>(below + above) * impulse;
    if (k > 0) c.d[1][k - 1][place] += static_cast<float>(below) * impulse;
    if (k + 1 < c.N) c.d[1][k + 1][place] += static_cast<float>(above) * impulse;
    c.disturbed_spring[k][place] = closes ? static_cast<float>(c.spring[k][l]) : 0.0F;
    c.disturbed_dashpot[k][place] = closes ? static_cast<float>(c.dashpot[k][l]) : 0.0F;
  }
  c.a[0][k][l] = 0.0;
  c.closed[k][l] = closes ? -1 : 0;
  c.closed_bits[l] ^= std::uint64_t(1) << k;
  c.acting_spring[k][l] = closes ? c.spring[k][l] : 0.0;
  c.acting_dashpot[k][l] = closes ? c.dashpot[k][l] : 0.0;
  if (closes) return;
  ++c.contacts[l];
  if (k == 0) c.wall_opened[l] = c.clock[l];
}

/// Random signs of the disturbances of contact k's overlap (0) and rate (1), times `size`, which is a lane's.
template <int W, class Columns>
SIGMASWEEP_LANEWISE Pairs<W> signed_at_random(const Columns& c, int k, int which, Pack<W> size) {
  const auto words = PairsMask<W>::load(c.noise[which][k / 32]);
  return negated_where(PairsMask<W>{words.v << k % 32}, in_pairs(size));
}

/// Rounding may leave a contact on the wrong side of 0.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> put_right(Pack<W> x, Mask<W> closed) {
  return negated_where(~closed, most(negated_where(~closed, x), Pack<W>(0.0)));
}

/// Where nothing touches all gaps fly uniformly, until the first of them closes.
template <int W, bool HasUnequalMasses>
[[gnu::noinline]] void fly(Columns<W, HasUnequalMasses>& c, Mask<W> free) {
  using P = Pack<W>;
  const P zero(0.0), never(__builtin_inf());
  P first = never, contact(0.0);
  for (int k = 0; k < c.N; ++k) {
    const P u = P::load(c.a[1][k]);
    const P when = select(u > zero, (zero - P::load(c.a[0][k])) / u, never);
    contact = select(when < first, P(double(k)), contact);
    first = least(when, first);
  }
  const Mask<W> flies = free & (first < never), ends = free & ~flies;
  const P t = where(flies, first);
  const Pairs<W> time = in_pairs(t);
  for (int k = 0; k < c.N; ++k) {
    const P x = P::load(c.a[0][k]), way = P::load(c.a[1][k]) * t;
    select(flies, least(x + way, zero), x).store(c.a[0][k]);
    const Pairs<W> rounded = signed_at_random<W>(c, k, 0, where(flies, magnitude(x) + magnitude(way)));
    (fma(Pairs<W>::load(c.d[1][k]), time, Pairs<W>::load(c.d[0][k])) + rounded).store(c.d[0][k]);
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
/// goes from positive to negative between two of them the maximum is located; x is flat there, so that it has all
/// digits where Newton's method has half of them: after three iterations.
template <int W, bool HasUnequalMasses>
[[gnu::noinline]] void look_for_deepest(Columns<W, HasUnequalMasses>& c, int k, Pack<W> s, Mask<W> wanted) {
  using P = Pack<W>;
  const P zero(0.0);
  P largest = P::load(c.x_max), before(0.0), slope_before = P::load(c.a[1][k]);
  for (int place = 1; place <= 4; ++place) {
    const P here = s * P(0.25 * place);
    const Jet<P> at_here = Taylor<order, P>(here).jet(c.a, k);
    largest = select(wanted, most(at_here.x, largest), largest);
    const Mask<W> turns = wanted & (slope_before > zero) & (at_here.slope < zero);
    if (any(turns)) {
      P t = before + (here - before) * (slope_before / (slope_before - at_here.slope));
      for (int iteration = 0; iteration < 3; ++iteration) {
        const Taylor<order, P> taylor(t);
        const Jet<P> now = taylor.jet(c.a, k);
        largest = select(turns, most(now.x, largest), largest);
        const P next = t - now.slope / taylor.curvature(c.a, k);
        t = select((next > before) & (next < here), next, t);
      }
    }
    before = here;
    slope_before = at_here.slope;
  }
  largest.store(c.x_max);
}

/// Contact k flies uniformly for a time s, and its disturbances.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void fly_on(Columns<W, HasUnequalMasses>& c, int k, Pack<W> s, Pairs<W> time, Mask<W> moves) {
  using P = Pack<W>;
  const P x = P::load(c.a[0][k]), u = P::load(c.a[1][k]);
  const Pairs<W> dx = Pairs<W>::load(c.d[0][k]), du = Pairs<W>::load(c.d[1][k]);
  put_right(fma(u, s, x), Mask<W>::load(c.closed[k])).store(c.a[0][k]);
  const P of_x = where(moves, magnitude(x) + magnitude(u) * s);
  (fma(du, time, dx) + signed_at_random<W>(c, k, 0, of_x)).store(c.d[0][k]);
  (du + signed_at_random<W>(c, k, 1, where(moves, magnitude(u)))).store(c.d[1][k]);
}

/// Contact k goes on by its series. Rounding errors scale with the leading terms.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void go_on(Columns<W, HasUnequalMasses>& c, int k, const Taylor<order, Pack<W>>& taylor,
                               const Taylor<disturbed_order, Pairs<W>>& disturbed, Mask<W> moves) {
  using P = Pack<W>;
  const Jet<P> now = taylor.jet(c.a, k);
  const Jet<Pairs<W>> disturbance = disturbed.jet(c.d, k);
  const P s = taylor.over[1], x = magnitude(P::load(c.a[0][k])), u = magnitude(P::load(c.a[1][k]));
  const P bent = s * magnitude(P::load(c.a[2][k])), twisted = s * taylor.over[2] * magnitude(P::load(c.a[3][k]));
  const P of_x = fma(s, fma(P(0.5), bent, fma(P(1.0 / 3.0), twisted, u)), x), of_u = u + (bent + twisted);
  put_right(now.x, Mask<W>::load(c.closed[k])).store(c.a[0][k]);
  now.slope.store(c.a[1][k]);
  (disturbance.x + signed_at_random<W>(c, k, 0, where(moves, of_x))).store(c.d[0][k]);
  (disturbance.slope + signed_at_random<W>(c, k, 1, where(moves, of_u))).store(c.d[1][k]);
}

/// All contacts to the end of the step.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void move(Columns<W, HasUnequalMasses>& c) {
  using P = Pack<W>;
  const Mask<W> active = Mask<W>::load(c.active);
  const P s = P::load(c.length);
  const Pairs<W> time = in_pairs(s);
  const Mask<W> moves = active & (s > P(0.0));
  const Taylor<order, P> taylor(s);
  const Taylor<disturbed_order, Pairs<W>> disturbed(time);
  int k = 0;
  for (int r = 0; r <= c.run_count; ++r) {
    const int first = r < c.run_count ? c.runs[r].first : c.N;
    for (; k < first; ++k) fly_on<W>(c, k, s, time, moves);
    if (r == c.run_count) break;
    for (; k <= c.runs[r].last; ++k) {
      const Mask<W> deeper = active & Mask<W>::load(c.closed[k]) & (P::load(c.highest[k]) > P::load(c.x_max));
      if (any(deeper)) look_for_deepest(c, k, s, deeper);
      go_on<W>(c, k, taylor, disturbed, moves);
    }
  }
  (P::load(c.clock) + where(active, s)).store(c.clock);
}

}  // namespace sigmasweep::side_by_side
