#pragma once

#include "solve/exact/linear/side_by_side/lanes/motion.hpp"

/// Contacts that nothing disturbs. A contact that closes with rate u opens after its contact time D with rate -eps u;
/// the gaps beside it receive, over 1/I = m_red, the impulse (1 + eps) u and its double integral u D. The jump is
/// written as if it had happened at the closing: from then on
///     x_k = eps u D,  u_k = -eps u,   and of the gaps beside it   x -= x_k/I,  u += (1 + eps) u/I
/// fly uniformly, and are the true overlaps from the time D later on. Until then x_k > 0: the contact is busy.
///
/// A gap beside a busy contact is in truth at most x + x_k/I: as the overlap is not negative, the double integral of
/// the force is at most u t/I after a time t, and the flight has u t/I - x_k(t)/I. So the gap at k + 1 stays open as
/// long as
///     x_(k+1) + max(x_k, 0)/I + max(x_(k+2), 0)/I < 0.
/// In time this is a convex function, so that it holds during a flight if it holds at both ends.
namespace sigmasweep::side_by_side {

/// The next contact of each lane.
template <int W>
struct NextContact {
  Pack<W> contact, u, dx, du;  ///< which, its rate, and its disturbance now
  Pack<W> when;                ///< infinite: there is none
};

template <int W>
SIGMASWEEP_LANEWISE NextContact<W> next_contact(const Jumps<W>& c) {
  using P = Pack<W>;
  const P zero(0.0);
  NextContact<W> next{P(-1.0), zero, zero, zero, zero};
  P gap(1.0);
  for (int k = 0; k < c.N; ++k) {
    const P u = P::load(c.u[k]), open = most(zero - P::load(c.x[k]), zero);
    const Mask<W> earlier = (u > zero) & (open * next.u < gap * u);
    gap = select(earlier, open, gap);
    next.u = select(earlier, u, next.u);
    next.contact = select(earlier, P(double(k)), next.contact);
    next.dx = select(earlier, P::load(c.dx[k]), next.dx);
    next.du = select(earlier, P::load(c.du[k]), next.du);
  }
  next.when = gap / next.u;
  return next;
}

/// How long the last busy contact of each lane stays so.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> all_open_after(const Jumps<W>& c) {
  using P = Pack<W>;
  const P zero(0.0);
  P last(0.0);
  for (int k = 0; k < c.N; ++k) {
    const P x = P::load(c.x[k]), u = P::load(c.u[k]);
    last = most(where((x > zero) & (u < zero), x / (zero - u)), last);
  }
  return last;
}

/// What the jump at its contact does to a lane.
template <int W>
struct Jump {
  Pack<W> x, u, dx, du;                      ///< of the contact, afterwards
  Pack<W> push_x, push_u, push_dx, push_du;  ///< changes of the gaps beside it
  Pack<W> deepest, opens;                    ///< largest overlap; contact time

  SIGMASWEEP_LANEWISE Jump(const Jumps<W>& c, const NextContact<W>& next, Pack<W> t) {
    using P = Pack<W>;
    const Mask<W> wall = next.contact == P(0.0);
    const P eps = select(wall, P::load(c.restitution[1]), P::load(c.restitution[0]));
    const P D = select(wall, P::load(c.duration[1]), P::load(c.duration[0]));
    const P share = select(wall, P(1.0), P(0.5));
    const P d_eps = P(rounding) * select(wall, P::load(c.restitution_error[1]), P::load(c.restitution_error[0]));
    const P dx_then = fma(next.du, t, next.dx), lasting = eps * D;
    u = P(0.0) - eps * next.u;
    x = lasting * next.u;
    du = P(0.0) - fma(eps, next.du, d_eps * next.u);
    dx = fma(lasting, next.du, (D * d_eps) * next.u - eps * dx_then);
    push_x = P(0.0) - share * x;
    push_u = share * (next.u - u);
    push_dx = share * (dx_then - dx);
    push_du = share * (next.du - du);
    deepest = select(wall, P::load(c.deepest[1]), P::load(c.deepest[0])) * next.u;
    opens = D;
  }
};

