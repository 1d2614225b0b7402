#pragma once

#include "solve/exact/linear/side_by_side/lanes/series.hpp"
#include "solve/exact/linear/side_by_side/lanes/uncertain.hpp"

/// The first contact of each lane to change its state within the step. Contacts are ruled out by bounds; of those that
/// cannot be, a lane's most promising one is followed by Newton's method, and a second bound proves that its root is
/// the first. What the bounds leave open, uncertain.cpp decides for that lane alone: no event is passed over.
namespace sigmasweep::side_by_side {

/// C(screen, p).
struct Binomials {
  double of[screen + 1]{};
  constexpr Binomials() {
    double c = 1.0;
    for (int p = 0; p <= screen; c = c * (screen - p) / (p + 1), ++p) of[p] = c;
  }
};
inline constexpr Binomials binomials;

/// Of a polynomial whose term p on [0, 1] is b[p] C(screen, p): its coefficients in the Bernstein basis. They bound the
/// polynomial from both sides.
template <int W>
SIGMASWEEP_LANEWISE void to_bernstein(Pack<W> (&b)[screen + 1]) {
#pragma GCC unroll 8
  for (int level = 1; level <= screen; ++level)
#pragma GCC unroll 8
    for (int p = screen; p >= level; --p) b[p] = b[p] + b[p - 1];
}

/// What takes derivative p to b[p] on [0, limit], and derivative p + 1 to that of x/t; limit^(screen+1).
template <int W>
struct Scales {
  Pack<W> of[screen + 1], of_next[screen + 1], beyond;
  SIGMASWEEP_LANEWISE explicit Scales(Pack<W> limit) {
    Pack<W> power(1.0);
#pragma GCC unroll 9
    for (int p = 0; p <= screen; ++p) {
      of[p] = power * Pack<W>(one_over.of_factorial[p] / binomials.of[p]);
      of_next[p] = power * Pack<W>(one_over.of_factorial[p + 1] / binomials.of[p]);
      power = power * limit;
    }
    beyond = power;
  }
};

/// Bounds of contact k: the Bernstein coefficients on [0, limit] of x, or of x/t if x = 0 at the start.
template <int W>
struct Bounds {
  Pack<W> b[screen + 1], lowest, highest;

  template <class Columns>
  SIGMASWEEP_LANEWISE Bounds(const Columns& c, int k, const Scales<W>& scales) {
    const Pack<W> start = Pack<W>::load(c.a[0][k]);
    const Mask<W> at_zero = start == Pack<W>(0.0);
    Pack<W> term = start;
#pragma GCC unroll 9
    for (int p = 0; p <= screen; ++p) {
      const Pack<W> next = Pack<W>::load(c.a[p + 1][k]);
      b[p] = select(at_zero, next * scales.of_next[p], term * scales.of[p]);
      term = next;
    }
    to_bernstein<W>(b);
    lowest = highest = b[0];
#pragma GCC unroll 8
    for (int p = 1; p <= screen; ++p) {
      lowest = least(b[p], lowest);
      highest = most(b[p], highest);
    }
  }
  /// Contact k keeps its state as long as its distance from an event stays positive: x while it is closed, -x while it
  /// is open.
  SIGMASWEEP_LANEWISE Pack<W> distance(Mask<W> open) const { return select(open, Pack<W>(0.0) - highest, lowest); }
};

/// Where the control polygon first falls below 0, in 1/screen of the interval; if it does not, its first point that may
/// hide a root.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> first_fall(const Bounds<W>& bounds, Mask<W> open, Pack<W> rest) {
  using P = Pack<W>;
  const P zero(0.0);
  P place(0.0), above(1.0), below(-1.0), possible(0.0), b = negated_where(open, bounds.b[screen]);
  Mask<W> falls = Mask<W>::none();
#pragma GCC unroll 8
  for (int p = screen; p > 0; --p) {
    const P before = negated_where(open, bounds.b[p - 1]);
    const Mask<W> negative = b < zero;
    falls = falls | negative;
    place = select(negative, P(double(p - 1)), place);
    above = select(negative, before, above);
    below = select(negative, b, below);
    possible = select(b > rest, possible, P(double(p)));
    b = before;
  }
  return where(b > zero, select(falls, place + above / (above - below), possible)) * P(1.0 / screen);
}

/// Rules contact k out where it cannot change its state on [0, limit].
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Mask<W> rule_out(Columns<W, HasUnequalMasses>& c, int k, Mask<W> suspects, const Scales<W>& scales,
                                     Pack<W> limit) {
  using P = Pack<W>;
  const Mask<W> open = ~Mask<W>::load(c.closed[k]);
  const Bounds<W> bounds(c, k, scales);
  const P rest = P::load(c.rest[k]) * scales.beyond;
  const Mask<W> suspect = suspects & ~(bounds.distance(open) > rest);
  if (any(suspect)) (first_fall<W>(bounds, open, rest) * limit).store(c.estimate[k]);
  return suspect;
}

