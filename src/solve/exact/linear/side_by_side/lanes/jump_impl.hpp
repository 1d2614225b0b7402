#pragma once

#include "solve/exact/linear/side_by_side/lanes/motion.hpp"

/// Contacts that nothing disturbs. A contact that closes with rate u opens after its contact time D with rate -eps u;
/// a gap beside it receives its share m_red/m, m the mass of the bead between, of the change of u and of the double
/// integral u D. The jump is written as if it had happened at the closing: from then on
///     x_k = eps u D,  u_k = -eps u,   and of the gaps beside it   x -= x_k m_red/m,  u += (1 + eps) u m_red/m
/// fly uniformly, and are the true overlaps from the time D later on. Until then x_k > 0: the contact is busy.
///
/// A gap beside a busy contact is in truth at most x + x_k m_red/m: as the overlap is not negative, the double integral
/// of the force is at most u t m_red after a time t, and the flight has m_red (u t - x_k(t)). So the gap at k + 1
/// stays open as long as
///     x_(k+1) + max(x_k, 0) m_red/m + max(x_(k+2), 0) m_red/m < 0.
/// In time this is a convex function, so that it holds during a flight if it holds at both ends.
namespace sigmasweep::side_by_side {

/// Numbers of the kind of contact that each lane has next.
template <bool HasUnequalMasses, class P, class Rows>
SIGMASWEEP_LANEWISE P of_kind(const Rows& numbers, int N, P contact) {
  using Number = typename P::Scalar;
  if constexpr (!HasUnequalMasses) return select(contact == P(0), P::load(numbers[0]), P::load(numbers[1]));
  P number = P::load(numbers[0]);
  if constexpr (HasUnequalMasses)
    for (int k = 1; k < N; ++k) number = select(contact == P(static_cast<Number>(k)), P::load(numbers[k]), number);
  return number;
}

/// The next contact of each lane.
template <int W>
struct NextContact {
  Pack<W> contact, u;  ///< which, and its rate
  Pack<W> when;        ///< infinite: there is none
  Pairs<W> contact_in_pairs;
  Pairs<W> dx, du;  ///< its disturbances now
};

template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE NextContact<W> next_contact(const Jumps<W, HasUnequalMasses>& c) {
  using P = Pack<W>;
  const P zero(0.0);
  P gap(1.0), contact(-1.0), rate(0.0);
  for (int k = 0; k < c.N; ++k) {
    const P u = P::load(c.a[1][k]), open = most(zero - P::load(c.a[0][k]), zero);
    const Mask<W> earlier = (u > zero) & (open * rate < gap * u);
    gap = select(earlier, open, gap);
    rate = select(earlier, u, rate);
    contact = select(earlier, P(double(k)), contact);
  }
  NextContact<W> next{contact, rate, gap / rate, in_pairs(contact), Pairs<W>(0), Pairs<W>(0)};
  for (int k = 0; k < c.N; ++k) {
    const PairsMask<W> here = next.contact_in_pairs == Pairs<W>(float(k));
    next.dx = select(here, Pairs<W>::load(c.d[0][k]), next.dx);
    next.du = select(here, Pairs<W>::load(c.d[1][k]), next.du);
  }
  return next;
}

/// How long the last busy contact of each lane stays so.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Pack<W> all_open_after(const Jumps<W, HasUnequalMasses>& c) {
  using P = Pack<W>;
  const P zero(0.0);
  P last(0.0);
  for (int k = 0; k < c.N; ++k) {
    const P x = P::load(c.a[0][k]), u = P::load(c.a[1][k]);
    last = most(where((x > zero) & (u < zero), x / (zero - u)), last);
  }
  return last;
}

/// What the jump at its contact does to a lane.
template <int W, bool HasUnequalMasses>
struct Jump {
  Pack<W> contact;
  Pack<W> x, u, lost;                ///< of the contact, afterwards; by how much u has fallen
  Pack<W> share_below, share_above;  ///< of the gaps beside it
  Pack<W> deepest, opens;            ///< largest overlap; contact time
  Pairs<W> dx, du, dx_lost, du_lost;

  SIGMASWEEP_LANEWISE Jump(const Jumps<W, HasUnequalMasses>& c, const NextContact<W>& next, Pack<W> t)
      : contact(next.contact) {
    using P = Pack<W>;
    const auto of = [&](const auto& numbers)
                        SIGMASWEEP_INLINE_LAMBDA { return of_kind<HasUnequalMasses>(numbers, c.N, next.contact); };
    const P eps = of(c.restitution), lasting = eps * of(c.duration);
    opens = of(c.duration);
    u = P(0.0) - eps * next.u;
    x = lasting * next.u;
    lost = next.u - u;
    deepest = of(c.deepest) * next.u;
    share_above = of(c.share_above);
    share_below = HasUnequalMasses ? of(c.share_below) : share_above;
    const Pairs<W> eps_2 = in_pairs(eps);
    const Pairs<W> d_u = of_kind<HasUnequalMasses>(c.restitution_error, c.N, next.contact_in_pairs) * in_pairs(next.u);
    const Pairs<W> dx_then = fma(next.du, in_pairs(t), next.dx);
    du = Pairs<W>(0) - fma(eps_2, next.du, d_u);
    dx = fma(in_pairs(lasting), next.du, in_pairs(opens) * d_u - eps_2 * dx_then);
    dx_lost = dx_then - dx;
    du_lost = next.du - du;
  }
  /// Of the change, what the gap k beside the contact receives.
  SIGMASWEEP_LANEWISE Pack<W> share(int k) const {
    if constexpr (!HasUnequalMasses) return share_above;
    return select(Pack<W>(double(k)) > contact, share_above, share_below);
  }
};

