#include "sigmasweep/model/trajectory.hpp"

namespace sigmasweep {

double Trajectory::base(std::size_t bead) const {
  if (is_plane()) return 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < bead; ++i) below += diameter[i];
  return below + 0.5 * diameter[bead];
}

}  // namespace sigmasweep
