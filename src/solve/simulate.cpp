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

/// Results of those tuples, by their places in `parameters`, that one solver computes side by side.
void run_side_by_side(const Solver& solver, std::span<const Parameters> parameters, std::span<SimulationResult> results,
                      const std::vector<std::size_t>& places) try {
  std::vector<Parameters> tuples;
  for (const std::size_t i : places) tuples.push_back(parameters[i]);
  std::vector<SimulationResult> theirs(tuples.size(), without_result(Status::not_run));
  solver.run_many(tuples, theirs);
  for (std::size_t k = 0; k < places.size(); ++k) results[places[k]] = theirs[k];
} catch (...) {  // memory, most likely; they are computed one by one
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

void simulate_together(std::span<const Parameters> parameters, std::span<SimulationResult> results) {
  if (parameters.size() != results.size()) throw std::invalid_argument("simulate_together: one result for each tuple");
  std::ranges::fill(results, without_result(Status::not_run));
  std::vector<std::vector<std::size_t>> places(solvers().size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto solver = std::ranges::find(solvers(), &solver_of(parameters[i]));
    if ((*solver)->run_many && why_invalid(parameters[i]).empty())
      places[static_cast<std::size_t>(solver - solvers().begin())].push_back(i);
  }
  for (std::size_t s = 0; s < places.size(); ++s)
    if (!places[s].empty()) run_side_by_side(*solvers()[s], parameters, results, places[s]);
}

void simulate_many(std::span<const Parameters> parameters, std::span<SimulationResult> results,
                   std::span<ComputeBudget> budgets) {
  if (parameters.size() != results.size() || (!budgets.empty() && budgets.size() != results.size()))
    throw std::invalid_argument("simulate_many: one result, and one budget, for each tuple");
  simulate_together(parameters, results);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (results[i].status != Status::not_run) continue;
    ComputeBudget* const budget = budgets.empty() ? nullptr : &budgets[i];
    results[i] = simulate(parameters[i], budget);
    if (budget && budget->was_stopped()) return;
  }
}

}  // namespace sigmasweep
