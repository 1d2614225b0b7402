#include "base/output/place.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

/// The number of the open descriptor that a path names by itself; nothing for other paths.
std::optional<int> descriptor_named(std::string_view path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view directory : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(directory)) continue;
    const std::string_view digits = path.substr(directory.size());
    int number = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc{} && end == digits.data() + digits.size()) return number;
  }
  return std::nullopt;
}

/// The target of a symbolic link; nothing if the path is not one.
std::optional<std::string> target_of(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::read_symlink(path, error);
  if (error) return std::nullopt;
  return target.is_absolute() ? target.string() : (fs::path(path).parent_path() / target).string();
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISLNK(mode)) return "a symbolic link";
  return "a socket";
}

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
  throw OutputError(fmt::format("cannot write {}: {}", path, why));
}

File duplicate(int descriptor, const std::string& path) {
  File copy(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
  if (!copy.is_open()) cannot_write(path, reason(errno));
  return copy;
}

/// A FIFO has a reader before it is opened, or soon after; one without must not keep the program for ever.
File open_fifo(const std::string& path) {
  constexpr auto patience = std::chrono::seconds(5);
  for (const auto end = std::chrono::steady_clock::now() + patience;;) {
    File file(path, O_WRONLY | O_NONBLOCK);
    if (file.is_open()) {
      ::fcntl(file.fd(), F_SETFL, O_WRONLY);
      return file;
    }
    if (errno != ENXIO) cannot_write(path, reason(errno));
    if (std::chrono::steady_clock::now() >= end) cannot_write(path, "it is a pipe that no program reads");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

std::string linked_file(const std::string& path) {
  constexpr int most_links = 40;  // as of the kernel
  std::string name = path;
  for (int links = 0; !descriptor_named(name); ++links) {
    const auto target = target_of(name);
    if (!target) return name;
    if (links == most_links) throw OutputError(fmt::format("{}: its symbolic links lead to no end", path));
    name = *target;
  }
  return name;
}

std::string beside(const std::string& path, const std::string& suffix) { return linked_file(path) + suffix; }

std::optional<File> open_stream(const std::string& path) {
  const std::string place = linked_file(path);
  if (const auto descriptor = descriptor_named(place)) return duplicate(*descriptor, path);
  struct stat status {};
  if (::stat(place.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return std::nullopt;
  if (S_ISFIFO(status.st_mode)) return open_fifo(place);
  if (!S_ISCHR(status.st_mode)) cannot_write(path, fmt::format("it is {}", kind_of(status.st_mode)));
  File file(place, O_WRONLY | O_NOCTTY);
  if (!file.is_open()) cannot_write(path, reason(errno));
  return file;
}

void require_file_place(const std::string& path, const std::string& why) {
  const std::string place = linked_file(path);
  if (descriptor_named(place)) cannot_write(path, fmt::format("it is a stream, and {}", why));
  struct stat status {};
  if (::stat(place.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    cannot_write(path, fmt::format("it is {}, and {}", kind_of(status.st_mode), why));
}

void require_plain(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    cannot_write(path, fmt::format("{} has this name, remove it", kind_of(status.st_mode)));
}

void require_other_file(const std::string& output, std::span<const std::string> inputs) {
  for (const std::string& input : inputs) {
    std::error_code error;
    if (fs::equivalent(output, input, error) && !error)
      cannot_write(output, input == output ? "it is an input of the same command"
                                           : fmt::format("it is the same file as {}, an input", input));
  }
}

}  // namespace sigmasweep
