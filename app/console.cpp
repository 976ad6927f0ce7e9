#include "app/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "app/exit_codes.h"
#include "core/base/printable.h"

namespace proveout {

namespace {

/// A time left is told from here on: before, there is nothing to wait for.
constexpr double kPatienceS = 2.0;

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string roughTime(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

ConsoleProgress::ConsoleProgress(std::ostream& err, Clock clock)
    : err_(err), clock_(clock ? std::move(clock) : Clock(steadySeconds)), start_s_(clock_()) {}

void ConsoleProgress::expect(const Prediction& prediction) {
  if (!shown_.load()) return;
  clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  start_s_ = clock_();
  expected_s_ = prediction.time_s;
  err_ << fmt::format("proveout: this will take about {} and {:.0f} MB\n", roughTime(prediction.time_s),
                      prediction.memory_mb);
}

/// The larger of what is left of the predicted time and of the phase at its pace so far.
std::string ConsoleProgress::timeLeft(double now_s, double done) const {
  if (now_s - start_s_ < kPatienceS) return {};
  double left = expected_s_ - (now_s - start_s_);
  if (done > 0.01) left = std::max(left, (now_s - phase_start_s_) * (1.0 - done) / done);
  return left > 0.5 ? fmt::format(", {} left", roughTime(left)) : std::string();
}

void ConsoleProgress::report(std::string_view phase, double done) {
  const int percent = static_cast<int>(std::clamp(done, 0.0, 1.0) * 100.0);
  now_.store(phase.data(), std::memory_order_relaxed);
  now_percent_.store(percent, std::memory_order_relaxed);
  if (!shown_.load(std::memory_order_relaxed)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (phase == phase_ && percent <= percent_) return;
  const double now_s = clock_();
  if (phase != phase_) phase_start_s_ = now_s;
  phase_ = phase;
  percent_ = percent;
  const std::string line = fmt::format("{} {} %{}", phase, percent, timeLeft(now_s, 0.01 * percent));
  width_ = std::max(width_, line.size());
  err_ << fmt::format("\r{:<{}}", line, width_) << std::flush;
}

void ConsoleProgress::expire() noexcept {
  expired_.store(true);
  cancel();
}

std::string ConsoleProgress::phase() const {
  const char* const phase = now_.load();
  return phase == nullptr ? std::string() : fmt::format("{}, {} % done", phase, now_percent_.load());
}

void ConsoleProgress::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (width_ > 0) err_ << fmt::format("\r{:<{}}\r", "", width_) << std::flush;
  width_ = 0;
  percent_ = -1;
  phase_.clear();
}

int printError(Console& console, const Error& error) {
  const char* what = error.kind == ErrorKind::kInternal ? "internal error" : "error";
  console.err << "proveout: " << what << ": " << printable(boundedMessage(error.message)) << "\n";
  return exitCodeOf(error.kind);
}

void printDiagnostics(Console& console, const std::vector<Diagnostic>& diagnostics, Severity least) {
  // A loop tells the same of the same block each time: once is enough to read.
  std::map<std::string, int> told;
  std::vector<const std::pair<const std::string, int>*> in_order;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity < least) continue;
    const auto [at, first] = told.emplace(formatDiagnostic(diagnostic), 0);
    ++at->second;
    if (first) in_order.push_back(&*at);
  }
  for (const auto* text : in_order) {
    console.err << text->first;
    if (text->second > 1) console.err << "    note: told " << text->second << " times\n";
  }
}

Diagnostic usageError(std::string message) {
  Diagnostic diagnostic;
  diagnostic.code = "usage";
  diagnostic.message = std::move(message);
  return diagnostic;
}

}  // namespace proveout