/// Sum of the terms of contact k that the screen leaves out.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Pack<W> left_out(const Columns<W, HasUnequalMasses>& c, int k) {
  using P = Pack<W>;
  const auto term = [&](int p) SIGMASWEEP_INLINE_LAMBDA { return magnitude(P::load(c.a[p][k])); };
  const auto weight = [](int p) SIGMASWEEP_INLINE_LAMBDA { return P(one_over.of_factorial[p]); };
  P even = term(order) * weight(order), odd(0.0);
#pragma GCC unroll 8
  for (int p = screen + 2; p < order; p += 2) {
    even = fma(term(p), weight(p), even);
    odd = fma(term(p + 1), weight(p + 1), odd);
  }
  const Mask<W> at_zero = P::load(c.a[0][k]) == P(0.0);
  return fma(where(~at_zero, term(screen + 1)), weight(screen + 1), even + odd);
}

/// Contact k stays open, flying uniformly: neither it nor a contact beside it is closed.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Mask<W> flies_on(const Columns<W, HasUnequalMasses>& c, int k) {
  using P = Pack<W>;
  Mask<W> closed = Mask<W>::load(c.closed[k]);
  if (k > 0) closed = closed | Mask<W>::load(c.closed[k - 1]);
  if (k + 1 < c.N) closed = closed | Mask<W>::load(c.closed[k + 1]);
  return ~closed & (P::load(c.a[0][k]) + P::load(c.a[1][k]) < P(0.0));
}

/// Rules contact k out where it cannot change its state within the step; bounds its overlap.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Mask<W> examine(Columns<W, HasUnequalMasses>& c, int k, const Scales<W>& scales, Mask<W> active) {
  using P = Pack<W>;
  const Mask<W> open = ~Mask<W>::load(c.closed[k]);
  const P rest = left_out<W>(c, k);
  const Bounds<W> bounds(c, k, scales);
  rest.store(c.rest[k]);
  (bounds.highest + rest).store(c.highest[k]);
  const P distance = bounds.distance(open);
  const Mask<W> safe = (distance > rest) | ((rest == P(0.0)) & (distance == rest)) | flies_on<W>(c, k);
  const Mask<W> suspect = active & ~safe;
  if (any(suspect)) first_fall<W>(bounds, open, rest).store(c.estimate[k]);
  return suspect;
}

/// The root of the candidates near `t` by Newton's method, each lane until it has converged; -1 where it has not.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Pack<W> root_near(const Columns<W, HasUnequalMasses>& c, Pack<W> t, Mask<W> wanted) {
  using P = Pack<W>;
  Mask<W> done = ~wanted, converged = Mask<W>::none();
  for (int iteration = 0; iteration < 12 && any(~done); ++iteration) {
    const P t2 = t * t;
    P even = P::load(c.candidate[order]), odd(0.0), even_slope(0.0), odd_slope(0.0);
#pragma GCC unroll 12
    for (int p = order - 2; p >= 0; p -= 2) {
      even_slope = fma(even_slope, t2, even);
      even = fma(even, t2, P::load(c.candidate[p]));
      odd_slope = fma(odd_slope, t2, odd);
      odd = fma(odd, t2, P::load(c.candidate[p + 1]));
    }
    const P value = fma(t, odd, even);
    const P slope = fma(t + t, fma(t, odd_slope, even_slope), odd);
    const P step = value / slope, next = t - step;
    const Mask<W> close = magnitude(step) < P(1e-8) * t;
    const Mask<W> inside = (next > P(0.0)) & (next < P(2.0));
    converged = converged | (~done & close & inside);
    t = select(done, t, next);
    done = done | close | ~inside;
  }
  return select(converged, t, P(-1.0));
}

/// Whether t > 0 is the candidate's first root on [0, limit], or, if it is beyond, there is none: with g(s) = (t - s)
/// q(s) it is enough that q > 0 on [0, min(t, limit)].
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE Mask<W> is_first(const Columns<W, HasUnequalMasses>& c, Pack<W> t, Pack<W> limit) {
  using P = Pack<W>;
  const P end = least(t, limit);
  P q[order];  // of the series that Horner's rule leaves
  P r = P::load(c.candidate[order]);
  for (int p = order - 1; p >= 0; --p) {
    q[p] = P(0.0) - r;
    r = fma(r, t, P::load(c.candidate[p]));
  }
  P b[screen + 1], rest(0.0), power(1.0);
#pragma GCC unroll 9
  for (int p = 0; p <= screen; ++p) {
    b[p] = q[p] * (power * P(1.0 / binomials.of[p]));
    power = power * end;
  }
  for (int p = screen + 1; p < order; ++p) {
    rest = fma(magnitude(q[p]), power, rest);
    power = power * end;
  }
  to_bernstein<W>(b);
  P lowest = b[0];
#pragma GCC unroll 8
  for (int p = 1; p <= screen; ++p) lowest = least(b[p], lowest);
  return (t > P(0.0)) & (lowest > rest);
}

/// The suspects of one step.
template <int W>
struct Suspects {
  int count = 0, contact[most_beads];
  Mask<W> mask[most_beads];
};

