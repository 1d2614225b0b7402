#include "sweep/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <stdexcept>

namespace sigmasweep {

Schedule::Schedule(std::vector<std::uint64_t> rows, std::vector<double> predicted_seconds, int ranks,
                   double min_chunk_seconds, double max_chunk_seconds)
    : ranks_(ranks), min_chunk_(min_chunk_seconds), max_chunk_(std::max(min_chunk_seconds, max_chunk_seconds)) {
  if (rows.size() != predicted_seconds.size()) throw std::invalid_argument("Schedule: one prediction a row is needed");
  if (ranks < 1) throw std::invalid_argument("Schedule: at least one rank is needed");
  for (const double seconds : predicted_seconds)
    if (!(seconds > 0.0 && std::isfinite(seconds)))
      throw std::invalid_argument("Schedule: a prediction must be a finite number > 0");

  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return predicted_seconds[a] != predicted_seconds[b] ? predicted_seconds[a] > predicted_seconds[b]
                                                        : rows[a] < rows[b];
  });
  rows_.reserve(order.size());
  seconds_.reserve(order.size());
  for (const std::size_t i : order) {
    rows_.push_back(rows[i]);
    seconds_.push_back(predicted_seconds[i]);
    total_ += predicted_seconds[i];
  }
  longest_ = seconds_.empty() ? 0.0 : seconds_.front();
  left_ = total_;
  to_do_ = {0, rows_.size()};
}

std::size_t Schedule::chunk_end(Range rows, double& left, double max_seconds) const {
  const double target = std::min(std::clamp(left / (2.0 * ranks_), min_chunk_, max_chunk_), max_seconds);
  double chunk = 0.0;
  std::size_t end = rows.first;
  do chunk += seconds_[end++];
  while (end < rows.end && chunk + seconds_[end] <= target);
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
    const auto longer = std::partition_point(seconds_.begin() + static_cast<std::ptrdiff_t>(to_do_.first),
                                             seconds_.begin() + static_cast<std::ptrdiff_t>(to_do_.end),
                                             [&](double seconds) { return seconds > max_seconds; });
    const auto first = static_cast<std::size_t>(longer - seconds_.begin());
    pass_over({to_do_.first, first});
    if (first < to_do_.end) {
      to_do_.first = chunk_end({first, to_do_.end}, left_, max_seconds);
      return Chunk{rows_, seconds_}.from(first).first(to_do_.first - first);
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
  left_ = std::max(0.0, left_ - seconds_[last->end]);
  return Chunk{rows_, seconds_}.from(last->end).first(1);
}

double Schedule::total_seconds() const { return total_; }
double Schedule::longest_seconds() const { return longest_; }
double Schedule::lower_bound_seconds() const { return std::max(total_ / ranks_, longest_); }

double Schedule::predicted_makespan() const {
  using Times = std::vector<double>;
  std::priority_queue<double, Times, std::greater<>> free_at(std::greater<>{}, Times(static_cast<std::size_t>(ranks_)));
  double left = total_, last = 0.0;
  for (std::size_t first = 0; first < rows_.size();) {
    const std::size_t end = chunk_end({first, rows_.size()}, left, std::numeric_limits<double>::infinity());
    const auto chunk = seconds_.begin();
    const double done = std::accumulate(chunk + static_cast<std::ptrdiff_t>(first),
                                        chunk + static_cast<std::ptrdiff_t>(end), free_at.top());
    free_at.pop();
    free_at.push(done);
    last = std::max(last, done);
    first = end;
  }
  return last;
}

}  // namespace sigmasweep
