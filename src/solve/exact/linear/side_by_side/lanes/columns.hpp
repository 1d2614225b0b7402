#pragma once

#include <cstddef>
#include <cstdint>

namespace sigmasweep::side_by_side {

inline constexpr int most_beads = 63;
/// Derivatives in the column's own series and in those of its disturbances, of which two digits are enough.
inline constexpr int order = 24, disturbed_order = 8;
/// Degree of the Bernstein polynomials that rule out events.
inline constexpr int screen = 8;
/// Linearised disturbances of each column, with independent signs.
inline constexpr int disturbances = 2;
inline constexpr int words_of_noise = (most_beads + 31) / 32;

/// W columns of N beads, each with its own clock. Lengths in v0 tc; each lane's unit of time is its step h, so that
/// rates are u h. Contacts are numbered 0 (the wall) to N-1, as everywhere. Plain numbers, which any source may read
/// and write, whatever instructions it is compiled for.
///
/// Rows come first, so that each is a whole line of the cache (W = 8).
///
/// a[0] and a[1] are overlaps and rates of the contacts; a[p] is room for the derivative number p. The same of the two
/// disturbances of a lane, d, which are in units of the root mean square of a rounding error (motion.hpp).
template <int W, int Derivatives, int DisturbedDerivatives>
struct alignas(64) Lanes {
  static_assert(disturbances == 2);
  using Row = double[W];
  using Flags = long long[W];             ///< -1: yes, 0: no
  using Pairs = float[disturbances * W];  ///< lane l has numbers l and W + l

  Row a[Derivatives + 1][most_beads];
  Pairs d[DisturbedDerivatives + 1][most_beads];
  Row inverse_mass[most_beads];  ///< of the bead above each contact
  /// Random bits for the next step, for overlaps and for rates: 32 contacts a word.
  std::uint32_t noise[2][words_of_noise][disturbances * W];
  Flags active;               ///< a column is in this lane, and has not come to an end
  Row clock;                  ///< since the first contact with the wall
  Row wall_opened;            ///< when the wall's contact opened last
  Row x_max;                  ///< the largest overlap
  std::uint64_t contacts[W];  ///< opened again
  Flags separated;            ///< the column has come to an end: nothing touches, nothing approaches
  int N = 0;
};

/// Columns that go on by steps, whatever touches. HasUnequalMasses: else all masses are 1.
template <int W, bool HasUnequalMasses>
struct Columns : Lanes<W, order, disturbed_order> {
  using Base = Lanes<W, order, disturbed_order>;
  using typename Base::Row, typename Base::Flags, typename Base::Pairs;
  alignas(64) Row spring[most_beads], dashpot[most_beads];  ///< K h^2 and C h of each contact
  /// The same where the contact is closed, else 0.
  Row acting_spring[most_beads], acting_dashpot[most_beads];
  Pairs disturbed_spring[most_beads], disturbed_dashpot[most_beads];
  Flags closed[most_beads];      ///< contacts
  std::uint64_t closed_bits[W];  ///< the same, contact k as bit k
  // Of the present step:
  Row rest[most_beads];       ///< bound of the terms beyond the screen's degree
  Row highest[most_beads];    ///< closed contacts: bound of the overlap during the step
  Row estimate[most_beads];   ///< suspects: where the control polygon changes its sign
  Flags suspect[most_beads];  ///< contacts that may change their state within the step
  Row length;                 ///< of the step, at most 1
  Row candidate[order + 1];   ///< the distance of one suspect a lane from its event, as a series
  int event[W];               ///< the contact that changes its state at the step's end, or -1
  /// Runs of neighbouring contacts that may do more than fly uniformly, in some lane.
  struct Run {
    int first, last;
  };
  Run runs[most_beads];
  int run_count;
};

/// Columns in which nothing disturbs a contact that is closed: see jump_impl.hpp.
template <int W, bool HasUnequalMasses>
struct Jumps : Lanes<W, 1, 1> {
  using Base = Lanes<W, 1, 1>;
  using typename Base::Row, typename Base::Flags, typename Base::Pairs;
  /// Kinds of contacts: the wall's and a pair's, or all of them.
  static constexpr int kinds = HasUnequalMasses ? most_beads : 2;
  /// Restitution, contact time in h, largest overlap of a contact that closes at unit rate.
  alignas(64) Row restitution[kinds], duration[kinds], deepest[kinds];
  Pairs restitution_error[kinds];              ///< of the disturbances
  Row share_below[kinds], share_above[kinds];  ///< what a gap beside receives, over the change of the contact itself
  Row depth[most_beads];  ///< largest overlap of each contact's last time, which x_max does not know yet
  Row wall_opens;         ///< when the wall's contact opens, or opened; wall_opened: the time before
  Flags crowded;          ///< something would disturb a closed contact: the column must go on by steps
};

}  // namespace sigmasweep::side_by_side
