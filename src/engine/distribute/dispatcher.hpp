#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "engine/distribute/tasks_out.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// Decides which rank gets which tasks of a schedule, the largest first. It sends nothing and knows no clock but the
/// one of TasksOut: its owner brings the messages.
///
/// A rank whose chunk is short has the next chunk waiting beside it, so that it never waits for the manager. Behind a
/// long chunk (prefetch_seconds) nothing waits: compared with it the manager's reply is instant, and a second long
/// chunk in the same queue would leave the other ranks idle at the end.
///
/// Predictions may be wrong by a factor of hundreds. So the tasks that are handed out are not settled: when nothing is
/// left, a rank that has nothing to do gets half of the tasks that wait at the rank where most work waits (work
/// stealing, R. D. Blumofe & C. E. Leiserson, J. ACM 46, 720 (1999), with a manager that knows all queues).
class Dispatcher {
 public:
  using Tasks = std::vector<ScheduledTask>;

  /// `max_seconds`, if there is one, gives the longest predicted time, s, of a chunk that may be handed out now.
  Dispatcher(Schedule& schedule, int ranks, std::function<double()> max_seconds = {});

  /// Tasks that are handed out to the rank now, to be computed in this order; none if it has enough, or if there are
  /// none.
  Tasks next(int rank);
  /// Tasks that other ranks should have answered long ago, for a rank that has nothing to do
  /// (TasksOut::take_overdue()).
  Tasks next_overdue(int rank, double seconds);
  /// The rank has answered its first task. False if another rank has answered it before.
  bool answered(int rank);
  /// Answers of the rank have come in just now.
  void heard_from(int rank) { out_.heard_from(rank); }

  /// A rank that is to give back half of the tasks that it has not begun, if there is one; it is not named again before
  /// it has answered.
  std::optional<int> next_to_give_back();
  /// The rank has given back the last so many of its tasks. Throws BadMessage if it has not got so many.
  void given_back(int rank, std::uint64_t count);

  const TasksOut& out() const { return out_; }
  bool is_idle(int rank) const { return out_.count(rank) == 0; }
  /// How many ranks have been asked for tasks in the last seconds, and have not answered. A silent rank never does.
  int asked() const;
  bool is_asked(int rank) const { return rank_[static_cast<std::size_t>(rank)].is_asked; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Rank {
    std::size_t last_chunk_tasks = 0;
    double last_chunk_seconds = 0.0;  ///< predicted
    bool is_asked = false;            ///< to give back tasks
    Clock::time_point asked_at{};
    bool has_none = false;  ///< gave back none, and has neither answered nor got any since it was asked
  };
  bool wants_chunk(int rank) const;
  Tasks next_from_pool(double max_seconds);
  Schedule::Chunk next_piece();
  Schedule::Chunk next_chunk();
  Tasks hand_out(int rank, Tasks tasks);

  Schedule& schedule_;
  std::function<double()> max_seconds_;
  std::vector<Rank> rank_;
  TasksOut out_;
  Schedule::Chunk piece_{};  // of the schedule's chunk, still to be handed out
  Tasks pool_;               // given back
  bool handed_out_ = false;  // anything at all
};

}  // namespace sigmasweep
