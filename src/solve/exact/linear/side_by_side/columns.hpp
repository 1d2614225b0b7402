#pragma once

#include <cstddef>
#include <cstdint>

namespace sigmasweep::side_by_side {

inline constexpr int most_beads = 31;  ///< a lane's random word of 64 bits has two signs for each contact
/// Terms of the column's own series and of its disturbance's, of which two digits are enough.
inline constexpr int order = 24, disturbed_order = 8;
/// Degree of the Bernstein polynomials that rule out events.
inline constexpr int screen = 8;

/// W columns of N beads, each with its own clock, step and event. Lengths in v0 tc; each lane's unit of time is its
/// step h, so that rates are u h. Contacts are numbered 0 (the wall) to N-1, as everywhere. Plain numbers, which any
/// source may read and write, whatever instructions it is compiled for.
template <int W>
struct alignas(64) Columns {
  using Row = double[W];
  using Flags = long long[W];  ///< -1: yes, 0: no

  int N = 0;
  Flags active;                         ///< a column is in this lane, and has not come to an end
  Row spring, dashpot;                  ///< K h^2 and C h of a pair
  Row wall_spring, wall_dashpot;        ///< and of the wall
  Row x[most_beads], u[most_beads];     ///< overlaps and rates
  Row dx[most_beads], du[most_beads];   ///< of the linearised disturbance
  Flags closed[most_beads];             ///< contacts
  Row clock, wall_opened;               ///< now, and when the wall's contact opened last, since the first one with it
  Row x_max;                            ///< the largest overlap
  std::uint64_t contacts[W], noise[W];  ///< opened again; random bits for the next step
  Flags separated;                      ///< the column has come to an end: nothing touches and nothing approaches
  // Of the present step:
  Row a[(order + 1) * most_beads];            ///< term p of contact k stands at p N + k
  Row d[(disturbed_order + 1) * most_beads];  ///< the same of the disturbance
  Row rest[most_beads];                       ///< bound of the terms beyond the screen's degree
  Row highest[most_beads];                    ///< closed contacts: bound of the overlap during the step
  Row estimate[most_beads];                   ///< suspects: where the control polygon changes its sign
  Flags suspect[most_beads];                  ///< contacts that may change their state within the step
  Row length;                                 ///< of the step, at most 1
  int event[W];                               ///< the contact that changes its state at the step's end, or -1
  Row candidate[order + 1];                   ///< the distance of one suspect a lane from its event, as a series
};

}  // namespace sigmasweep::side_by_side
