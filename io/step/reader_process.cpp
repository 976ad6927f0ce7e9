#include "io/step/reader_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>

#include "core/base/memory.h"

extern char** environ;

namespace proveout {
namespace {

using Clock = std::chrono::steady_clock;

/// An end of a pipe.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  int number() const { return number_; }
  int* where() { return &number_; }

 private:
  int number_;
};

struct Pipe {
  Descriptor from, to;
  bool open() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return false;
    *from.where() = ends[0];
    *to.where() = ends[1];
    return true;
  }
};

Error cannotStart(const std::string& program, int error) {
  return {ErrorKind::kResourceLimit, fmt::format("{} cannot be started: {}", program, std::strerror(error))};
}

/// Number of the process; below 0: errno.
int spawn(const std::string& program, const std::vector<std::string>& arguments, const Pipe& out,
          const Pipe& told) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.to.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, told.to.number(), STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error != 0 ? -error : child;
}

/// Appends what has come. False: the other end is closed.
bool take(int from, std::string& out, std::size_t most) {
  std::array<char, 65536> part;
  const ssize_t count = ::read(from, part.data(), part.size());
  if (count < 0) return errno == EINTR;
  if (out.size() < most) out.append(part.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Reads both outputs to their ends. False: it took too long.
bool listen(Pipe& out, Pipe& told, Clock::time_point until, ReaderEnd& end) {
  constexpr std::size_t kMostBytes = 4ull << 30, kMostTold = 4096;
  std::array<pollfd, 2> ends = {pollfd{out.from.number(), POLLIN, 0}, pollfd{told.from.number(), POLLIN, 0}};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return false;
    if (::poll(ends.data(), ends.size(), static_cast<int>(std::min<long long>(left, 1000))) <= 0) continue;
    if (ends[0].revents != 0 && !take(ends[0].fd, end.bytes, kMostBytes)) ends[0].fd = -1;
    if (ends[1].revents != 0 && !take(ends[1].fd, end.told, kMostTold)) ends[1].fd = -1;
  }
  return true;
}

}  // namespace

Result<ReaderEnd> runReader(const std::string& program, const std::vector<std::string>& arguments,
                            int most_s) {
  Pipe out, told;
  if (!out.open() || !told.open()) return cannotStart(program, errno);
  const int child = spawn(program, arguments, out, told);
  if (child < 0) return cannotStart(program, -child);
  out.to.close();
  told.to.close();
  ReaderEnd end;
  constexpr int kWaits = 3;
  try {
    end.too_long = !listen(out, told, Clock::now() + std::chrono::seconds(kWaits * most_s), end);
  } catch (const std::bad_alloc&) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    return outOfMemory(program + ": the model does not fit into memory", "take a smaller one");
  }
  if (end.too_long) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.too_long = end.too_long || end.signal == SIGXCPU;
  end.interrupted = end.signal == SIGINT || end.signal == SIGTERM;
  return end;
}

}  // namespace proveout
