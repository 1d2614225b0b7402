/* A library for LD_PRELOAD that makes calls fail: the FAIL_AT-th call of FAIL_CALL on a file whose path contains
   FAIL_PATH fails with FAIL_ERRNO, and so do later calls if FAIL_ON is set. With FAIL_RANK only calls of this rank
   fail. With FAIL_STOP the process stops there instead (SIGSTOP), and the call goes on with it. Calls of HDF5 fail
   before they do anything; FAIL_PATH must be empty for them. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_int calls;

static int of_our_rank(void) {
  const char *wanted = getenv("FAIL_RANK"), *rank = getenv("OMPI_COMM_WORLD_RANK");
  return wanted == NULL || (rank != NULL && strcmp(wanted, rank) == 0);
}

/* errno of the failure, or 0 for a call that does not fail. */
static int fails(const char* call, const char* path) {
  const char *wanted = getenv("FAIL_CALL"), *part = getenv("FAIL_PATH");
  if (wanted == NULL || part == NULL || strcmp(wanted, call) != 0 || strstr(path, part) == NULL) return 0;
  if (!of_our_rank()) return 0;
  const int at = atoi(getenv("FAIL_AT")), now = ++calls;
  const int hit = now == at || (now > at && getenv("FAIL_ON") != NULL);
  if (hit && getenv("FAIL_STOP") != NULL) return raise(SIGSTOP), 0;
  return hit ? atoi(getenv("FAIL_ERRNO")) : 0;
}

static int fails_fd(const char* call, int fd) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  path[size > 0 ? size : 0] = '\0';
  return fails(call, path);
}

#define WRAP(type, name, group, arguments, values)                       \
  type name arguments {                                                  \
    static type(*real) arguments;                                        \
    if (real == NULL) real = (type(*) arguments)dlsym(RTLD_NEXT, #name); \
    const int error = fails_fd(group, fd);                               \
    if (error != 0) return errno = error, -1;                            \
    return real values;                                                  \
  }
WRAP(ssize_t, write, "write", (int fd, const void* data, size_t size), (fd, data, size))
WRAP(ssize_t, pwrite, "write", (int fd, const void* data, size_t size, off_t at), (fd, data, size, at))
WRAP(ssize_t, pwrite64, "write", (int fd, const void* data, size_t size, off64_t at), (fd, data, size, at))
WRAP(ssize_t, writev, "write", (int fd, const struct iovec* parts, int count), (fd, parts, count))
WRAP(ssize_t, pwritev, "write", (int fd, const struct iovec* parts, int count, off_t at), (fd, parts, count, at))
WRAP(ssize_t, pwritev64, "write", (int fd, const struct iovec* parts, int count, off64_t at), (fd, parts, count, at))
WRAP(int, fsync, "fsync", (int fd), (fd))
WRAP(int, fdatasync, "fdatasync", (int fd), (fd))
WRAP(int, ftruncate, "ftruncate", (int fd, off_t size), (fd, size))
WRAP(int, ftruncate64, "ftruncate", (int fd, off64_t size), (fd, size))

#define WRAP_ALLOCATE(name, offset)                                                 \
  int name(int fd, offset at, offset size) {                                        \
    static int (*real)(int, offset, offset);                                        \
    if (real == NULL) real = (int (*)(int, offset, offset))dlsym(RTLD_NEXT, #name); \
    const int error = fails_fd("posix_fallocate", fd);                              \
    return error != 0 ? error : real(fd, at, size);                                 \
  }
WRAP_ALLOCATE(posix_fallocate, off_t)
WRAP_ALLOCATE(posix_fallocate64, off64_t)

#define WRAP_OPEN(name)                                                               \
  int name(const char* path, int flags, ...) {                                        \
    static int (*real)(const char*, int, ...);                                        \
    if (real == NULL) real = (int (*)(const char*, int, ...))dlsym(RTLD_NEXT, #name); \
    va_list list;                                                                     \
    va_start(list, flags);                                                            \
    const mode_t mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(list, mode_t) : 0;   \
    va_end(list);                                                                     \
    const int reads = (flags & O_ACCMODE) == O_RDONLY;                                \
    const int error = fails(reads ? "open to read" : "open to write", path);          \
    if (error != 0) return errno = error, -1;                                         \
    return real(path, flags, mode);                                                   \
  }
WRAP_OPEN(open)
WRAP_OPEN(open64)

#define WRAP_HDF5(type, name, arguments, values)                         \
  type name arguments {                                                  \
    static type(*real) arguments;                                        \
    if (real == NULL) real = (type(*) arguments)dlsym(RTLD_NEXT, #name); \
    return fails(#name, "") != 0 ? -1 : real values;                     \
  }
typedef int64_t id;
WRAP_HDF5(id, H5Fcreate, (const char* path, unsigned flags, id creation, id access), (path, flags, creation, access))
WRAP_HDF5(int, H5Dwrite, (id set, id type, id memory, id file, id transfer, const void* data),
          (set, type, memory, file, transfer, data))
WRAP_HDF5(int, H5Fflush, (id file, int scope), (file, scope))

int rename(const char* from, const char* to) {
  static int (*real)(const char*, const char*);
  if (real == NULL) real = (int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename");
  const int error = fails("rename", to);
  if (error != 0) return errno = error, -1;
  return real(from, to);
}
