#pragma once

#include <cstdint>
#include <vector>

#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// A contact of hard spheres: its gap, and its closing speed u (> 0: approaching). A collision changes u of the
/// contacts below and above by the shares `below` and `above`.
struct Approach {
  long double gap, u, below, above;
};

/// Collisions after the energy is gone. Where the beads part: all of them, and End::separated.
struct LateCollisions {
  End end = End::settled;         ///< settled: not known
  Status status = Status::ok;     ///< collapsed: infinitely many collisions follow
  std::uint64_t contacts = 0;     ///< number of collisions
  long double last_wall = -1.0L;  ///< time of the last collision with the wall; < 0: none
};

/// Follows contacts, the lowest with the wall first, from collision to collision (the fastest of simultaneous ones
/// first) until nothing approaches; until speeds are below 1e-600 of the first ones, which is a collapse; or for 10,000
/// collisions (300,000 divided by the number of contacts). Times count from the last collision, so that they and gaps
/// keep their relative accuracy however short they become.
LateCollisions late_collisions(std::vector<Approach> contacts, long double e, long double e_wall);

}  // namespace sigmasweep
