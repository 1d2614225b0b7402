#include "store/run_notes/machine.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>

#include "base/process.hpp"

namespace sigmasweep {

Machine this_machine() {
  Machine machine;
  std::ifstream("/proc/sys/kernel/random/boot_id").getline(machine.boot.data(), machine.boot.size());
  struct stat status {};
  if (::stat("/proc/self/ns/pid", &status) == 0) machine.process_namespace = status.st_ino;
  return machine;
}

ProcessId this_process() { return {::getpid(), stat_of_process(::getpid()).start}; }

bool exists(const ProcessId& process) {
  if (::kill(static_cast<pid_t>(process.number), 0) != 0 && errno == ESRCH) return false;
  const ProcessStat found = stat_of_process(process.number);
  if (found.state == '\0') return true;  // of another user, and hidden
  return found.state != 'Z' && found.state != 'X' && (process.start == 0 || found.start == process.start);
}

std::int64_t monotonic_nanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace sigmasweep
