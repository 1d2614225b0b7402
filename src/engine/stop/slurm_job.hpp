#pragma once

#include <optional>
#include <string>

namespace sigmasweep {

/// The Slurm job that this process is part of, and its end.
struct SlurmJob {
  std::string id;                      ///< empty: no job
  std::optional<double> seconds_left;  ///< nothing: no job, no limit, or not known
  std::string warning;                 ///< one line, if the end should be known but is not
};

/// From SLURM_JOB_END_TIME (seconds since 1970) where Slurm sets it, else squeue is asked, which may take ten seconds.
SlurmJob ask_slurm();

}  // namespace sigmasweep
