#pragma once

#include <vector>

#include "mpi/world.hpp"

namespace sigmasweep {

using Compute = decltype(Job::compute);

/// A worker's line to the manager; to another rank (RemoteLine) or to a thread of the same one (LocalWorker).
class Line {
 public:
  virtual ~Line() = default;
  /// The next tuples to compute, waiting for them if need be; empty when the manager has said quit.
  virtual std::vector<Tuple> next_chunk() = 0;
  /// Whether the manager has said quit. Cheap enough to ask after every millisecond of work, not after every tuple.
  virtual bool quit() = 0;
  /// Whether quit() is so, or is to be expected: this rank has asked for it.
  virtual bool expects_quit() { return quit(); }
  virtual void deliver(std::vector<Row> rows) = 0;
  /// The last rows, maybe none.
  virtual void farewell(std::vector<Row> rows) = 0;
};

/// Computes chunks until the manager says quit; a tuple that does not end within half a second of that is dropped. Rows
/// go back at the end of each chunk, and of a long one as soon as a tuple ends more than 0.2 s after the last delivery,
/// so that the manager can store them.
void work(Line& line, const Compute& compute);

/// A worker on a rank of its own.
void work_remotely(const World& world, const Job& job);

}  // namespace sigmasweep
