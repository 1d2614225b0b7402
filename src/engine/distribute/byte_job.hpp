#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/distribute/wire.hpp"

namespace sigmasweep {

/// A rank that does not answer, and the first of its tasks to which there is no answer, if there is one.
struct SilentRank {
  int rank = 0;
  std::optional<std::uint64_t> task{};
};

/// How long the manager waits, s.
struct Patience {
  double silent = 30.0;   ///< for the last answers of a rank that was told to quit
  double overdue = 20.0;  ///< for an answer, where others have nothing to do
};

/// A Job whose tasks and answers are bytes: what the manager and the workers see of it. distribute.hpp says what each
/// member is for.
struct ByteJob {
  using Bytes = wire::Bytes;
  std::size_t task_size = 0;  ///< bytes
  /// Appends the task to a message.
  std::function<void(std::uint64_t index, double predicted_seconds, Bytes& message)> append_task;
  /// The number of the first of `tasks` that are computed together.
  std::function<std::size_t(std::span<const std::byte> tasks)> batch_size;
  /// Computes the first of these tasks, and appends their answers. Returns the number of tasks: at least one unless
  /// `should_end` says so.
  std::function<std::size_t(std::span<const std::byte> tasks, const std::function<bool()>& should_end, Bytes& answers)>
      compute;
  /// Hands on the answers of a message that are wanted. `is_wanted` must be asked once for each of them.
  std::function<void(std::span<const std::byte> answers, const std::function<bool()>& is_wanted)> finished;
  std::function<bool()> stop;
  std::function<double()> max_seconds;
  std::function<void(const std::vector<SilentRank>&)> silent;
  Patience patience{};
  bool manager_computes = true;
};

}  // namespace sigmasweep
