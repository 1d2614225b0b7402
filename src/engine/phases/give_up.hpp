#pragma once

#include <string>
#include <vector>

#include "engine/distribute/byte_job.hpp"
#include "engine/phases/open.hpp"
#include "engine/report/reporter.hpp"

namespace sigmasweep {

/// Ends a run some of whose ranks do not answer any more, with exit_code::stopped: brings the journal to the disk,
/// names the ranks and their rows, and ends all ranks. On the manager.
[[noreturn]] void give_up(const std::vector<SilentRank>& silent, OpenSweep& open, const Reporter& reporter);

/// The same for any rank, when the manager may be the silent one: does what is possible without it, and returns the
/// words for the user. For LastResort::prepare_by().
std::string give_up_without_manager(const std::string& table);
/// Whether the run's notes show a rank that does not answer.
bool is_some_rank_silent(const std::string& table);

}  // namespace sigmasweep
