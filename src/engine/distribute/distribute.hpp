#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/distribute/byte_job.hpp"
#include "engine/distribute/wire.hpp"
#include "mpi/world.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {

/// Tasks that are computed on all ranks. A Task is a plain struct, which is sent to a worker as its bytes; an Answer is
/// a plain struct or a vector of plain structs, which is sent back.
template <class Task, class Answer>
struct Job {
  /// Makes the task of an index of the schedule. On the manager.
  std::function<Task(std::uint64_t index, double predicted_seconds)> task;
  /// Computes a task; must not throw. On workers, and on a thread of the manager. A task that takes long asks
  /// `should_end` now and then whether it is to end at once, and if so gives no answer.
  std::function<std::optional<Answer>(const Task&, const std::function<bool()>& should_end)> compute;
  /// Is called for each answer as it comes in; must not throw. On the manager.
  std::function<void(const Answer&)> finished;
  /// Whether to begin no further task. Polled on every rank.
  std::function<bool()> stop;
  /// Longest predicted CPU time, s, of a chunk that may be handed out now. On the manager. Empty: no limit. As long as
  /// it is positive and nothing has been handed out yet, the shortest task is, however long: predictions may be wrong.
  std::function<double()> max_seconds{};
  /// Is called at most once, on the manager, when ranks that were told to quit have not answered for long. They may
  /// never do: the function should end them, and this process. If it returns, the manager goes on waiting.
  std::function<void(const std::vector<SilentRank>&)> silent{};
  Patience patience{};
  bool manager_computes = true;
};

/// The same for tasks and answers that are bytes.
void distribute_bytes(const World& world, Schedule* schedule, const ByteJob& job);

/// Hands out the tasks of `schedule` (the manager's; unused elsewhere) and returns on all ranks when everything handed
/// out has come back. When `stop` of any rank says so, no further task is begun: tasks in flight come back if they end
/// within half a second, the others and the rest of the chunks are dropped. A rank for which no chunk is short enough
/// gets none any more. Towards the end, tasks that are overdue are handed out a second time, to a rank that has nothing
/// to do; the first answer counts, and the other is dropped. With one rank the manager computes, whatever `job` says.
template <class Task, class Answer>
void distribute(const World& world, Schedule* schedule, const Job<Task, Answer>& job) {
  ByteJob bytes;
  bytes.append_task = [&job](std::uint64_t index, double predicted_seconds, wire::Bytes& message) {
    wire::append(message, job.task(index, predicted_seconds));
  };
  bytes.compute_first = [&job](std::span<const std::byte>& tasks, const std::function<bool()>& should_end,
                               wire::Bytes& answers) {
    Task task;
    wire::take(tasks, task);
    const std::optional<Answer> answer = job.compute(task, should_end);
    if (answer) wire::append(answers, *answer);
    return answer.has_value();
  };
  bytes.finished = [&job](std::span<const std::byte> answers, const std::function<bool()>& is_wanted) {
    for (Answer answer; !answers.empty();) {
      wire::take(answers, answer);
      if (is_wanted()) job.finished(answer);
    }
  };
  bytes.stop = job.stop;
  bytes.max_seconds = job.max_seconds;
  bytes.silent = job.silent;
  bytes.patience = job.patience;
  bytes.manager_computes = job.manager_computes;
  distribute_bytes(world, schedule, bytes);
}

}  // namespace sigmasweep
