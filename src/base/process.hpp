#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sigmasweep {

/// Descriptors of a program's standard streams; -1: /dev/null.
struct StandardStreams {
  int in = -1, out = -1, err = -1;
};

/// A program that runs beside this one. No shell is involved.
class Process {
 public:
  /// Starts words[0], which is looked for in PATH, with the other words as its arguments. Throws std::system_error; its
  /// code is ENOENT where there is no such program.
  Process(std::vector<std::string> words, const StandardStreams& streams);
  /// Waits for its end. Returns its exit status, -1 if a signal ended it. 0 where the system keeps no status, because
  /// SIGCHLD is ignored.
  int wait();
  /// The same, but the program is killed if it has not ended by then.
  int wait_until(std::chrono::steady_clock::time_point end);

 private:
  int id_ = -1;
};

/// What the kernel tells of a process: /proc/ID/stat, proc(5).
struct ProcessStat {
  std::string name;
  char state = '\0';  ///< 'Z': it has ended; '\0': nothing is known
  std::int64_t parent = 0;
  std::uint64_t start = 0;  ///< clock ticks since the machine started
};
ProcessStat stat_of_process(std::int64_t id);

/// The standard output of a program; nothing if it does not end well within `limit`.
std::optional<std::string> output_of(std::vector<std::string> words, std::chrono::steady_clock::duration limit);

}  // namespace sigmasweep
