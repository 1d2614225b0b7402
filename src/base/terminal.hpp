#pragma once

#include <optional>

namespace sigmasweep {

struct Terminal {
  int columns = 80;
};

/// The terminal that shows what this process writes to standard error, if there is one that a line may be redrawn on.
///
/// It is standard error itself, or what a launcher such as mpirun forwards it to: mpirun gives each rank a pipe, and
/// copies what comes out to its own standard error. So the ancestors of this process are asked for (proc(5)): one that
/// is a launcher by name, and has the other end of that pipe open, shows on its own standard error what we write. Of
/// MPICH this is a proxy, whose standard error is a pipe to mpiexec; it is asked for in the same way. None is found
/// where the launcher runs on another machine, or puts a label before each line (mpirun --tag-output,
/// --timestamp-output).
std::optional<Terminal> terminal_of_stderr();

}  // namespace sigmasweep
