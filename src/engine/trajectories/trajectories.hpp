#pragma once

#include <cstdint>
#include <string>

#include "engine/report/row_source.hpp"
#include "engine/stop/stop.hpp"
#include "mpi/world.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// The trajectories of a run: one file for each row that the spec's [trajectory] chooses, beside the table.
namespace sigmasweep {

/// Throws OutputError for a file that is there already and is not a trajectory of this spec, as far as that is known
/// before its row is computed: the user should hear of it before the run, not after. A `fresh` run may have any
/// trajectory there that remove_trajectories() removes. On the manager.
void require_own_trajectories(const Sweep& sweep, const std::string& table, bool fresh);
/// Removes the trajectories of an earlier run, for a run that starts again: a stop would leave a mixture otherwise.
/// Files of other names or other programs stay, and so does everything behind a symbolic link.
void remove_trajectories(const Sweep& sweep, const std::string& table);

/// How many trajectories a run has recorded.
struct TrajectoryCount {
  std::uint64_t wanted = 0;   ///< rows that the spec chooses and that have a result
  std::uint64_t written = 0;  ///< files of these rows that are there; fewer if the run was stopped
};

/// Records the trajectories that are not there yet; `rows` are the manager's finished rows in spec order. On all ranks,
/// which share the work. Ends early when a rank is asked to stop; files that are written stay. Throws OutputError for a
/// file that is there and is not the trajectory of its row. All ranks throw the same error.
TrajectoryCount write_trajectories(const World& world, const Sweep& sweep, const std::string& table,
                                   const RowSource& rows, const StopRequest& stop);

}  // namespace sigmasweep
