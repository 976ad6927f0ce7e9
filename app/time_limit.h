// The time that a command may take.
#pragma once

#include "app/console.h"

namespace proveout {

/// Ends the command within a time, counted from the making of this object. A little before it is over (a
/// tenth of it, a second at most) the work is asked to stop, as by an interrupt, so that nothing is left
/// behind; what does not stop is ended with the process, exit code 3, when it is over, and files that are
/// just being written are finished or removed first. Uses the process's interval timer and SIGALRM: one
/// object at a time.
class TimeLimit {
 public:
  explicit TimeLimit(ConsoleProgress& progress);
  TimeLimit(const TimeLimit&) = delete;
  ~TimeLimit();

  /// Sets the limit, s; the first one that is above 0 counts.
  void set(double seconds);

  /// The error of a command: that of the time limit in place of an interrupt that it made.
  Error told(const Error& error) const;

  double limit() const { return limit_s_; }  ///< s; 0: none

 private:
  ConsoleProgress& progress_;
  double start_s_ = 0.0, limit_s_ = 0.0;
};

}  // namespace proveout
