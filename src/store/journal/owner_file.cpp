#include "store/journal/owner_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "sigmasweep/base/errors.hpp"
#include "store/run_notes/machine.hpp"

namespace sigmasweep {
namespace {

constexpr auto heartbeat_period = std::chrono::seconds(20);
constexpr double silence_of_the_dead = 120.0;  ///< s; clocks of machines that share files agree far better

/// The bytes of the file.
struct Owner {
  std::uint64_t magic = 0x0a4e574f57535353;  // "SSSWOWN\n" on a little-endian machine
  ProcessId process{};
  Machine machine{};
  std::array<char, 64> host{};  ///< ends with a zero
};

Owner this_owner() {
  Owner owner;
  owner.process = this_process();
  owner.machine = this_machine();
  ::gethostname(owner.host.data(), owner.host.size() - 1);
  return owner;
}

/// A file that is there, with the owner that it names, if it is whole.
struct Found {
  File file;
  struct stat status {};
  std::optional<Owner> owner;
};

/// Nothing if the file is not there any more.
std::optional<Found> look_at(const std::string& path) {
  Found found{File(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK), {}, {}};
  if (!found.file.is_open() && errno == ENOENT) return std::nullopt;
  if (!found.file.is_open() || ::fstat(found.file.fd(), &found.status) != 0)
    throw OutputError(fmt::format("cannot open {}: {}", path, reason(errno)));
  Owner owner;
  owner.magic = 0;
  if (S_ISREG(found.status.st_mode) &&
      read_at(found.file.fd(), std::as_writable_bytes(std::span(&owner, 1)), 0, path) == sizeof owner &&
      owner.magic == Owner{}.magic) {
    owner.host.back() = '\0';
    found.owner = owner;
  }
  return found;
}

bool is_dead(const Found& found) {
  if (found.owner && found.owner->machine.is_known() && found.owner->machine == this_machine())
    return !exists(found.owner->process);
  return std::difftime(std::time(nullptr), found.status.st_mtime) > silence_of_the_dead;
}

/// Takes the file of a dead owner away. It is moved first: should another process have replaced it meanwhile, it is
/// that one's, and moved back.
void bury(const Found& dead, const std::string& path) {
  const std::string grave = fmt::format("{}.{}", path, ::getpid());
  if (::rename(path.c_str(), grave.c_str()) != 0) return;
  if (!is_name_of(grave, dead.file.fd())) (void)!::link(grave.c_str(), path.c_str());
  ::unlink(grave.c_str());
}

[[noreturn]] void refuse(const Found& found, const std::string& path, const std::string& table_path) {
  const std::string who = found.owner
                              ? fmt::format("process {} on {}", found.owner->process.number, found.owner->host.data())
                              : "another process";
  throw OutputError(
      fmt::format("another run is working on {}: {} holds {}. Wait for it to end or choose another output with -o; if "
                  "it is dead, wait two minutes",
                  table_path, who, path));
}

}  // namespace

OwnerFile::OwnerFile(std::string path, const std::string& table_path) : path_(std::move(path)) {
  for (;;) {
    file_ = File(path_, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW);
    if (file_.is_open()) break;
    if (errno != EEXIST) throw OutputError(fmt::format("cannot create {}: {}", path_, reason(errno)));
    const auto found = look_at(path_);
    if (!found) continue;
    if (!is_dead(*found)) refuse(*found, path_, table_path);
    bury(*found, path_);
  }
  const Owner owner = this_owner();
  const int error = write_at(file_.fd(), std::as_bytes(std::span(&owner, 1)), 0);
  if (error != 0) throw OutputError(fmt::format("cannot write {}: {}", path_, reason(error)));
  heart_ = std::jthread([this](const std::stop_token& stop) { keep_beating(stop); });
}

OwnerFile::~OwnerFile() {
  heart_.request_stop();
  if (heart_.joinable()) heart_.join();
  if (is_name_of(path_, file_.fd())) ::unlink(path_.c_str());
}

void OwnerFile::keep_beating(const std::stop_token& stop) const {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any ending;
  while (!ending.wait_for(lock, stop, heartbeat_period, [&] { return stop.stop_requested(); }))
    ::futimens(file_.fd(), nullptr);
}

}  // namespace sigmasweep
