#pragma once

#include "assembly/ground.hpp"
#include "sigmasweep/model/result.hpp"

namespace sigmasweep {

/// What a run of soft spheres on a plate (of a column or a lattice) and the statistics of it are for the tuple.
template <class AnyOutcome, class Statistics>
SimulationResult vibrated_result(const AnyOutcome& outcome, const Statistics& statistics, const VibrationUnits& units) {
  SimulationResult c;
  c.contacts = outcome.contacts;
  c.end = outcome.end;
  c.status = outcome.status;
  if (c.status != Status::ok) return c;
  c.x_max = outcome.x_max * units.length;
  c.vibration = statistics.result();
  return c;
}

}  // namespace sigmasweep
