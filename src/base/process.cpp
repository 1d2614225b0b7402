#include "base/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>

#include "base/file.hpp"

extern char** environ;

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;

void require(int error, const char* action) {
  if (error != 0) throw std::system_error(error, std::generic_category(), action);
}

/// The program's standard streams, as posix_spawn wants them.
class SpawnActions {
 public:
  SpawnActions() { require(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init"); }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  void connect(int descriptor, int stream, int null_flags) {
    if (descriptor < 0)
      require(posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", null_flags, 0), "addopen");
    else
      require(posix_spawn_file_actions_adddup2(&actions_, descriptor, stream), "adddup2");
  }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

int exit_status(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

/// Reads until the other end is closed or the time is up; nothing if the time is up.
std::optional<std::string> read_all(int fd, Clock::time_point end) {
  std::string text;
  std::array<char, 256> buffer;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd ready{.fd = fd, .events = POLLIN, .revents = 0};
    const int count = left > 0 ? ::poll(&ready, 1, static_cast<int>(left)) : 0;
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

Process::Process(std::vector<std::string> words, const StandardStreams& streams) {
  SpawnActions actions;
  actions.connect(streams.in, STDIN_FILENO, O_RDONLY);
  actions.connect(streams.out, STDOUT_FILENO, O_WRONLY);
  actions.connect(streams.err, STDERR_FILENO, O_WRONLY);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = -1;
  require(posix_spawnp(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ), arguments[0]);
  id_ = child;
}

int Process::wait() {
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0)
    if (errno != EINTR) return 0;
  return exit_status(status);
}

int Process::wait_until(Clock::time_point end) {
  for (int status = 0;;) {
    const pid_t ended = ::waitpid(id_, &status, WNOHANG);
    if (ended == id_) return exit_status(status);
    if (ended < 0 && errno != EINTR) return 0;
    if (Clock::now() >= end && ::kill(id_, SIGKILL) == 0) return wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// "ID (NAME) STATE PARENT ..."; the start is the 22nd word. The name may hold spaces and parentheses.
ProcessStat stat_of_process(std::int64_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::string line;
  std::getline(file, line);
  const auto begin = line.find('('), end = line.rfind(')');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  std::istringstream words(line.substr(end + 1));
  ProcessStat found{.name = line.substr(begin + 1, end - begin - 1)};
  words >> found.state >> found.parent;
  std::string word;
  for (int number = 5; number < 22; ++number) words >> word;
  words >> found.start;
  return words ? found : ProcessStat{};
}

std::optional<std::string> output_of(std::vector<std::string> words, Clock::duration limit) {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  const File reading(ends[0]);
  File writing(ends[1]);
  try {
    Process program(std::move(words), {.out = writing.fd()});
    writing.close();
    const auto end = Clock::now() + limit;
    std::optional<std::string> text = read_all(reading.fd(), end);
    if (program.wait_until(text ? end : Clock::now()) != 0) text.reset();
    return text;
  } catch (const std::system_error&) {
    return std::nullopt;
  }
}

}  // namespace sigmasweep
