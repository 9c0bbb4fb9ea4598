/* A disk that records what changes it and fails when told, as a library before a program's own (LD_PRELOAD).
   DISK_FOLDER: calls on files below this folder are meant, but not SQLite's shared memory, which no disk keeps.
   DISK_RECORD: each change that was made is appended there: a line (call, file number, offset, bytes, two names) and the
   bytes. fail_call: from then on the call of this number (from 1) fails, or all from it on. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define SHORT_WRITE -1

static long calls, first_failing, last_failing;
static int failure;

void fail_call(long first, long last, int error) {
  calls = 0;
  first_failing = first;
  last_failing = last;
  failure = error;
}

long count_calls(void) { return calls; }

static const char *below(const char *path) { /* the name below the folder, 0 where it is not in it */
  const char *folder = getenv("DISK_FOLDER");
  size_t length = folder ? strlen(folder) : 0;
  size_t whole = path ? strlen(path) : 0;
  if (!length || !path || strncmp(path, folder, length) != 0) return 0;
  if (whole > 4 && strcmp(path + whole - 4, "-shm") == 0) return 0;
  return path[length] == '/' ? path + length + 1 : path[length] ? 0 : ".";
}

static const char *name_of(int file, char *path, size_t size) {
  char link[64];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  long length = syscall(SYS_readlink, link, path, size - 1);
  if (length < 0) return 0;
  path[length] = 0;
  return below(path);
}

static long number_of(int file) {
  struct stat status;
  return fstat(file, &status) ? 0 : (long)status.st_ino;
}

static int fails(void) { /* the error of this call, 0 where it is made */
  calls++;
  return calls >= first_failing && calls <= last_failing ? failure : 0;
}

static void record(const char *call, long number, long offset, const void *data, size_t bytes, const char *name,
                   const char *other) {
  const char *path = getenv("DISK_RECORD");
  if (!path) return;
  char line[2048];
  int length = snprintf(line, sizeof line, "%s\t%ld\t%ld\t%zu\t%s\t%s\n", call, number, offset, bytes, name, other);
  struct iovec parts[2] = {{line, length}, {(void *)data, data ? bytes : 0}};
  int file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_APPEND | O_CREAT, 0600);
  syscall(SYS_writev, file, parts, 2);
  syscall(SYS_close, file);
}

static int refuse(int error) {
  errno = error == SHORT_WRITE ? EIO : error;
  return -1;
}

#define OPEN(call)                                                              \
  int call(const char *path, int flags, ...) {                                  \
    va_list rest;                                                               \
    va_start(rest, flags);                                                      \
    mode_t mode = va_arg(rest, mode_t);                                         \
    va_end(rest);                                                               \
    const char *name = below(path);                                             \
    int makes = name && (flags & O_CREAT) && syscall(SYS_access, path, F_OK);   \
    int empties = name && !makes && (flags & O_TRUNC);                          \
    int error = makes || empties ? fails() : 0;                                 \
    if (error) return refuse(error);                                            \
    int file = NEXT(call)(path, flags, mode);                                   \
    if (file >= 0 && makes) record("create", number_of(file), 0, 0, 0, name, ""); \
    if (file >= 0 && empties) record("truncate", number_of(file), 0, 0, 0, name, ""); \
    return file;                                                                \
  }
OPEN(open)
OPEN(open64)

static size_t shortened(int error, size_t bytes) { return error == SHORT_WRITE ? bytes / 2 : 0; }

#define WRITE_AT(call, offset)                                                \
  ssize_t call(int file, const void *data, size_t bytes, offset at) {         \
    char path[512];                                                           \
    const char *name = name_of(file, path, sizeof path);                      \
    int error = name ? fails() : 0;                                           \
    if (error) bytes = shortened(error, bytes);                               \
    if (error && !bytes) return refuse(error);                                \
    ssize_t written = NEXT(call)(file, data, bytes, at);                      \
    if (name && written > 0) record("write", number_of(file), at, data, written, name, ""); \
    return written;                                                           \
  }
WRITE_AT(pwrite, off_t)
WRITE_AT(pwrite64, off64_t)

ssize_t write(int file, const void *data, size_t bytes) {
  char path[512];
  const char *name = name_of(file, path, sizeof path);
  long at = name ? syscall(SYS_lseek, file, 0, SEEK_CUR) : 0;
  int error = name ? fails() : 0;
  if (error) bytes = shortened(error, bytes);
  if (error && !bytes) return refuse(error);
  ssize_t written = syscall(SYS_write, file, data, bytes);
  if (name && written > 0) record("write", number_of(file), at, data, written, name, "");
  return written;
}

#define TRUNCATE(call, offset)                                                \
  int call(int file, offset length) {                                         \
    char path[512];                                                           \
    const char *name = name_of(file, path, sizeof path);                      \
    int error = name ? fails() : 0;                                           \
    if (error) return refuse(error);                                          \
    int failed = NEXT(call)(file, length);                                    \
    if (name && !failed) record("truncate", number_of(file), length, 0, 0, name, ""); \
    return failed;                                                            \
  }
TRUNCATE(ftruncate, off_t)
TRUNCATE(ftruncate64, off64_t)

#define SYNC(call)                                                            \
  int call(int file) {                                                        \
    char path[512];                                                           \
    const char *name = name_of(file, path, sizeof path);                      \
    int error = name ? fails() : 0;                                           \
    if (error) return refuse(error);                                          \
    if (name) record("sync", number_of(file), 0, 0, 0, name, "");             \
    return 0; /* the record says what a disk would have: the files of a test need none */ \
  }
SYNC(fsync)
SYNC(fdatasync)

#define RENAME(call, what)                                                    \
  int call(const char *path, const char *other) {                             \
    const char *name = below(path);                                           \
    int error = name ? fails() : 0;                                           \
    if (error) return refuse(error);                                          \
    int failed = NEXT(call)(path, other);                                     \
    if (name && !failed) record(what, 0, 0, 0, 0, name, below(other));        \
    return failed;                                                            \
  }
RENAME(rename, "rename")
RENAME(link, "link")

int unlink(const char *path) {
  const char *name = below(path);
  int error = name && !syscall(SYS_access, path, F_OK) ? fails() : 0;
  if (error) return refuse(error);
  int failed = NEXT(unlink)(path);
  if (name && !failed) record("unlink", 0, 0, 0, 0, name, "");
  return failed;
}

ssize_t sendfile(int out, int in, off_t *offset, size_t bytes) { /* so that copies are writes */
  (void)out, (void)in, (void)offset, (void)bytes;
  return refuse(ENOTSOCK);
}
ssize_t sendfile64(int out, int in, off64_t *offset, size_t bytes) {
  (void)out, (void)in, (void)offset, (void)bytes;
  return refuse(ENOTSOCK);
}
