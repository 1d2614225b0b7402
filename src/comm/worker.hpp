#pragma once

#include <vector>

#include "sigmasweep/comm/world.hpp"

namespace sigmasweep {

/// A worker's line to the manager; to another rank (RemoteLine) or to a thread of the same one (LocalWorker).
class Line {
 public:
  virtual ~Line() = default;
  /// The next tuples to compute, waiting for them if need be; empty when the manager has said quit.
  virtual std::vector<Tuple> next_chunk() = 0;
  /// Whether the manager has said quit. Cheap enough to ask after every millisecond of work, not after every tuple.
  virtual bool quit() = 0;
  virtual void deliver(std::vector<Row> rows) = 0;
  /// The last rows, maybe none.
  virtual void farewell(std::vector<Row> rows) = 0;
};

/// Computes chunks until the manager says quit. Rows go back at the end of each chunk, and of a long one as soon as a
/// tuple ends more than 0.2 s after the last delivery, so that the manager can store them.
void work(Line& line, const std::function<Row(const Tuple&)>& compute);

/// A worker on a rank of its own.
void work_remotely(const World& world, const Job& job);

}  // namespace sigmasweep
