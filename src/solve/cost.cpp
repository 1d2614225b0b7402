#include "sigmasweep/solve/cost.hpp"

#include "solve/solvers.hpp"

namespace sigmasweep {

double predicted_time(const Parameters& parameters) { return solver_of(parameters).predicted_seconds(parameters); }

}  // namespace sigmasweep