template <int W>
SIGMASWEEP_LANEWISE Mask<W> any_of(const Suspects<W>& suspects) {
  Mask<W> some = Mask<W>::none();
  for (int i = 0; i < suspects.count; ++i) some = some | suspects.mask[i];
  return some;
}

/// The distance of each lane's contact from its event becomes the candidate.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void take_candidate(Columns<W, HasUnequalMasses>& c, Pack<W> contact) {
  using P = Pack<W>;
  long long lane[W];
  for (int l = 0; l < W; ++l) lane[l] = l;
  const auto place = whole_numbers(contact) * W + Mask<W>::load(lane).v;
  const Mask<W> open = gather<W>(c.acting_spring[0], place) == P(0.0);
  const Mask<W> at_zero = gather<W>(c.a[0][0], place) == P(0.0);
  const auto first = place + (at_zero.v & (most_beads * W));  // x/t
#pragma GCC unroll 24
  for (int p = 0; p < order; ++p) {
    const P weight = select(at_zero, P(one_over.of_factorial[p + 1]), P(one_over.of_factorial[p]));
    (negated_where(open, gather<W>(c.a[p][0], first)) * weight).store(c.candidate[p]);
  }
  const P last = gather<W>(c.a[order][0], place) * P(one_over.of_factorial[order]);
  where(~at_zero, negated_where(open, last)).store(c.candidate[order]);
}

/// In each lane the suspect that seems to be first becomes the candidate and is no suspect any more.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void take_candidates(Columns<W, HasUnequalMasses>& c, Suspects<W>& suspects, Pack<W>& contact,
                                         Pack<W>& estimate) {
  using P = Pack<W>;
  contact = P(0.0);
  estimate = P(9.0);
  for (int i = 0; i < suspects.count; ++i) {
    const int k = suspects.contact[i];
    const P when = select(suspects.mask[i], P::load(c.estimate[k]), P(9.0));
    const Mask<W> earlier = when < estimate;
    contact = select(earlier, P(double(k)), contact);
    estimate = least(when, estimate);
  }
  for (int i = 0; i < suspects.count; ++i)
    suspects.mask[i] = suspects.mask[i] & ~(contact == P(double(suspects.contact[i])));
  take_candidate<W>(c, contact);
}

/// Length and event of some lanes by isolating the roots of their suspects.
template <int W, bool HasUnequalMasses>
[[gnu::noinline]] void decide_alone(Columns<W, HasUnequalMasses>& c, unsigned lanes) {
  for (int r = 0, k = 0; r <= c.run_count; ++r) {
    const int first = r < c.run_count ? c.runs[r].first : c.N;
    for (; k < first; ++k) Mask<W>::none().store(c.suspect[k]);
    if (r < c.run_count) k = c.runs[r].last + 1;
  }
  for (int l = 0; l < W; ++l)
    if (lanes >> l & 1) {
      const FirstEvent first = first_event_of_lane(&c.a[0][0][l], &c.closed[0][l], &c.suspect[0][l], W, c.N);
      c.length[l] = first.when;
      c.event[l] = first.contact;
    }
}

/// Sets length and event of the lanes of `active`.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void find_first_event(Columns<W, HasUnequalMasses>& c, Mask<W> active) {
  using P = Pack<W>;
  Suspects<W> suspects;
  {
    const Scales<W> whole{P(1.0)};
    for (int r = 0; r < c.run_count; ++r)
      for (int k = c.runs[r].first; k <= c.runs[r].last; ++k) {
        const Mask<W> suspect = examine<W>(c, k, whole, active);
        suspect.store(c.suspect[k]);
        if (!any(suspect)) continue;
        suspects.contact[suspects.count] = k;
        suspects.mask[suspects.count++] = suspect;
      }
  }
  P limit = where(active, P(1.0)), event(-1.0);
  Mask<W> uncertain = Mask<W>::none();
  for (int round = 0; round < 4; ++round) {
    const Mask<W> wanted = any_of(suspects) & ~uncertain;
    if (!any(wanted)) break;
    P contact, estimate;
    take_candidates<W>(c, suspects, contact, estimate);
    const Mask<W> at_once = wanted & (P::load(c.candidate[0]) < P(0.0));
    const P t = select(at_once, P(0.0), root_near(c, estimate, wanted & ~at_once));
    const Mask<W> certain = at_once | (wanted & is_first(c, t, limit));
    uncertain = uncertain | (wanted & ~certain);
    const Mask<W> first = certain & ~(t > limit);
    limit = select(first, t, limit);
    event = select(first, contact, event);
    const Scales<W> shorter(limit);
    for (int i = 0; i < suspects.count; ++i) {
      suspects.mask[i] = suspects.mask[i] & ~(limit == P(0.0));
      if (any(suspects.mask[i]))
        suspects.mask[i] = rule_out<W>(c, suspects.contact[i], suspects.mask[i], shorter, limit);
    }
  }
  uncertain = uncertain | any_of(suspects);
  limit.store(c.length);
  double events[W];
  event.store(events);
  for (int l = 0; l < W; ++l) c.event[l] = int(events[l]);
  if (any(uncertain)) decide_alone<W>(c, lanes_of(uncertain));
}

}  // namespace sigmasweep::side_by_side
