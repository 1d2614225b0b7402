#include "base/terminal.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/file.hpp"
#include "base/process.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

bool is_launcher(std::string_view name) {
  constexpr auto names = std::to_array<std::string_view>({"mpirun", "mpiexec", "orterun", "prterun", "hydra_"});
  return std::ranges::any_of(names, [&](std::string_view known) { return name.starts_with(known); });
}

/// Whether the process can read from the pipe.
bool reads(pid_t id, const struct stat& pipe) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc/" + std::to_string(id) + "/fd", error)) {
    struct stat link {
    }, target{};
    if (::lstat(entry.path().c_str(), &link) != 0 || ::stat(entry.path().c_str(), &target) != 0) continue;
    const bool reads_only = (link.st_mode & S_IRUSR) != 0 && (link.st_mode & S_IWUSR) == 0;
    if (reads_only && S_ISFIFO(target.st_mode) && target.st_dev == pipe.st_dev && target.st_ino == pipe.st_ino)
      return true;
  }
  return false;
}

/// The launcher among the ancestors of the process that reads this pipe; 0 if there is none.
pid_t launcher_that_reads(pid_t id, const struct stat& pipe) {
  constexpr int max_ancestors = 16;
  for (int i = 0; i < max_ancestors && id > 1; ++i) {
    id = static_cast<pid_t>(stat_of_process(id).parent);
    if (id > 1 && is_launcher(stat_of_process(id).name)) return reads(id, pipe) ? id : 0;
  }
  return 0;
}

bool labels_lines() {
  constexpr auto options = std::to_array({"orte_tag_output", "orte_timestamp_output", "orte_xml_output"});
  return std::ranges::any_of(options, [](const char* option) {
    const char* value = std::getenv(("OMPI_MCA_" + std::string(option)).c_str());
    return value != nullptr && std::string_view(value) != "0";
  });
}

std::optional<Terminal> terminal_of(int fd) {
  if (::isatty(fd) != 1) return std::nullopt;
  Terminal terminal;
  winsize size{};
  if (::ioctl(fd, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) terminal.columns = size.ws_col;
  return terminal;
}

}  // namespace

std::optional<Terminal> terminal_of_stderr() {
  if (const auto own = terminal_of(STDERR_FILENO)) return own;
  if (labels_lines()) return std::nullopt;
  constexpr int max_launchers = 4;
  pid_t id = ::getpid();
  for (int i = 0; i < max_launchers; ++i) {
    const std::string stderr_of_it = "/proc/" + std::to_string(id) + "/fd/2";
    struct stat status {};
    if (::stat(stderr_of_it.c_str(), &status) != 0) return std::nullopt;
    if (S_ISCHR(status.st_mode)) return terminal_of(File(stderr_of_it, O_WRONLY | O_NOCTTY | O_NONBLOCK).fd());
    if (!S_ISFIFO(status.st_mode)) return std::nullopt;
    id = launcher_that_reads(id, status);
    if (id == 0) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace sigmasweep
