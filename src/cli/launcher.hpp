#pragma once

#include <string>

namespace sigmasweep {

/// What the launcher of this process (mpirun, srun) says in the environment, before or without MPI_Init.

/// This process's rank; 0 outside of mpirun and srun.
int launched_rank();

/// Says that the launcher is of another MPI than the program, if it is: it has started several processes, but MPI knows
/// of `mpi_size` = 1 alone, so that each would believe to be the whole run. Empty if all is well.
std::string why_wrong_launcher(int mpi_size);

}  // namespace sigmasweep
