#include "app/time_limit.h"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <string_view>

#include "app/exit_codes.h"
#include "io/atomic_file.h"

namespace proveout {
namespace {

/// So much of the limit is kept for stopping: a share, and at most so many seconds.
constexpr double kStoppingShare = 0.1, kStoppingS = 1.0;
constexpr std::string_view kEnded =
    "proveout: error: the time limit (--max-time, max_time_s) is over: the command was ended\n";

// What the signal handler sees.
std::atomic<ConsoleProgress*> limited{nullptr};
std::atomic<bool> asked{false};

/// The first signal asks the work to stop; a later one ends the process unless files are in the making.
extern "C" void onTimer(int) {
  if (!asked.exchange(true)) {
    if (ConsoleProgress* const progress = limited.load()) progress->expire();
    return;
  }
  if (UnfinishedFile::any()) return;  // the timer comes again
  if (::write(STDERR_FILENO, kEnded.data(), kEnded.size()) < 0) _exit(kExitResource);
  _exit(kExitResource);
}

double steadyTime() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

timeval timeOf(double seconds) {
  const double whole = std::floor(seconds);
  return {static_cast<time_t>(whole), static_cast<suseconds_t>(1e6 * (seconds - whole))};
}

/// 0: never.
void startTimer(double first_s, double every_s) {
  const itimerval timer{timeOf(every_s), timeOf(first_s)};
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

TimeLimit::TimeLimit(ConsoleProgress& progress) : progress_(progress), start_s_(steadyTime()) {}

TimeLimit::~TimeLimit() {
  if (limit_s_ <= 0.0) return;
  startTimer(0.0, 0.0);
  limited = nullptr;
}

void TimeLimit::set(double seconds) {
  if (limit_s_ > 0.0 || !(seconds > 0.0)) return;
  limit_s_ = seconds;
  limited = &progress_;
  asked = false;
  std::signal(SIGALRM, onTimer);
  constexpr double kSoonS = 1e-3, kLongestS = 1e8;  // what the timer can take
  const double stopping = std::clamp(kStoppingShare * seconds, kSoonS, kStoppingS);
  const double left = seconds - (steadyTime() - start_s_) - stopping;
  startTimer(std::clamp(left, kSoonS, kLongestS), stopping);
}

Error TimeLimit::told(const Error& error) const {
  if (error.kind != ErrorKind::kInterrupted || !progress_.expired()) return error;
  const std::string phase = progress_.phase();
  return {
      ErrorKind::kResourceLimit,
      fmt::format("stopped by the time limit of {:g} s (--max-time, max_time_s){}: allow more time, or ask "
                  "for less, by a coarser grid or a part of the program",
                  limit_s_, phase.empty() ? "" : " while " + phase)};
}

}  // namespace proveout
