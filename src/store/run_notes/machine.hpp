#pragma once

#include <array>
#include <cstdint>

namespace sigmasweep {

/// A machine as long as it runs, and within it the processes that see each other: two containers of a machine may give
/// the same number to different processes.
struct Machine {
  std::array<char, 40> boot{};  ///< the kernel's name for this start of the machine; empty: unknown
  std::uint64_t process_namespace = 0;

  bool is_known() const { return boot[0] != '\0' && process_namespace != 0; }
  bool operator==(const Machine&) const = default;
};

Machine this_machine();

/// A process of a machine. Its number may be given again to another, which then starts later.
struct ProcessId {
  std::int64_t number = 0;
  std::uint64_t start = 0;  ///< clock ticks since the machine started; 0: unknown
};

ProcessId this_process();

/// Whether the process, which must be one of this machine, still exists. One that has ended but that its parent has not
/// asked for yet does not.
bool exists(const ProcessId& process);

/// The machine's monotonic clock, ns: the same for all its processes.
std::int64_t monotonic_nanoseconds();

}  // namespace sigmasweep
