#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "sweep/schedule.hpp"

namespace sigmasweep {

/// The tasks that have been handed out and are not back yet, by rank. A rank answers its tasks in the order in which it
/// got them. A task may be out several times, on as many ranks: then the first answer counts.
class TasksOut {
 public:
  using Task = ScheduledTask;

  explicit TasksOut(int ranks) : rank_(static_cast<std::size_t>(ranks)) {}

  void hand_out(int rank, const Task& task);
  std::size_t count(int rank) const { return rank_[static_cast<std::size_t>(rank)].tasks.size(); }
  /// Predicted time of the tasks of a rank, but for the first, which it may have begun; s.
  double seconds_waiting(int rank) const;
  /// Takes off the first task of a rank, which has answered it. False if that was answered before, by another rank.
  bool answered(int rank);
  /// Answers of a rank have come in just now.
  void heard_from(int rank) { rank_[static_cast<std::size_t>(rank)].since = Clock::now(); }
  /// Takes off the last tasks of a rank, which has given them back. Returns, in order, those that no other rank has.
  /// Throws BadMessage if there are not so many.
  std::vector<Task> given_back(int rank, std::uint64_t count);
  /// Whether there is an answer to each task.
  bool all_are_back() const;
  /// The first task of a rank to which there is no answer; nothing if the rank has none.
  std::optional<std::uint64_t> first_missing(int rank) const;
  /// All tasks of a rank that has not answered for longer than `seconds`, and than four times the predicted time of its
  /// next task; empty if there is no such rank. They are to be handed out once more; again only if that copy has been
  /// out for as long, because its rank may be silent, too.
  std::vector<Task> take_overdue(double seconds);

 private:
  using Clock = std::chrono::steady_clock;
  struct Rank {
    std::deque<Task> tasks;
    double seconds = 0.0;       ///< predicted, of all of them
    Clock::time_point since{};  ///< when the first of them was begun, at the earliest
  };
  bool is_missing(const Task& task) const;
  static bool is_overdue(const Task& next, Clock::time_point since, double seconds);

  std::vector<Rank> rank_;
  /// A task that is, or was, with several ranks.
  struct Copies {
    bool is_answered = false;
    int out = 2;
    Clock::time_point since{};  ///< when the last one was handed out
  };
  std::map<std::uint64_t, Copies> copied_;  ///< by row
};

}  // namespace sigmasweep
