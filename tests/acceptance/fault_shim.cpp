// Loaded before the program's libraries (LD_PRELOAD). Makes the system fail where a test asks for it:
// PROVEOUT_NO_THREADS: no thread can be started.
// PROVEOUT_NO_EXCHANGE: no two folders can be exchanged.
// PROVEOUT_KILL_AT=n: the process is killed before its n-th call that changes a file or a folder.
// PROVEOUT_COUNT_CALLS: how many of these there were is written to standard error at the end.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr unsigned kExchange = 2;  // RENAME_EXCHANGE

std::atomic<int> calls{0};

/// Tells at the end how often something could have been killed.
struct Count {
  ~Count() {
    if (std::getenv("PROVEOUT_COUNT_CALLS") != nullptr) ::dprintf(STDERR_FILENO, "calls: %d\n", calls.load());
  }
} count;

void step() {
  const char* const at = std::getenv("PROVEOUT_KILL_AT");
  const int call = ++calls;
  if (at != nullptr && call == std::atoi(at)) ::kill(::getpid(), SIGKILL);
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*body)(void*),
                   void* argument) noexcept {
  if (std::getenv("PROVEOUT_NO_THREADS") != nullptr) return EAGAIN;
  using Create = int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  return next<Create>("pthread_create")(thread, attributes, body, argument);
}

int rename(const char* from, const char* to) noexcept {
  step();
  return next<int(const char*, const char*)>("rename")(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
  step();
  if (std::getenv("PROVEOUT_NO_EXCHANGE") != nullptr && flags == kExchange) {
    errno = EINVAL;
    return -1;
  }
  using Rename = int(int, const char*, int, const char*, unsigned);
  return next<Rename>("renameat2")(from_folder, from, to_folder, to, flags);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  step();
  return next<int(int, const char*, int, const char*, int)>("linkat")(from_folder, from, to_folder, to,
                                                                      flags);
}

int mkdir(const char* path, mode_t mode) noexcept {
  step();
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

char* mkdtemp(char* pattern) noexcept {
  step();
  return next<char*(char*)>("mkdtemp")(pattern);
}

int remove(const char* path) noexcept {
  step();
  return next<int(const char*)>("remove")(path);
}

int unlink(const char* path) noexcept {
  step();
  return next<int(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) noexcept {
  step();
  return next<int(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int open(const char* path, int flags, ...) {
  std::va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  if ((flags & O_ACCMODE) != O_RDONLY) step();
  return next<int(const char*, int, ...)>("open")(path, flags, mode);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, std::FILE* file) {
  step();
  return next<std::size_t(const void*, std::size_t, std::size_t, std::FILE*)>("fwrite")(data, size, count,
                                                                                        file);
}

int fclose(std::FILE* file) {
  step();
  return next<int(std::FILE*)>("fclose")(file);
}

}  // extern "C"
