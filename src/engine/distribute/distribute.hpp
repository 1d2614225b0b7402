#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

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
  /// Instead of compute(), where several tasks are computed together: a batch of the first of `tasks`, at least one of
  /// them. What is in a batch cannot be given back to ranks that have nothing to do.
  std::function<std::size_t(std::span<const Task> tasks)> batch_size{};
  /// Computes the first tasks of a batch, at least one of them unless `should_end` says so, and appends their answers.
  /// The others come again.
  std::function<void(std::span<const Task> batch, const std::function<bool()>& should_end, std::vector<Answer>&)>
      compute_batch{};
  /// Is called with answers as they come in; must not throw. On the manager.
  std::function<void(std::span<const Answer>)> finished;
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

/// The most tasks of a batch.
inline constexpr std::size_t max_batch = 256;

/// How the tasks of a job are computed, as members of a ByteJob.
template <class Task, class Answer>
void set_computing(ByteJob& bytes, const Job<Task, Answer>& job) {
  const auto first_of = [](std::span<const std::byte> tasks) {
    std::vector<Task> first(std::min(max_batch, tasks.size() / sizeof(Task)));
    for (Task& task : first) wire::take(tasks, task);
    return first;
  };
  if (!job.compute_batch) {
    bytes.batch_size = [](std::span<const std::byte>) { return std::size_t{1}; };
    bytes.compute = [&job](std::span<const std::byte> tasks, const std::function<bool()>& should_end,
                           wire::Bytes& answers) {
      Task task;
      wire::take(tasks, task);
      const std::optional<Answer> answer = job.compute(task, should_end);
      if (answer) wire::append(answers, *answer);
      return std::size_t{answer.has_value()};
    };
    return;
  }
  bytes.batch_size = [&job, first_of](std::span<const std::byte> tasks) { return job.batch_size(first_of(tasks)); };
  bytes.compute = [&job, first_of](std::span<const std::byte> tasks, const std::function<bool()>& should_end,
                                   wire::Bytes& answers) {
    std::vector<Answer> found;
    job.compute_batch(first_of(tasks), should_end, found);
    for (const Answer& answer : found) wire::append(answers, answer);
    return found.size();
  };
}

/// Hands out the tasks of `schedule` (the manager's; unused elsewhere) and returns on all ranks when everything handed
/// out has come back. When `stop` of any rank says so, no further task is begun: tasks in flight come back if they end
/// within half a second, the others and the rest of the chunks are dropped. A rank for which no chunk is short enough
/// gets none any more. A rank that has nothing to do, when all is handed out, gets half of the tasks that the rank with
/// most of them has not begun. Tasks that are overdue are handed out once more, to a rank that has nothing to do;
/// the first answer counts, and the other is dropped. With one rank the manager computes, whatever `job` says.
template <class Task, class Answer>
void distribute(const World& world, Schedule* schedule, const Job<Task, Answer>& job) {
  ByteJob bytes;
  bytes.task_size = sizeof(Task);
  bytes.append_task = [&job](std::uint64_t index, double predicted_seconds, wire::Bytes& message) {
    wire::append(message, job.task(index, predicted_seconds));
  };
  set_computing(bytes, job);
  bytes.finished = [&job](std::span<const std::byte> answers, const std::function<bool()>& is_wanted) {
    std::vector<Answer> wanted;
    for (Answer answer; !answers.empty();) {
      wire::take(answers, answer);
      if (is_wanted()) wanted.push_back(answer);
    }
    if (!wanted.empty()) job.finished(wanted);
  };
  bytes.stop = job.stop;
  bytes.max_seconds = job.max_seconds;
  bytes.silent = job.silent;
  bytes.patience = job.patience;
  bytes.manager_computes = job.manager_computes;
  distribute_bytes(world, schedule, bytes);
}

}  // namespace sigmasweep
