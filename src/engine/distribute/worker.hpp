#pragma once

#include "engine/distribute/byte_job.hpp"

namespace sigmasweep {

/// A worker's connection to the manager: to another rank (RemoteConnection) or to a thread of the same rank
/// (ThreadWorker). It keeps the tasks that are not begun, because the manager may want some of them back at any moment.
class ManagerConnection {
 public:
  using Bytes = wire::Bytes;
  virtual ~ManagerConnection() = default;
  /// The next tasks to compute together, waiting for them if need be; empty when the manager has said quit.
  virtual Bytes next_batch() = 0;
  /// Puts tasks of the last batch back that were not computed.
  virtual void put_back(std::span<const std::byte> tasks) = 0;
  /// Whether the last batch was the end of a chunk.
  virtual bool is_between_chunks() = 0;
  /// Whether the manager has said quit. Cheap enough to ask after every millisecond of work, not after every task.
  virtual bool quit() = 0;
  /// Whether quit() is true or is to be expected, because this rank has asked for it.
  virtual bool expects_quit() { return quit(); }
  virtual void deliver(Bytes answers) = 0;
  /// Delivers the last answers, perhaps none.
  virtual void deliver_last(Bytes answers) = 0;
};

/// Computes chunks until the manager says quit. A task that does not end within half a second after that is dropped.
/// Answers go back at the end of each chunk; within a long chunk also as soon as a batch ends more than 0.2 s after the
/// last delivery, so that the manager can store them.
void work(ManagerConnection& manager, const ByteJob& job);

}  // namespace sigmasweep
