#pragma once

#include <string>

namespace sigmasweep {

/// The rank of this process from the launcher's environment, before or without MPI_Init; 0 outside of mpirun and srun.
int launched_rank();

/// Prints a message to standard error, on rank 0 only.
void complain(const std::string& message);

}  // namespace sigmasweep
