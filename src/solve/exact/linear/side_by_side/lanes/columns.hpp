#pragma once

#include <cstddef>
#include <cstdint>

namespace sigmasweep::side_by_side {

inline constexpr int most_beads = 31;  ///< a lane's random word of 64 bits has two signs for each contact
/// Terms of the column's own series and of its disturbance's, of which two digits are enough.
inline constexpr int order = 24, disturbed_order = 8;
/// Degree of the Bernstein polynomials that rule out events.
inline constexpr int screen = 8;

/// W columns of N beads, each with its own clock. Lengths in v0 tc; each lane's unit of time is its step h, so that
/// rates are u h. Contacts are numbered 0 (the wall) to N-1, as everywhere. Plain numbers, which any source may read
/// and write, whatever instructions it is compiled for.
template <int W>
struct alignas(64) Lanes {
  using Row = double[W];
  using Flags = long long[W];  ///< -1: yes, 0: no

  int N = 0;
  Flags active;                         ///< a column is in this lane, and has not come to an end
  Row x[most_beads], u[most_beads];     ///< overlaps and rates
  Row dx[most_beads], du[most_beads];   ///< of the linearised disturbance
  Row clock;                            ///< since the first contact with the wall
  Row wall_opened;                      ///< when the wall's contact opened last
  Row x_max;                            ///< the largest overlap
  std::uint64_t contacts[W], noise[W];  ///< opened again; random bits for the next step
  Flags separated;                      ///< the column has come to an end: nothing touches and nothing approaches
};

/// Columns that go on by steps, whatever touches.
template <int W>
struct Columns : Lanes<W> {
  using typename Lanes<W>::Row, typename Lanes<W>::Flags;
  Row spring, dashpot;            ///< K h^2 and C h of a pair
  Row wall_spring, wall_dashpot;  ///< and of the wall
  Flags closed[most_beads];       ///< contacts
  std::uint64_t closed_bits[W];   ///< the same, contact k as bit k
  // Of the present step:
  /// Runs of neighbouring contacts that may do more than fly uniformly, in some lane.
  struct Run {
    int first, last;
  };
  Run runs[most_beads];
  int run_count;
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

/// Columns in which nothing disturbs a contact that is closed: see jump_impl.hpp.
template <int W>
struct Jumps : Lanes<W> {
  using typename Lanes<W>::Row, typename Lanes<W>::Flags;
  /// Of a pair and of the wall: restitution, contact time in h, largest overlap of a contact that closes at unit rate.
  Row restitution[2], duration[2], deepest[2];
  Row restitution_error[2];  ///< of the disturbance, in units of the rounding error
  Row depth[most_beads];     ///< largest overlap of each contact's last time, which x_max does not know yet
  Row wall_opens;            ///< when the wall's contact opens, or opened; wall_opened: the time before
  Flags crowded;             ///< something would disturb a closed contact: the column must go on by steps
};

}  // namespace sigmasweep::side_by_side
