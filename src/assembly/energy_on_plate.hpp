#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"

namespace sigmasweep {

/// Of a column at time t, of which the overlaps and their rates are relative to the plate: kinetic energy in the room's
/// frame, that of gravity (0 for touching beads on the plate's middle position), and that of the springs,
/// K x^(2 + beta)/(2 + beta). Masses over the mean bead's.
inline double energy_on_plate(const Column<double>& column, const Plate& plate, double t, std::span<const double> x,
                              std::span<const double> u) {
  const double power = 2.0 + column.exponents.beta;
  double height = plate.height(t), speed = plate.speed(t), sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    height -= x[k];
    speed -= u[k];
    sum += (0.5 * speed * speed + plate.g * height) / column.inverse_mass(k);
    if (x[k] > 0.0) sum += column.spring(k) * std::pow(x[k], power) / power;
  }
  return sum;
}

}  // namespace sigmasweep
