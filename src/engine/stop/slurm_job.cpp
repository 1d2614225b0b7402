#include "engine/stop/slurm_job.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "base/duration.hpp"
#include "base/process.hpp"

namespace sigmasweep {
namespace {

SlurmJob ask_squeue(const std::string& job) {
  std::optional<std::string> left = output_of({"squeue", "-h", "-j", job, "-o", "%L"}, std::chrono::seconds(10));
  if (left) left->erase(left->find_last_not_of(" \n") + 1);
  if (!left || left->empty())
    return {job, std::nullopt, "squeue does not say when this job ends: running on as if it had no time limit"};
  if (left->find(':') == left->npos) return {job, std::nullopt, {}};  // UNLIMITED, NOT_SET
  return {job, parse_duration(*left), {}};
}

}  // namespace

SlurmJob ask_slurm() {
  const char* job = std::getenv("SLURM_JOB_ID");
  if (job == nullptr) return {};
  const char* end = std::getenv("SLURM_JOB_END_TIME");
  if (end == nullptr) return ask_squeue(job);
  const auto now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const auto end_time = parse_duration(end);
  if (!end_time) return {job, std::nullopt, fmt::format("SLURM_JOB_END_TIME = '{}' is no time: it is ignored", end)};
  // A shell that outlives its job (tmux, an editor's terminal) keeps the job's variables.
  constexpr double long_ago = 600.0;
  if (now - *end_time > long_ago)
    return {job, std::nullopt,
            fmt::format("SLURM_JOB_END_TIME was {} ago: that job is over, and its end is ignored",
                        readable_duration(now - *end_time))};
  return {job, *end_time > now ? *end_time - now : 0.0, {}};
}

}  // namespace sigmasweep
