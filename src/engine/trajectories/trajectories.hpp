#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/stop/stop.hpp"
#include "mpi/world.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// The trajectories of a run: one file for each row that the spec's [trajectory] chooses, beside the table.
namespace sigmasweep {

/// Before a run, on the manager: a file that is there must be of this spec, as far as that can be said before its row
/// is computed; nobody should wait for hours to hear that it is not. Throws OutputError.
void require_own_trajectories(const Sweep& sweep, const std::string& table);
/// Instead, for a run that starts again: those of an earlier run go, or a stop would leave a mixture.
void remove_trajectories(const Sweep& sweep, const std::string& table);

/// How many trajectories a run has recorded.
struct TrajectoryCount {
  std::uint64_t wanted = 0;   ///< rows that the spec chooses and that have a result
  std::uint64_t written = 0;  ///< files of these rows that are there; fewer if the run was stopped
};

/// After the run, on all ranks, `rows` the manager's finished rows in spec order: the ranks take turns in writing what
/// is not there yet. Ends early when any rank is asked to stop; what is written stays. A file that is there and is not
/// what would be written is an OutputError. All ranks throw the same error.
TrajectoryCount write_trajectories(const World& world, const Sweep& sweep, const std::string& table,
                                   const std::vector<Row>& rows, const StopRequest& stop);

}  // namespace sigmasweep
