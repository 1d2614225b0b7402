#include "store/run_notes/machine.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>
#include <string>

namespace sigmasweep {
namespace {

struct ProcessState {
  char state = '\0';        ///< 'Z' has ended; '\0' unknown
  std::uint64_t start = 0;  ///< clock ticks
};

/// Reads /proc/ID/stat (proc(5)): "ID (NAME) STATE ..."; the start is the 22nd word. The name may hold spaces and
/// parentheses.
ProcessState state_of(std::int64_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::string line;
  std::getline(file, line);
  const auto name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream words(line.substr(name_end + 1));
  ProcessState found;
  words >> found.state;
  std::string word;
  for (int number = 4; number < 22; ++number) words >> word;
  words >> found.start;
  return words ? found : ProcessState{};
}

}  // namespace

Machine this_machine() {
  Machine machine;
  std::ifstream("/proc/sys/kernel/random/boot_id").getline(machine.boot.data(), machine.boot.size());
  struct stat status {};
  if (::stat("/proc/self/ns/pid", &status) == 0) machine.process_namespace = status.st_ino;
  return machine;
}

Process this_process() { return {::getpid(), state_of(::getpid()).start}; }

bool exists(const Process& process) {
  if (::kill(static_cast<pid_t>(process.id), 0) != 0 && errno == ESRCH) return false;
  const ProcessState found = state_of(process.id);
  if (found.state == '\0') return true;  // of another user, and hidden
  return found.state != 'Z' && found.state != 'X' && (process.start == 0 || found.start == process.start);
}

std::int64_t monotonic_nanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace sigmasweep
