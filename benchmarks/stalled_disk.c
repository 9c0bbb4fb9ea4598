/* A disk that does not answer, and a record of what reaches it, as a library before a program's own (LD_PRELOAD).
   DISK_FOLDER: calls on files of this folder wait as long as DISK_STALLS is a file; DISK_RECORD: gets a line for each
   write and each sync of a log of SQLite: what, when it began and ended (s, monotonic), bytes. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + t.tv_nsec * 1e-9;
}

static void wait_for_disk(void) {
  const char *stalls = getenv("DISK_STALLS");
  struct timespec pause = {0, 5000000};
  while (stalls && syscall(SYS_access, stalls, F_OK) == 0) nanosleep(&pause, 0);
}

static void on_path(const char *path) {
  const char *folder = getenv("DISK_FOLDER");
  if (folder && path && strncmp(path, folder, strlen(folder)) == 0) wait_for_disk();
}

static int on_file(int file) { /* 1: a log of the folder */
  char link[64], path[512];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  long length = syscall(SYS_readlink, link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = 0;
  on_path(path);
  return length > 4 && strcmp(path + length - 4, "-wal") == 0;
}

static void record(const char *what, double begun, long bytes) {
  const char *path = getenv("DISK_RECORD");
  if (!path) return;
  char line[128];
  int length = snprintf(line, sizeof line, "%s %.6f %.6f %ld\n", what, begun, now(), bytes);
  int file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_APPEND | O_CREAT, 0600);
  syscall(SYS_write, file, line, length);
  syscall(SYS_close, file);
}

#define OPEN(name)                                  \
  int name(const char *path, int flags, ...) {      \
    va_list rest;                                   \
    va_start(rest, flags);                          \
    mode_t mode = va_arg(rest, mode_t);             \
    va_end(rest);                                   \
    on_path(path);                                  \
    return NEXT(name)(path, flags, mode);           \
  }
OPEN(open)
OPEN(open64)

#define STATUS(name, type)                          \
  int name(const char *path, struct type *status) { \
    on_path(path);                                  \
    return NEXT(name)(path, status);                \
  }
STATUS(stat, stat)
STATUS(stat64, stat64)
STATUS(lstat, stat)
STATUS(lstat64, stat64)

int unlink(const char *path) {
  on_path(path);
  return NEXT(unlink)(path);
}

int rename(const char *path, const char *other) {
  on_path(path);
  return NEXT(rename)(path, other);
}

#define WRITE(name, offset)                                            \
  ssize_t name(int file, const void *data, size_t bytes, offset at) {  \
    double begun = now();                                              \
    int log = on_file(file);                                           \
    ssize_t written = NEXT(name)(file, data, bytes, at);               \
    if (log) record("write", begun, written);                          \
    return written;                                                    \
  }
WRITE(pwrite, off_t)
WRITE(pwrite64, off64_t)

#define READ(name, offset)                                       \
  ssize_t name(int file, void *data, size_t bytes, offset at) {  \
    on_file(file);                                               \
    return NEXT(name)(file, data, bytes, at);                    \
  }
READ(pread, off_t)
READ(pread64, off64_t)

#define SYNC(name)                          \
  int name(int file) {                      \
    double begun = now();                   \
    int log = on_file(file);                \
    int failed = NEXT(name)(file);          \
    if (log) record("sync", begun, 0);      \
    return failed;                          \
  }
SYNC(fsync)
SYNC(fdatasync)
