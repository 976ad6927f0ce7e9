#include "tests/bench/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

namespace proveout::bench {

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

[[noreturn]] void become(std::vector<char*>& arguments, const std::string& errors) {
  const int nowhere = open("/dev/null", O_WRONLY);
  const int error_file = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(nowhere, STDOUT_FILENO);
  dup2(error_file, STDERR_FILENO);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

/// Waits for the child; from `limit_s` on it is killed. True if it ended by itself.
bool waitFor(pid_t child, double limit_s, int& status, rusage& usage) {
  const double start = now();
  bool killed = false;
  // A short sleep bounds how much later the end is seen; it is below the noise of a process start.
  while (wait4(child, &status, killed ? 0 : WNOHANG, &usage) == 0) {
    if (now() - start > limit_s) {
      kill(child, SIGKILL);
      killed = true;
    } else {
      usleep(300);
    }
  }
  return !killed;
}

}  // namespace

ChildOutcome runChild(const std::vector<std::string>& command, const std::string& errors, double limit_s) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ChildOutcome outcome;
  const double start = now();
  const pid_t child = fork();
  if (child < 0) return outcome;
  if (child == 0) become(arguments, errors);
  int status = 0;
  rusage usage{};
  outcome.ended = waitFor(child, limit_s, status, usage);
  outcome.wall_s = now() - start;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  outcome.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in KiB
  return outcome;
}

}  // namespace proveout::bench
