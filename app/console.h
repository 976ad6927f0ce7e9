// Where a command talks to people: results to `out`, diagnostics and progress to `err`.
#pragma once

#include <atomic>
#include <mutex>
#include <ostream>
#include <string>

#include "core/base/diagnostics.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace proveout {

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;
};

/// Progress that writes one line over and over while it is shown. report() may come from any thread.
class ConsoleProgress : public Progress {
 public:
  explicit ConsoleProgress(std::ostream& err) : err_(err) {}
  void show(bool on) { shown_.store(on); }
  void report(std::string_view phase, double done) override;
  /// Takes the line away; call before anything else is printed.
  void clear();

 private:
  std::ostream& err_;
  std::mutex mutex_;
  std::atomic<bool> shown_{false};
  std::string phase_;
  int percent_ = -1;
  std::size_t width_ = 0;
};

/// "proveout: error: text"; returns the exit code of the error.
int printError(Console& console, const Error& error);
/// Prints diagnostics of at least this severity.
void printDiagnostics(Console& console, const std::vector<Diagnostic>& diagnostics,
                      Severity least = Severity::kNote);
/// A diagnostic without a place, for wrong options.
Diagnostic usageError(std::string message);

}  // namespace proveout
