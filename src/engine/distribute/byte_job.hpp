#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "engine/distribute/wire.hpp"

namespace sigmasweep {

/// A Job whose tasks and answers are bytes: what the manager and the workers see of it. distribute.hpp says what each
/// member is for.
struct ByteJob {
  using Bytes = wire::Bytes;
  /// Appends the task to a message.
  std::function<void(std::uint64_t index, double predicted_seconds, Bytes& message)> append_task;
  /// Computes the first task of `tasks` and takes it off; appends its answer. False if the task was dropped.
  std::function<bool(std::span<const std::byte>& tasks, const std::function<bool()>& should_end, Bytes& answers)>
      compute_first;
  /// Hands on each answer of a message; returns how many there are.
  std::function<std::size_t(std::span<const std::byte> answers)> finished;
  std::function<bool()> stop;
  std::function<double()> max_seconds;
  bool manager_computes = true;
};

}  // namespace sigmasweep
