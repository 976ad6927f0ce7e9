#include "app/console.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/exit_codes.h"

namespace proveout {

void ConsoleProgress::report(std::string_view phase, double done) {
  if (!shown_.load(std::memory_order_relaxed)) return;
  const int percent = static_cast<int>(std::clamp(done, 0.0, 1.0) * 100.0);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (phase == phase_ && percent <= percent_) return;
  phase_ = phase;
  percent_ = percent;
  const std::string line = fmt::format("{} {} %", phase, percent);
  width_ = std::max(width_, line.size());
  err_ << fmt::format("\r{:<{}}", line, width_) << std::flush;
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
  console.err << "proveout: " << what << ": " << error.message << "\n";
  return exitCodeOf(error.kind);
}

void printDiagnostics(Console& console, const std::vector<Diagnostic>& diagnostics, Severity least) {
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity >= least) console.err << formatDiagnostic(diagnostic);
  }
}

Diagnostic usageError(std::string message) {
  Diagnostic diagnostic;
  diagnostic.code = "usage";
  diagnostic.message = std::move(message);
  return diagnostic;
}

}  // namespace proveout
