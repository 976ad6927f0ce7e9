// Where a command talks to people: results to `out`, diagnostics and progress to `err`.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <ostream>
#include <string>

#include "app/session/forecast/prediction.h"
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
  using Clock = std::function<double()>;  ///< seconds from any fixed time on
  explicit ConsoleProgress(std::ostream& err, Clock clock = {});
  void show(bool on) { shown_.store(on); }
  void report(std::string_view phase, double done) override;
  /// Tells what the run will take, where progress is shown; the time left counts from here.
  void expect(const Prediction& prediction);
  /// Asks the work to stop because its time is over; async-signal-safe.
  void expire() noexcept;
  bool expired() const noexcept { return expired_.load(); }
  /// What is being done, with how much of it: "removing, 40 % done"; empty: nothing was told.
  std::string phase() const;
  /// Takes the line away; call before anything else is printed.
  void clear();

 private:
  std::ostream& err_;
  std::mutex mutex_;
  std::atomic<bool> shown_{false}, expired_{false};
  std::atomic<const char*> now_{nullptr};  ///< the phases are texts of the program's own
  std::atomic<int> now_percent_{0};
  std::string timeLeft(double now_s, double done) const;

  Clock clock_;
  double start_s_ = 0.0, expected_s_ = 0.0, phase_start_s_ = 0.0;
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
