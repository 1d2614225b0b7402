#include "store/journal/lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Who holds the lock, in words; empty if nobody does any more.
std::string holder(int fd) {
  struct flock lock = whole_file();
  if (::fcntl(fd, F_GETLK, &lock) != 0) return "another process";
  if (lock.l_type == F_UNLCK) return {};
  if (lock.l_pid <= 0) return "a process on another machine or in another container";
  return fmt::format("process {}", lock.l_pid);
}

/// What fcntl says where the file system has no locks: Lustre mounted without flock, NFS without its lock manager.
bool has_no_locks(int error) {
  return error == ENOSYS || error == ENOLCK || error == EOPNOTSUPP || error == EINVAL || error == ENOTSUP;
}

}  // namespace

bool lock_whole_file(const File& file) {
  struct flock lock = whole_file();
  return ::fcntl(file.fd(), F_SETLK, &lock) == 0 || has_no_locks(errno);
}

TableLock::TableLock(const std::string& table_path) : path_(beside(table_path, ".lock")) {
  for (;;) {
    file_ = File(path_, O_RDWR | O_CREAT | O_NOFOLLOW);
    if (!file_.is_open()) throw OutputError(fmt::format("cannot create {}: {}", path_, reason(errno)));
    struct flock lock = whole_file();
    if (::fcntl(file_.fd(), F_SETLK, &lock) == 0) {
      if (is_name_of(path_, file_.fd())) return;  // a former owner may have removed it meanwhile
      continue;
    }
    if (errno == EINTR) continue;
    if (has_no_locks(errno)) {
      remove();
      owner_ = std::make_unique<OwnerFile>(beside(table_path, ".owner"), table_path);
      return;
    }
    if (errno != EACCES && errno != EAGAIN) throw OutputError(fmt::format("cannot lock {}: {}", path_, reason(errno)));
    const std::string who = holder(file_.fd());
    if (!who.empty())
      throw OutputError(
          fmt::format("another run is working on {}: {} holds {}. Wait for it to end or choose another "
                      "output with -o",
                      table_path, who, path_));
  }
}

TableLock::~TableLock() { remove(); }

/// While it is still ours; a file left behind would do no harm. One that is not empty is somebody else's.
void TableLock::remove() {
  struct stat status {};
  if (file_.is_open() && ::fstat(file_.fd(), &status) == 0 && status.st_size == 0 && is_name_of(path_, file_.fd()))
    ::unlink(path_.c_str());
  file_.close();
}

}  // namespace sigmasweep
