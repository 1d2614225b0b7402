#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Mean velocities of a vibrated lattice's beads in the cells of a grid that goes up and down with the plate, during a
/// part of its period: [phase/phases, (phase + 1)/phases), over all periods after the first ones, a third of the film's
/// but not more than the transient. Vertically relative to the mean of the row of cells: that goes up and down, and the
/// rows away from each other and back, in every period, and what is to be seen is how beads move past each other.
/// Several films, of containers that differ by chance only, are averaged as one.
struct VelocityField {
  std::size_t columns = 0, rows = 0;  ///< of cells, from the container's lower left corner
  double width = 0.0, height = 0.0;   ///< of a cell, m: about the mean diameter
  bool periodic = false;
  std::vector<Vec2<double>> velocity;  ///< m/s, of cell [row * columns + column]
  std::vector<bool> filled;            ///< whether enough beads came by: in one sample of twenty there is one

  bool has(std::size_t column, std::size_t row) const { return filled[row * columns + column]; }
  Vec2<double> at(std::size_t column, std::size_t row) const { return velocity[row * columns + column]; }
};

using Films = std::span<const Panel* const>;
VelocityField velocity_field(Films films, std::size_t phase, std::size_t phases);

/// How strong convection rolls are: the mean curl of the field (counterclockwise is positive; a rigid rotation has
/// twice its angular velocity) in the left and in the right half, 1/s; of the corners between four cells that are
/// filled, NaN where there are none. A pair of rolls that goes up in the middle and down at the sides has left > 0 >
/// right.
struct Rolls {
  double left = 0.0, right = 0.0;
};
Rolls rolls_of(const VelocityField& field);

/// Of several films, each for itself: the mean of those that have any corners, and its standard error (NaN of a single
/// one).
struct MeanRolls {
  Rolls mean, error;
};
MeanRolls mean_rolls(Films films, std::size_t phase, std::size_t phases);

}  // namespace sigmasweep
