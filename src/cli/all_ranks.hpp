#pragma once

#include <functional>

#include "mpi/world.hpp"

namespace sigmasweep {

/// Starts MPI, runs a command on all ranks and returns its exit code. An Error that is thrown on the manager alone is
/// printed there; one that is thrown on another rank ends all ranks.
int on_all_ranks(int& argc, char**& argv, const std::function<int(World&)>& command);

}  // namespace sigmasweep
