// A library for LD_PRELOAD that counts system calls and allocations of a program and of all that it
// starts, and disturbs one of them. It does nothing before main and after it.
//
//   EDVO_FAULT_COUNTS=FILE        a file of kSlots zeros of 8 bytes, where calls are counted
//   EDVO_FAULT=KIND:N:ACTION      what to do with the N-th call of KIND (from 1), or of any with KIND
//                                 "any": fail with errno ACTION (a number), or ask the torture to kill the program, and
//                                 go on where this process outlives it ("kill")

#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

enum Kind { kWrite, kRename, kSync, kOpen, kMkdir, kMap, kMemory, kRemove, kLock, kAny, kKinds };
enum { kRequest = kKinds, kSlots };  // the slot after the counts: 1 asks to be killed, 2 is the answer
static const char* const kNames[kKinds] = {"write", "rename", "fsync",  "open",  "mkdir",
                                           "mmap",  "malloc", "unlink", "flock", "any"};

static _Atomic long* counts;  // shared by all processes
static int armed;
static int fault_kind = -1;
static long fault_at;
static int fault_error;  // 0: kill

void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

// Returns whether this call is to fail, with errno set. Memory is not of kind "any": killing a
// program between two allocations is killing it between two system calls.
static int fails(enum Kind kind) {
  if (!armed || counts == NULL) {
    return 0;
  }
  const long of_kind = atomic_fetch_add(&counts[kind], 1) + 1;
  const long of_all = kind == kMemory ? 0 : atomic_fetch_add(&counts[kAny], 1) + 1;
  if ((fault_kind != (int)kind || of_kind != fault_at) &&
      (fault_kind != kAny || of_all != fault_at)) {
    return 0;
  }
  if (fault_error == 0) {
    counts[kRequest] = 1;
    while (counts[kRequest] == 1) {
      usleep(1000);
    }
    return 0;
  }
  errno = fault_error;
  return 1;
}

static void read_environment(void) {
  const char* file = getenv("EDVO_FAULT_COUNTS");
  const char* fault = getenv("EDVO_FAULT");
  const int descriptor = file != NULL ? open(file, O_RDWR | O_CLOEXEC) : -1;
  if (descriptor < 0) {
    return;
  }
  void* shared = mmap(NULL, kSlots * sizeof(long), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  close(descriptor);
  char kind[16];
  char action[16];
  if (fault != NULL && sscanf(fault, "%15[^:]:%ld:%15s", kind, &fault_at, action) == 3) {
    for (int i = 0; i < kKinds; ++i) {
      fault_kind = strcmp(kind, kNames[i]) == 0 ? i : fault_kind;
    }
    fault_error = atoi(action);
  }
  counts = shared != MAP_FAILED ? (_Atomic long*)shared : NULL;
}

static int (*real_main)(int, char**, char**);

static int counted_main(int argc, char** argv, char** environment) {
  read_environment();
  armed = 1;
  const int code = real_main(argc, argv, environment);
  armed = 0;
  return code;
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end) {
  int (*start)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void),
               void (*)(void), void*) = dlsym(RTLD_NEXT, "__libc_start_main");
  real_main = main;
  return start(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

#define REAL(name) __typeof__(&name) real = (__typeof__(&name))dlsym(RTLD_NEXT, #name)

ssize_t write(int file, const void* bytes, size_t size) {
  REAL(write);
  return fails(kWrite) ? -1 : real(file, bytes, size);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t offset) {
  REAL(pwrite64);
  return fails(kWrite) ? -1 : real(file, bytes, size, offset);
}

ssize_t writev(int file, const struct iovec* blocks, int count) {
  REAL(writev);
  return fails(kWrite) ? -1 : real(file, blocks, count);
}

int ftruncate(int file, off_t size) {
  REAL(ftruncate);
  return fails(kWrite) ? -1 : real(file, size);
}

int rename(const char* from, const char* to) {
  REAL(rename);
  return fails(kRename) ? -1 : real(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  REAL(renameat);
  return fails(kRename) ? -1 : real(from_folder, from, to_folder, to);
}

int fsync(int file) {
  REAL(fsync);
  return fails(kSync) ? -1 : real(file);
}

int fdatasync(int file) {
  REAL(fdatasync);
  return fails(kSync) ? -1 : real(file);
}

#define MODE_OF(flags)                       \
  mode_t mode = 0;                           \
  if ((flags) & (O_CREAT | __O_TMPFILE)) {   \
    va_list rest;                            \
    va_start(rest, flags);                   \
    mode = va_arg(rest, mode_t);             \
    va_end(rest);                            \
  }

int open(const char* path, int flags, ...) {
  MODE_OF(flags)
  REAL(open);
  return fails(kOpen) ? -1 : real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  MODE_OF(flags)
  REAL(open64);
  return fails(kOpen) ? -1 : real(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  MODE_OF(flags)
  REAL(openat);
  return fails(kOpen) ? -1 : real(folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
  MODE_OF(flags)
  REAL(openat64);
  return fails(kOpen) ? -1 : real(folder, path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  REAL(fopen);
  return fails(kOpen) ? NULL : real(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  REAL(fopen64);
  return fails(kOpen) ? NULL : real(path, mode);
}

DIR* opendir(const char* path) {
  REAL(opendir);
  return fails(kOpen) ? NULL : real(path);
}

int mkostemps64(char* name, int suffix, int flags) {
  REAL(mkostemps64);
  return fails(kOpen) ? -1 : real(name, suffix, flags);
}

int mkostemps(char* name, int suffix, int flags) {
  REAL(mkostemps);
  return fails(kOpen) ? -1 : real(name, suffix, flags);
}

int mkdir(const char* path, mode_t mode) {
  REAL(mkdir);
  return fails(kMkdir) ? -1 : real(path, mode);
}

int mkdirat(int folder, const char* path, mode_t mode) {
  REAL(mkdirat);
  return fails(kMkdir) ? -1 : real(folder, path, mode);
}

void* mmap(void* place, size_t size, int access, int flags, int file, off_t offset) {
  REAL(mmap);
  return fails(kMap) ? MAP_FAILED : real(place, size, access, flags, file, offset);
}

void* mmap64(void* place, size_t size, int access, int flags, int file, off64_t offset) {
  REAL(mmap64);
  return fails(kMap) ? MAP_FAILED : real(place, size, access, flags, file, offset);
}

int unlink(const char* path) {
  REAL(unlink);
  return fails(kRemove) ? -1 : real(path);
}

int unlinkat(int folder, const char* path, int flags) {
  REAL(unlinkat);
  return fails(kRemove) ? -1 : real(folder, path, flags);
}

int rmdir(const char* path) {
  REAL(rmdir);
  return fails(kRemove) ? -1 : real(path);
}

int flock(int file, int operation) {
  REAL(flock);
  return fails(kLock) ? -1 : real(file, operation);
}

void* malloc(size_t size) {
  return fails(kMemory) ? NULL : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) {
  return fails(kMemory) ? NULL : __libc_calloc(count, size);
}

void* realloc(void* old, size_t size) {
  return fails(kMemory) ? NULL : __libc_realloc(old, size);
}

void* aligned_alloc(size_t alignment, size_t size) {
  return fails(kMemory) ? NULL : __libc_memalign(alignment, size);
}

void* memalign(size_t alignment, size_t size) {
  return fails(kMemory) ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void** place, size_t alignment, size_t size) {
  const int before = errno;
  void* memory = fails(kMemory) ? NULL : __libc_memalign(alignment, size);
  errno = before;
  if (memory == NULL) {
    return ENOMEM;
  }
  *place = memory;
  return 0;
}
