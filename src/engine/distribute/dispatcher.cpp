#include "engine/distribute/dispatcher.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/distribute/wire.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t max_piece_tasks = 1024;       // of a message; at 10 us a task 10 ms of work
constexpr double prefetch_seconds = 0.05;           // fifty times the manager's longest sleep
constexpr auto patience = std::chrono::seconds(5);  // with a rank that is asked to give back tasks

}  // namespace

Dispatcher::Dispatcher(Schedule& schedule, int ranks, std::function<double()> max_seconds)
    : schedule_(schedule), max_seconds_(std::move(max_seconds)), rank_(static_cast<std::size_t>(ranks)), out_(ranks) {}

/// A rank that is asked to give back tasks gets none before it has answered: its answer counts from the end of the
/// tasks that it had when it was asked.
bool Dispatcher::wants_chunk(int rank) const {
  if (is_asked(rank)) return false;
  if (is_idle(rank)) return true;
  const Rank& its = rank_[static_cast<std::size_t>(rank)];
  return out_.count(rank) <= its.last_chunk_tasks && its.last_chunk_seconds < prefetch_seconds;
}

Dispatcher::Tasks Dispatcher::next(int rank) {
  if (!wants_chunk(rank)) return {};
  if (Tasks returned = next_from_pool(max_seconds_ ? max_seconds_() : std::numeric_limits<double>::infinity());
      !returned.empty())
    return hand_out(rank, std::move(returned));
  const Schedule::Chunk piece = next_piece();
  return hand_out(rank, {piece.begin(), piece.end()});
}

Dispatcher::Tasks Dispatcher::next_from_pool(double max_seconds) {
  Tasks some;
  std::erase_if(pool_, [&](const ScheduledTask& task) {
    const bool fits = some.size() < max_piece_tasks && task.predicted_seconds <= max_seconds;
    if (fits) some.push_back(task);
    return fits;
  });
  return some;
}

Schedule::Chunk Dispatcher::next_piece() {
  if (piece_.empty()) piece_ = next_chunk();
  const std::size_t tasks = std::min(max_piece_tasks, piece_.size());
  return std::exchange(piece_, piece_.subspan(tasks)).first(tasks);
}

Schedule::Chunk Dispatcher::next_chunk() {
  if (!max_seconds_) return schedule_.next();
  const double max_seconds = max_seconds_();
  Schedule::Chunk chunk = schedule_.next(max_seconds);
  if (chunk.empty() && !handed_out_ && max_seconds > 0.0) chunk = schedule_.shortest();
  handed_out_ = handed_out_ || !chunk.empty();
  return chunk;
}

bool Dispatcher::answered(int rank) {
  rank_[static_cast<std::size_t>(rank)].has_none = false;
  return out_.answered(rank);
}

Dispatcher::Tasks Dispatcher::next_overdue(int rank, double seconds) {
  return is_asked(rank) ? Tasks{} : hand_out(rank, out_.take_overdue(seconds));
}

Dispatcher::Tasks Dispatcher::hand_out(int rank, Tasks tasks) {
  if (tasks.empty()) return tasks;
  Rank& its = rank_[static_cast<std::size_t>(rank)];
  its.last_chunk_tasks = tasks.size();
  its.last_chunk_seconds = 0.0;
  its.has_none = false;
  for (const ScheduledTask& task : tasks) {
    its.last_chunk_seconds += task.predicted_seconds;
    out_.hand_out(rank, task);
  }
  return tasks;
}

int Dispatcher::asked() const {
  const auto since = Clock::now() - patience;
  return static_cast<int>(
      std::ranges::count_if(rank_, [since](const Rank& its) { return its.is_asked && its.asked_at > since; }));
}

std::optional<int> Dispatcher::next_to_give_back() {
  std::optional<int> most;
  for (int rank = 0; rank < static_cast<int>(rank_.size()); ++rank) {
    const Rank& its = rank_[static_cast<std::size_t>(rank)];
    if (out_.count(rank) < 2 || its.is_asked || its.has_none) continue;
    if (!most || out_.seconds_waiting(rank) > out_.seconds_waiting(*most)) most = rank;
  }
  if (!most) return most;
  rank_[static_cast<std::size_t>(*most)].is_asked = true;
  rank_[static_cast<std::size_t>(*most)].has_none = true;  // until more is known
  rank_[static_cast<std::size_t>(*most)].asked_at = Clock::now();
  return most;
}

void Dispatcher::given_back(int rank, std::uint64_t count) {
  Rank& its = rank_[static_cast<std::size_t>(rank)];
  if (!its.is_asked) throw wire::BadMessage();
  its.is_asked = false;
  if (count > 0) its.has_none = false;
  const Tasks tasks = out_.given_back(rank, count);
  pool_.insert(pool_.end(), tasks.begin(), tasks.end());
}

}  // namespace sigmasweep
