#include "engine/distribute/tasks_out.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/distribute/wire.hpp"

namespace sigmasweep {

void TasksOut::hand_out(int rank, const Task& task) {
  Rank& to = rank_[static_cast<std::size_t>(rank)];
  if (to.tasks.empty()) to.since = Clock::now();
  to.tasks.push_back(task);
  to.seconds += task.predicted_seconds;
}

double TasksOut::seconds_waiting(int rank) const {
  const Rank& of = rank_[static_cast<std::size_t>(rank)];
  return of.tasks.size() < 2 ? 0.0 : of.seconds - of.tasks.front().predicted_seconds;
}

bool TasksOut::answered(int rank) {
  Rank& from = rank_[static_cast<std::size_t>(rank)];
  const Task task = from.tasks.front();
  from.tasks.pop_front();
  from.seconds -= task.predicted_seconds;
  const auto copies = copied_.find(task.row);
  return copies == copied_.end() || !std::exchange(copies->second.is_answered, true);
}

std::vector<TasksOut::Task> TasksOut::given_back(int rank, std::uint64_t count) {
  Rank& from = rank_[static_cast<std::size_t>(rank)];
  if (count > from.tasks.size()) throw wire::BadMessage();
  const auto first = from.tasks.end() - static_cast<std::ptrdiff_t>(count);
  std::vector<Task> alone;
  for (auto task = first; task != from.tasks.end(); ++task) {
    from.seconds -= task->predicted_seconds;
    const auto copies = copied_.find(task->row);
    if (copies == copied_.end())
      alone.push_back(*task);
    else if (!copies->second.is_answered && --copies->second.out == 1)
      copied_.erase(copies);  // another rank has it alone now
  }
  from.tasks.erase(first, from.tasks.end());
  return alone;
}

bool TasksOut::is_missing(const Task& task) const {
  const auto copies = copied_.find(task.row);
  return copies == copied_.end() || !copies->second.is_answered;
}

bool TasksOut::all_are_back() const {
  return std::ranges::none_of(rank_, [this](const Rank& rank) {
    return std::ranges::any_of(rank.tasks, [this](const Task& task) { return is_missing(task); });
  });
}

std::optional<std::uint64_t> TasksOut::first_missing(int rank) const {
  for (const Task& task : rank_[static_cast<std::size_t>(rank)].tasks)
    if (is_missing(task)) return task.row;
  return std::nullopt;
}

bool TasksOut::is_overdue(const Task& next, Clock::time_point since, double seconds) {
  const double waited = std::chrono::duration<double>(Clock::now() - since).count();
  return waited > std::max(seconds, 4.0 * next.predicted_seconds);
}

std::vector<TasksOut::Task> TasksOut::take_overdue(double seconds) {
  std::vector<Task> overdue;
  for (const Rank& rank : rank_) {
    if (!overdue.empty()) break;
    if (rank.tasks.empty() || !is_overdue(rank.tasks.front(), rank.since, seconds)) continue;
    for (const Task& task : rank.tasks) {
      const auto [copies, is_first] = copied_.try_emplace(task.row);
      if (!is_first && (copies->second.is_answered || !is_overdue(task, copies->second.since, seconds))) continue;
      if (!is_first) ++copies->second.out;
      copies->second.since = Clock::now();
      overdue.push_back(task);
    }
  }
  return overdue;
}

}  // namespace sigmasweep