/// Overlaps of all contacts after a time t; what their busy contacts may add to the gaps beside them.
template <int W>
struct Flight {
  Pack<W> x[most_beads];
  Mask<W> crowded;

  SIGMASWEEP_LANEWISE Flight(const Jumps<W>& c, Pack<W> contact, Pack<W> t) {
    using P = Pack<W>;
    const P zero(0.0);
    for (int k = 0; k < c.N; ++k) {
      const Mask<W> closes = contact == P(double(k));
      x[k] = where(~closes, fma(P::load(c.u[k]), t, P::load(c.x[k])));
    }
    crowded = Mask<W>::none();
    P below(0.0);
    for (int k = 0; k < c.N; ++k) {
      const P above = k + 1 < c.N ? P(0.5) * most(x[k + 1], zero) : zero;
      const Mask<W> closes = contact == P(double(k));
      const Mask<W> busy = (P::load(c.x[k]) > zero) & (P::load(c.u[k]) < zero);
      const P push = below + above;
      crowded = crowded | select_mask(closes, push > zero, ~busy & ~(x[k] + push < zero));
      below = (k == 0 ? P(1.0) : P(0.5)) * most(x[k], zero);
    }
  }
};

template <int W>
SIGMASWEEP_LANEWISE void jump_columns(Jumps<W>& c) {
  using P = Pack<W>;
  const P zero(0.0);
  const Mask<W> active = Mask<W>::load(c.active);
  const NextContact<W> next = next_contact<W>(c);
  const Mask<W> ends = next.u == zero;
  P t = next.when;
  if (any(ends & active)) t = select(ends, all_open_after<W>(c), t);
  const Flight<W> flight(c, next.contact, t);
  const Mask<W> goes = active & ~flight.crowded;
  const Jump<W> jump(c, next, t);
  typename Vectors<W>::Bits words;
  __builtin_memcpy(&words, c.noise, sizeof words);
  P x_max = P::load(c.x_max);
  for (int k = 0; k < c.N; ++k) {
    const Mask<W> closes = next.contact == P(double(k));
    const Mask<W> beside = magnitude(next.contact - P(double(k))) == P(1.0);
    const P x = P::load(c.x[k]), u = P::load(c.u[k]), dx = P::load(c.dx[k]), du = P::load(c.du[k]);
    const P new_x = select(closes, jump.x, flight.x[k] + where(beside, jump.push_x));
    const P new_u = select(closes, jump.u, u + where(beside, jump.push_u));
    const P new_dx = select(closes, jump.dx, fma(du, t, dx) + where(beside, jump.push_dx));
    const P new_du = select(closes, jump.du, du + where(beside, jump.push_du));
    const P of_x = magnitude(x) + (magnitude(u * t) + magnitude(new_x)),
            of_u = where(closes | beside, magnitude(new_u));
    const P depth = P::load(c.depth[k]);
    x_max = select(closes & goes, most(depth, x_max), x_max);
    select(closes & goes, jump.deepest, depth).store(c.depth[k]);
    select(goes, new_x, x).store(c.x[k]);
    select(goes, new_u, u).store(c.u[k]);
    select(goes, new_dx + signed_by<W>(words, 2 * k, P(rounding) * of_x), dx).store(c.dx[k]);
    select(goes, new_du + signed_by<W>(words, 2 * k + 1, P(rounding) * of_u), du).store(c.du[k]);
  }
  x_max.store(c.x_max);
  const P clock = P::load(c.clock), now = select(goes, clock + t, clock);
  now.store(c.clock);
  const Mask<W> at_wall = goes & (next.contact == zero);
  const P wall_opens = P::load(c.wall_opens);
  select(at_wall, wall_opens, P::load(c.wall_opened)).store(c.wall_opened);
  select(at_wall, now + jump.opens, wall_opens).store(c.wall_opens);
  (goes & ends).store(c.separated);
  (active & flight.crowded).store(c.crowded);
  (goes & ~ends).store(c.active);
  const unsigned closed = lanes_of(goes & ~ends);
  for (int l = 0; l < W; ++l) c.contacts[l] += closed >> l & 1;
}

}  // namespace sigmasweep::side_by_side
