#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "bench/peers/equations.hpp"
#include "bench/peers/event_search.hpp"

namespace sigmasweep::peers {

/// The state of a column between two events.
struct BetweenTwoEvents {
  State y;
  double t = 0.0;
  double step = 0.1;  ///< length of the last step, with which the next one is tried
};

/// Lets the contacts open or close whose overlaps have passed 0.
inline void change(Closed& closed, std::size_t contact) { closed[contact] = 1.0 - closed[contact]; }

/// Result of a collision: eps_eff, NaN without one, and the time at which it was over.
struct Collision {
  double eps_eff = NAN, duration = NAN;
};

/// A collision from event to event, as a careful user of a library computes it. `solver.next_event(now, closed)` moves
/// the column to the next event and returns the contact that opens or closes there. Flights without contacts need no
/// solver.
template <class Solver>
Collision collision_with_events(Solver& solver, double sigma, double settle) {
  constexpr int most_events = 20'000;
  BetweenTwoEvents now{.y = at_start(sigma)};
  Closed closed{};
  for (std::size_t k = 0; k < beads; ++k) closed[k] = now.y[k] >= 0.0 ? 1.0 : 0.0;
  for (int events = 0; events < most_events; ++events) {
    const bool flight = std::ranges::none_of(closed, [](double c) { return c > 0.0; });
    if (!flight) {
      const std::size_t contact = solver.next_event(now, closed);
      if (contact >= beads) return {};
      now.y[contact] = 0.0;
      change(closed, contact);
      continue;
    }
    if (is_over(now.y, settle)) return {.eps_eff = eps_eff(now.y), .duration = now.t};
    const double t = time_to_closing(now.y);
    for (std::size_t k = 0; k < beads; ++k) {
      const bool closes = now.y[beads + k] > 0.0 && -now.y[k] <= now.y[beads + k] * t;
      now.y[k] = closes ? 0.0 : now.y[k] + now.y[beads + k] * t;
      if (closes) change(closed, k);
    }
    now.t += t;
  }
  return {};
}

}  // namespace sigmasweep::peers
