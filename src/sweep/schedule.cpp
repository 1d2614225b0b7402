#include "sweep/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace sigmasweep {

Schedule::Schedule(std::vector<ScheduledTask> tasks, int ranks, double min_chunk_seconds, double max_chunk_seconds)
    : tasks_(std::move(tasks)),
      ranks_(ranks),
      min_chunk_(min_chunk_seconds),
      max_chunk_(std::max(min_chunk_seconds, max_chunk_seconds)) {
  if (ranks < 1) throw std::invalid_argument("Schedule: at least one rank is needed");
  for (const ScheduledTask& task : tasks_)
    if (!(task.predicted_seconds > 0.0 && std::isfinite(task.predicted_seconds)))
      throw std::invalid_argument("Schedule: a prediction must be a finite number > 0");
  std::ranges::sort(tasks_, [](const ScheduledTask& a, const ScheduledTask& b) {
    return a.predicted_seconds != b.predicted_seconds ? a.predicted_seconds > b.predicted_seconds : a.row < b.row;
  });
  for (const ScheduledTask& task : tasks_) total_ += task.predicted_seconds;
  longest_ = tasks_.empty() ? 0.0 : tasks_.front().predicted_seconds;
  left_ = total_;
  to_do_ = {0, tasks_.size()};
}

std::size_t Schedule::chunk_end(Range rows, double& left, double max_seconds) const {
  const double target = std::min(std::clamp(left / (2.0 * ranks_), min_chunk_, max_chunk_), max_seconds);
  double chunk = 0.0;
  std::size_t end = rows.first;
  do chunk += tasks_[end++].predicted_seconds;
  while (end < rows.end && chunk + tasks_[end].predicted_seconds <= target);
  left = std::max(0.0, left - chunk);
  return end;
}

void Schedule::pass_over(Range rows) {
  if (rows.first == rows.end) return;
  if (!passed_over_.empty() && passed_over_.back().end == rows.first)
    passed_over_.back().end = rows.end;
  else
    passed_over_.push_back(rows);
}

Schedule::Chunk Schedule::next(double max_seconds) {
  for (std::size_t ranges = passed_over_.size() + 1; ranges > 0; --ranges) {
    const auto left = Chunk(tasks_).first(to_do_.end).subspan(to_do_.first);
    const auto longer = std::ranges::partition_point(
        left, [&](const ScheduledTask& task) { return task.predicted_seconds > max_seconds; });
    const std::size_t first = to_do_.first + static_cast<std::size_t>(longer - left.begin());
    pass_over({to_do_.first, first});
    if (first < to_do_.end) {
      to_do_.first = chunk_end({first, to_do_.end}, left_, max_seconds);
      return Chunk(tasks_).subspan(first, to_do_.first - first);
    }
    to_do_ = {};
    if (passed_over_.empty()) break;
    to_do_ = passed_over_.front();
    passed_over_.erase(passed_over_.begin());
  }
  return {};
}

Schedule::Chunk Schedule::shortest() {
  Range* last = &to_do_;  // rows are sorted, so the shortest is at the end of a range
  for (Range& range : passed_over_)
    if (range.first < range.end && (last->first == last->end || range.end > last->end)) last = &range;
  if (last->first == last->end) return {};
  --last->end;
  left_ = std::max(0.0, left_ - tasks_[last->end].predicted_seconds);
  return Chunk(tasks_).subspan(last->end, 1);
}

double Schedule::total_seconds() const { return total_; }
double Schedule::longest_seconds() const { return longest_; }
double Schedule::lower_bound_seconds() const { return std::max(total_ / ranks_, longest_); }

double Schedule::predicted_makespan() const {
  using Times = std::vector<double>;
  std::priority_queue<double, Times, std::greater<>> free_at(std::greater<>{}, Times(static_cast<std::size_t>(ranks_)));
  double left = total_, last = 0.0;
  for (std::size_t first = 0; first < tasks_.size();) {
    const std::size_t end = chunk_end({first, tasks_.size()}, left, std::numeric_limits<double>::infinity());
    double done = free_at.top();
    for (const ScheduledTask& task : Chunk(tasks_).subspan(first, end - first)) done += task.predicted_seconds;
    free_at.pop();
    free_at.push(done);
    last = std::max(last, done);
    first = end;
  }
  return last;
}

}  // namespace sigmasweep
