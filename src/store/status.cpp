#include "store/status.hpp"

#include <cmath>
#include <utility>

namespace sigmasweep {

std::string_view SweepStatus::state() const {
  if (stored.complete) return "complete";
  return is_running() ? "running" : "stopped";
}

std::optional<double> SweepStatus::rows_per_second() const {
  if (!is_running() || !(run->progress.seconds > 0.0)) return std::nullopt;
  return static_cast<double>(run->progress.done) / run->progress.seconds;
}

std::optional<double> SweepStatus::seconds_left() const {
  if (stored.complete) return 0.0;
  if (!is_running() || std::isnan(run->progress.seconds_left)) return std::nullopt;
  return run->progress.seconds_left;
}

SweepStatus status_of_sweep(const std::string& table, std::chrono::milliseconds patience) {
  auto run = look_at_run(table, patience);
  // Afterwards: a run that has ended meanwhile has left its table, or all its rows.
  SweepStatus status{read_stored_rows(table), std::move(run)};
  const bool is_of_this_sweep = status.run && status.run->spec_hash == status.stored.table.info.spec_hash;
  if (status.stored.complete || !is_of_this_sweep) status.run.reset();
  return status;
}

}  // namespace sigmasweep