/// Overlaps of all contacts after a time t; what their busy contacts may add to the gaps beside them.
template <int W, bool HasUnequalMasses>
struct Flight {
  Pack<W> x[most_beads];
  Mask<W> crowded;

  SIGMASWEEP_LANEWISE Flight(const Jumps<W, HasUnequalMasses>& c, Pack<W> contact, Pack<W> t) {
    using P = Pack<W>;
    const P zero(0.0);
    const auto kind = [](int k) SIGMASWEEP_INLINE_LAMBDA { return HasUnequalMasses || k == 0 ? k : 1; };
    for (int k = 0; k < c.N; ++k) {
      const Mask<W> closes = contact == P(double(k));
      x[k] = where(~closes, fma(P::load(c.a[1][k]), t, P::load(c.a[0][k])));
    }
    crowded = Mask<W>::none();
    P below(0.0);
    for (int k = 0; k < c.N; ++k) {
      const P above = k + 1 < c.N ? P::load(c.share_below[kind(k + 1)]) * most(x[k + 1], zero) : zero;
      const Mask<W> closes = contact == P(double(k));
      const Mask<W> busy = (P::load(c.a[0][k]) > zero) & (P::load(c.a[1][k]) < zero);
      const P push = below + above;
      crowded = crowded | select_mask(closes, push > zero, ~busy & ~(x[k] + push < zero));
      below = P::load(c.share_above[kind(k)]) * most(x[k], zero);
    }
  }
};

/// All contacts of the lanes of `goes` fly for a time t; then the jump.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void fly_and_jump(Jumps<W, HasUnequalMasses>& c, const Flight<W, HasUnequalMasses>& flight,
                                      const NextContact<W>& next, Pack<W> t, Mask<W> goes) {
  using P = Pack<W>;
  using Q = Pairs<W>;
  const Jump<W, HasUnequalMasses> jump(c, next, t);
  const Q time = in_pairs(t);
  const PairsMask<W> both_go = in_pairs(goes);
  P x_max = P::load(c.x_max);
  for (int k = 0; k < c.N; ++k) {
    const Mask<W> closes = next.contact == P(double(k));
    const Mask<W> beside = magnitude(next.contact - P(double(k))) == P(1.0);
    const P share = where(beside, jump.share(k));
    const P x = P::load(c.a[0][k]), u = P::load(c.a[1][k]);
    const P new_x = select(closes, jump.x, fma(P(0.0) - share, jump.x, flight.x[k]));
    const P new_u = select(closes, jump.u, fma(share, jump.lost, u));
    const P of_x = magnitude(x) + (magnitude(u * t) + magnitude(new_x));
    const P of_u = where(closes | beside, magnitude(new_u));
    const P depth = P::load(c.depth[k]);
    x_max = select(closes & goes, most(depth, x_max), x_max);
    select(closes & goes, jump.deepest, depth).store(c.depth[k]);
    select(goes, new_x, x).store(c.a[0][k]);
    select(goes, new_u, u).store(c.a[1][k]);

    const PairsMask<W> both_close = next.contact_in_pairs == Q(float(k));
    const Q dx = Q::load(c.d[0][k]), du = Q::load(c.d[1][k]), both_share = in_pairs(share);
    const Q new_dx = select(both_close, jump.dx, fma(both_share, jump.dx_lost, fma(du, time, dx)));
    const Q new_du = select(both_close, jump.du, fma(both_share, jump.du_lost, du));
    select(both_go, new_dx + signed_at_random<W>(c, k, 0, of_x), dx).store(c.d[0][k]);
    select(both_go, new_du + signed_at_random<W>(c, k, 1, of_u), du).store(c.d[1][k]);
  }
  x_max.store(c.x_max);
  const P clock = P::load(c.clock), now = select(goes, clock + t, clock);
  now.store(c.clock);
  const Mask<W> at_wall = goes & (next.contact == P(0.0));
  const P wall_opens = P::load(c.wall_opens);
  select(at_wall, wall_opens, P::load(c.wall_opened)).store(c.wall_opened);
  select(at_wall, now + jump.opens, wall_opens).store(c.wall_opens);
}

template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void jump_columns(Jumps<W, HasUnequalMasses>& c) {
  using P = Pack<W>;
  const Mask<W> active = Mask<W>::load(c.active);
  const NextContact<W> next = next_contact<W>(c);
  const Mask<W> ends = next.u == P(0.0);
  P t = next.when;
  if (any(ends & active)) t = select(ends, all_open_after<W>(c), t);
  const Flight<W, HasUnequalMasses> flight(c, next.contact, t);
  const Mask<W> goes = active & ~flight.crowded;
  fly_and_jump<W>(c, flight, next, t, goes);
  (goes & ends).store(c.separated);
  (active & flight.crowded).store(c.crowded);
  (goes & ~ends).store(c.active);
  const unsigned closed = lanes_of(goes & ~ends);
  for (int l = 0; l < W; ++l) c.contacts[l] += closed >> l & 1;
}

}  // namespace sigmasweep::side_by_side
