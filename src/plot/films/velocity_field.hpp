#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "plot/films/panel.hpp"

namespace sigmasweep {

/// Mean velocities of the beads of a vibrated lattice, in the cells of a grid that moves with the plate, over one part
/// of the plate's period. Vertical velocities are relative to the mean of the row of cells, because all rows go up and
/// down in every period; the field shows how beads move past each other.
struct VelocityField {
  std::size_t columns = 0, rows = 0;  ///< numbers of cells, from the container's lower left corner
  double width = 0.0, height = 0.0;   ///< size of a cell, m: about the mean diameter
  bool periodic = false;
  std::vector<Vec2<double>> velocity;  ///< m/s, of cell [row * columns + column]
  std::vector<bool> filled;            ///< whether a cell has a bead in one of twenty samples or more

  bool has(std::size_t column, std::size_t row) const { return filled[row * columns + column]; }
  Vec2<double> at(std::size_t column, std::size_t row) const { return velocity[row * columns + column]; }
};

using Films = std::span<const Panel* const>;
/// The field in the part [phase/phases, (phase + 1)/phases) of the period. Initial periods are excluded: the transient,
/// but at most a third of the film. Films of lattices that differ by chance only are averaged as one.
VelocityField velocity_field(Films films, std::size_t phase, std::size_t phases);

/// Strength of convection rolls: the mean curl of the field in the left and in the right half, 1/s. Counterclockwise is
/// positive; a rigid rotation has twice its angular velocity. The curl is taken at corners between four filled cells,
/// and is NaN if there are none. A pair of rolls that goes up in the middle and down at the sides has left > 0 > right.
struct Rolls {
  double left = 0.0, right = 0.0;
};
Rolls rolls_of(const VelocityField& field);

/// Mean of the rolls of single films, and its standard error, which is NaN for one film. Films without a curl are left
/// out.
struct MeanRolls {
  Rolls mean, error;
};
MeanRolls mean_rolls(Films films, std::size_t phase, std::size_t phases);

}  // namespace sigmasweep
