#pragma once

#include <string>

namespace sigmasweep {

/// This process's rank as the launcher tells it, before or without MPI_Init; 0 outside of mpirun and srun.
int launched_rank();

/// Prints a message to standard error, on rank 0 only.
void complain(const std::string& message);

}  // namespace sigmasweep
