#include "engine/phases/limit_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/duration.hpp"
#include "engine/phases/phase.hpp"
#include "engine/stop/last_resort.hpp"
#include "engine/stop/slurm_job.hpp"

namespace sigmasweep {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// Seconds from now on until computing must be over.
double seconds_to_compute(const OpenSweep& open, std::optional<double> max_seconds, const Reporter& reporter) {
  const SlurmJob job = ask_slurm();
  if (!job.warning.empty()) reporter.warn(job.warning);
  const double gone = std::chrono::duration<double>(std::chrono::steady_clock::now() - open.steady_start).count();
  double seconds = std::min(max_seconds.value_or(forever) - gone, job.seconds_left.value_or(forever));
  if (std::isfinite(seconds)) seconds -= time_for_the_end(seconds, double(open.rows()) * double(sizeof(Row)));
  if (job.seconds_left) reporter.say(fmt::format("job {} ends in {}", job.id, readable_duration(*job.seconds_left)));
  return seconds;
}

}  // namespace

std::optional<Deadline> limit_time(const World& world, const OpenSweep& open, std::optional<double> max_seconds,
                                   StopRequest& stop, const Reporter& reporter) {
  double seconds = forever;
  on_manager(world, [&] { seconds = seconds_to_compute(open, max_seconds, reporter); });
  seconds = world.broadcast(seconds);
  if (!std::isfinite(seconds)) return std::nullopt;
  stop.end_in(seconds);
  LastResort::expect_stop_in(seconds);
  const double crowding = world.crowding();
  if (!world.is_manager()) return std::nullopt;
  return Deadline(stop.end(), crowding, open.ledger->learned());
}

}  // namespace sigmasweep
