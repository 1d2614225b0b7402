/* A file system without locks, as Lustre without -o flock: fcntl and flock say so by NO_LOCKS_ERRNO (ENOSYS). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>

static int is_lock(int command) {
  return command == F_SETLK || command == F_SETLKW || command == F_GETLK || command == F_OFD_SETLK;
}

static int no_locks(void) {
  const char* number = getenv("NO_LOCKS_ERRNO");
  errno = number ? atoi(number) : ENOSYS;
  return -1;
}

#define WITHOUT_LOCKS(name)                                                     \
  int name(int descriptor, int command, ...) {                                  \
    static int (*real)(int, int, ...);                                          \
    if (!real) real = (int (*)(int, int, ...))dlsym(RTLD_NEXT, #name);          \
    va_list list;                                                               \
    va_start(list, command);                                                    \
    void* argument = va_arg(list, void*);                                       \
    va_end(list);                                                               \
    return is_lock(command) ? no_locks() : real(descriptor, command, argument); \
  }

WITHOUT_LOCKS(fcntl)
WITHOUT_LOCKS(fcntl64)

int flock(int descriptor, int operation) {
  (void)descriptor;
  (void)operation;
  return no_locks();
}
