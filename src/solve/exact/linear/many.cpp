#include "solve/exact/linear/many.hpp"

#include <cstddef>
#include <vector>

#include "solve/exact/linear/collision.hpp"
#include "solve/exact/linear/side_by_side/batch.hpp"

namespace sigmasweep {
namespace {

bool is_good(const SimulationResult& c, const Parameters& p) {
  return c.status == Status::ok && c.eps_eff_error <= p.tolerance;
}

}  // namespace

SimulationResult simulate_linear(const Parameters& p, ComputeBudget* budget) {
  if (goes_side_by_side(p)) {
    SimulationResult c;
    simulate_side_by_side({&p, 1}, {&c, 1}, 1);
    if (is_good(c, p)) return c;
  }
  return simulate_exact(p, budget);
}

void simulate_linear_many(std::span<const Parameters> parameters, std::span<SimulationResult> results) {
  std::vector<std::size_t> places;
  std::vector<Parameters> tuples;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (goes_side_by_side(parameters[i])) {
      places.push_back(i);
      tuples.push_back(parameters[i]);
    }
  std::vector<SimulationResult> theirs(tuples.size());
  simulate_side_by_side(tuples, theirs);
  for (std::size_t k = 0; k < places.size(); ++k)
    if (is_good(theirs[k], tuples[k])) results[places[k]] = theirs[k];
}

}  // namespace sigmasweep
