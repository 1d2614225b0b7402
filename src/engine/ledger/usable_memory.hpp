#pragma once

namespace sigmasweep {

/// Memory, bytes, that this process may use: that of the machine, or the limit of its control group (a container, a
/// Slurm job) or of its address space (ulimit -v), if that is less.
double usable_memory();

}  // namespace sigmasweep
