#include "solve/solvers.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace sigmasweep {

std::span<const Solver* const> solvers() {
  static constexpr std::array table{
      &linear_column,      &linear_column_on_plate,       // exact/linear
      &power_law_column,   &power_law_column_on_plate,    // exact/power_law
      &lattice_events,     &lattice_events_on_plate,      // exact/lattice
      &fixed_step_column,  &fixed_step_column_on_plate,   // fixed_step
      &fixed_step_lattice, &fixed_step_lattice_on_plate,  // fixed_step
      &hard_spheres,       &hard_spheres_on_plate,        // hard_spheres
  };
  return table;
}

const Solver& solver_of(const Parameters& parameters) {
  const auto all = solvers();
  const auto first = std::ranges::find_if(all, [&](const Solver* solver) { return solver->solves(parameters); });
  if (first == all.end()) throw std::logic_error("solver_of: no solver for these parameters");
  return **first;
}

}  // namespace sigmasweep
