#include "engine/stop/slurm_job.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#include "base/duration.hpp"

extern char** environ;

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto budget = std::chrono::seconds(10);

/// Reads until the other end is closed or the time is up; nothing if it is.
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

/// Its exit status (0 where the system keeps none: SIGCHLD is ignored); it is killed if it has none in time.
int end_of(pid_t child, Clock::time_point end) {
  int status = 0;
  bool killed = false;
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, killed ? 0 : WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR) return 0;
    if (!killed && Clock::now() >= end) killed = ::kill(child, SIGKILL) == 0;
    if (!killed) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// What the program prints, if it ends in time and well. No shell is involved.
std::optional<std::string> output_of(std::vector<std::string> words) {
  std::array<int, 2> pipe_ends;
  if (::pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = -1;
  const int error = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe_ends[1]);
  std::optional<std::string> text;
  if (error == 0) {
    const auto end = Clock::now() + budget;
    text = read_all(pipe_ends[0], end);
    const int status = end_of(child, text ? end : Clock::now());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) text.reset();
  }
  ::close(pipe_ends[0]);
  return text;
}

SlurmJob ask_squeue(const std::string& job) {
  std::optional<std::string> left = output_of({"squeue", "-h", "-j", job, "-o", "%L"});
  if (left) left->erase(left->find_last_not_of(" \n") + 1);
  if (!left || left->empty())
    return {job, std::nullopt, "squeue does not say when this job ends: running on as if it had no time limit"};
  if (left->find(':') == left->npos) return {job, std::nullopt, {}};  // UNLIMITED, NOT_SET
  return {job, parse_duration(*left), {}};
}

}  // namespace

SlurmJob ask_slurm() {
  const char* job = std::getenv("SLURM_JOB_ID");
  if (job == nullptr) return {};
  const char* end = std::getenv("SLURM_JOB_END_TIME");
  if (end == nullptr) return ask_squeue(job);
  const auto now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const auto end_time = parse_duration(end);
  if (!end_time) return {job, std::nullopt, fmt::format("SLURM_JOB_END_TIME = '{}' is no time: it is ignored", end)};
  return {job, *end_time > now ? *end_time - now : 0.0, {}};
}

}  // namespace sigmasweep
