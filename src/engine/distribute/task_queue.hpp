#pragma once

#include <cstddef>
#include <deque>
#include <span>

#include "engine/distribute/wire.hpp"

namespace sigmasweep {

/// The tasks that a worker has got and not begun, as bytes, in the chunks in which they came.
class TaskQueue {
 public:
  using Bytes = wire::Bytes;
  explicit TaskQueue(std::size_t task_size) : task_size_(task_size) {}

  /// Appends a chunk. Throws BadMessage unless it consists of whole tasks, at least one.
  void add(Bytes chunk);
  bool empty() const { return chunks_.empty(); }
  /// Whether nothing of the next chunk has been taken yet, or there is none.
  bool is_between_chunks() const { return taken_ == 0; }
  /// What is left of the first chunk.
  std::span<const std::byte> first_chunk() const { return std::span(chunks_.front()).subspan(taken_); }
  /// Takes off the first tasks, at most those of the first chunk.
  Bytes take(std::size_t tasks);
  /// Puts tasks back that were taken and not computed.
  void put_back(std::span<const std::byte> tasks);
  /// Takes off half of all tasks, rounded up, from the end. Returns the number.
  std::size_t give_half();

 private:
  std::size_t count() const;
  std::size_t task_size_;
  std::deque<Bytes> chunks_;
  std::size_t taken_ = 0;  ///< bytes of the first chunk
};

}  // namespace sigmasweep
