#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec2.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// Result of one run of a solver of columns, in the column's units.
template <class Real>
struct Outcome {
  std::vector<Real> velocity;  ///< final velocities of beads 1..N
  Real t_k{};                  ///< from the first to the last contact with the wall
  Real x_max{};                ///< largest overlap
  std::uint64_t contacts = 0;  ///< contacts closed and opened again
  End end = End::none;
  Status status = Status::ok;
};

/// The longest intervals without a contact, the longest first. One of them may be the interval after the end.
template <class Real>
struct Waits {
  struct Wait {
    Real length{};
    /// Estimated difference of eps_eff had this interval been on the other side of Lattice::quiet_time().
    Real change{};
  };
  std::array<Wait, 6> longest{};

  void note(const Wait& wait) {
    auto place = std::ranges::find_if(longest, [&](const Wait& w) { return w.length < wait.length; });
    if (place == longest.end()) return;
    std::move_backward(place, longest.end() - 1, longest.end());
    *place = wait;
  }
};

/// Result of one run of a solver of lattices, in the lattice's units.
template <class Real>
struct LatticeOutcome {
  std::vector<Vec2<Real>> velocity;
  Real t_k{};                  ///< from the first to the last contact with the bottom
  Real x_max{};                ///< largest overlap
  Real remainder{};            ///< End::settled: estimate of what later contacts can still change eps_eff by
  Waits<Real> waits;           ///< End::quiet, from event to event
  std::uint64_t contacts = 0;  ///< contacts closed and opened again
  Real contact_time{};  ///< how long they were closed, all together; from event to event only, until the last one
  End end = End::none;
  Status status = Status::ok;
};

}  // namespace sigmasweep
