#pragma once

#include <cstddef>
#include <span>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "contact/laws/power.hpp"

namespace sigmasweep {

/// Energy of a column on a plate at time t: kinetic energy in the frame of the laboratory, that of gravity (0 for
/// touching beads on the plate's middle position), and that of the springs, K x^(2 + beta)/(2 + beta). Overlaps x and
/// their rates u are relative to the plate. Masses are over the mean bead's.
inline double energy_on_plate(const Column<double>& column, const Plate& plate, double t, std::span<const double> x,
                              std::span<const double> u) {
  const PowerLaw law(column.exponents);
  double height = plate.height(t), speed = plate.speed(t), sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    height -= x[k];
    speed -= u[k];
    sum += (0.5 * speed * speed + plate.g * height) / column.inverse_mass(k);
    if (x[k] > 0.0) sum += law.elastic_energy(column.spring(k), x[k]);
  }
  return sum;
}

}  // namespace sigmasweep
