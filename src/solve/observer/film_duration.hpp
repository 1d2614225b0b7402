#pragma once

#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"

/// Durations of films, s; NaN for a row without a result. See show_time() for the rules.
namespace sigmasweep {

double film_of_column(const Parameters& parameters, const SimulationResult& collision);
double film_of_lattice(const Parameters& parameters, const SimulationResult& collision);
double film_on_plate(const Parameters& parameters, const SimulationResult& result);

}  // namespace sigmasweep
