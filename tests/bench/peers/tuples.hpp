#pragma once

#include <cstddef>
#include <vector>

#include "sigmasweep/model/parameters.hpp"

/// The collisions that all methods compute: the reference set.
namespace sigmasweep::peers {

/// N = 10, eps = 0.9, the wall's contact as in the paper; linear law.
inline constexpr std::size_t beads = 10;
inline constexpr double epsilon = 0.9;

struct Tuple {
  Parameters parameters;
  double phase = 0.0;    ///< phase of a fixed step at which the first contact occurs, in [0, 1)
  double eps_eff = 0.0;  ///< true value, computed in 113 bits
  double sigma() const { return parameters.sigma; }
};

/// Tuples whose sigma is nearly the same.
struct Group {
  double sigma = 0.0;
  std::vector<Tuple> tuples;
};

/// A group for each sigma of 0, .01, .1, .3, 1, 2, 10. The first tuple of a group has exactly this sigma, the others
/// differ by up to 5 %, and all have random v0, tc and phases, so that no scheme of fixed step profits from contacts
/// that happen to open and close on its steps.
std::vector<Group> reference_set(std::size_t variations);

}  // namespace sigmasweep::peers
