#include "store/hdf5/trial.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "base/file.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/seal.hpp"

namespace sigmasweep {
namespace {

/// CPU time that a file of this size may take, s. A disk's 20 MB/s, and a file is read twice (checksum and rows).
rlim_t time_limit(off_t bytes) { return 5 + static_cast<rlim_t>(bytes) / 10'000'000; }

/// What a crash does in the program (a message of MPI, a core file) is not for the child.
void expect_crash(rlim_t seconds) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
  const rlimit no_core{0, 0}, time{seconds, seconds};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::setrlimit(RLIMIT_CPU, &time);
  const int null = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
}

/// The child's part: whether `read` returned, or refused the file.
bool comes_to_an_end(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Error&) {
    return true;
  } catch (...) {
    return false;
  }
}

/// Whether a child process survives `read`. It says so by a byte, as the system may keep no status of children.
bool child_survives(const std::function<void()>& read, rlim_t seconds) {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw IoError(fmt::format("cannot make a pipe: {}", reason(errno)));
  const File reading(ends[0]);
  File writing(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) throw IoError(fmt::format("cannot start a process: {}", reason(errno)));
  if (child == 0) {
    expect_crash(seconds);
    const char yes = 'y';
    ::_exit(comes_to_an_end(read) && ::write(writing.fd(), &yes, 1) == 1 ? 0 : 1);
  }
  writing.close();
  char answer = '\0';
  ssize_t got = 0;
  while ((got = ::read(reading.fd(), &answer, 1)) < 0 && errno == EINTR) {
  }
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  return got == 1;
}

}  // namespace

void try_unsealed(const std::string& path, const std::function<void()>& read) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION  // a fuzzer wants to see the crash
  return;
#endif
  const File file(path, O_RDONLY | O_NONBLOCK);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.fd(), &status) != 0 || !S_ISREG(status.st_mode) || has_seal(file)) return;
  if (!child_survives(read, time_limit(status.st_size)))
    throw IoError("HDF5 crashes over it or does not come to an end, so that it is damaged");
}

}  // namespace sigmasweep
