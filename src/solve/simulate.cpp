#include "sigmasweep/solve/simulate.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "sigmasweep/assembly/validity.hpp"
#include "solve/solvers.hpp"

namespace sigmasweep {

namespace {

SimulationResult without_result(Status status) {
  SimulationResult nothing;
  nothing.status = status;
  return nothing;
}

/// simulate() for those tuples, by their places in `parameters`, that one solver solves.
void simulate_by(const Solver& solver, std::span<const Parameters> parameters, std::span<SimulationResult> results,
                 const std::vector<std::size_t>& places) {
  if (!solver.run_many) {
    for (const std::size_t i : places) results[i] = simulate(parameters[i]);
    return;
  }
  std::vector<Parameters> tuples;
  for (const std::size_t i : places) tuples.push_back(parameters[i]);
  std::vector<SimulationResult> theirs(tuples.size());
  solver.run_many(tuples, theirs);
  for (std::size_t k = 0; k < places.size(); ++k) results[places[k]] = theirs[k];
}

}  // namespace

SimulationResult simulate(const Parameters& parameters, ComputeBudget* budget) noexcept {
  try {
    if (!why_invalid(parameters).empty()) return without_result(Status::failed);
    const SimulationResult collision = solver_of(parameters).run(parameters, budget);
    return budget && budget->was_over() ? without_result(Status::time_limit) : collision;
  } catch (...) {  // memory, most likely
    return without_result(Status::failed);
  }
}

void simulate_many(std::span<const Parameters> parameters, std::span<SimulationResult> results) {
  if (parameters.size() != results.size()) throw std::invalid_argument("simulate_many: one result for each tuple");
  std::vector<std::vector<std::size_t>> places(solvers().size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    results[i] = without_result(Status::failed);
    if (!why_invalid(parameters[i]).empty()) continue;
    const auto solver = std::ranges::find(solvers(), &solver_of(parameters[i]));
    places[static_cast<std::size_t>(solver - solvers().begin())].push_back(i);
  }
  for (std::size_t s = 0; s < places.size(); ++s) simulate_by(*solvers()[s], parameters, results, places[s]);
}

}  // namespace sigmasweep
