// A program run as a child, with what it took.
#pragma once

#include <string>
#include <vector>

namespace proveout::bench {

struct ChildOutcome {
  bool ended = false;    ///< false: could not be started, or stopped at the limit
  int exit_code = -1;    ///< 128 + signal if it was killed
  double wall_s = 0.0;   ///< from start to end
  double cpu_s = 0.0;    ///< of all its threads, user and system
  double peak_mb = 0.0;  ///< largest resident set, MiB
};

/// Runs `command` (a path and its arguments) with stdout to nowhere and stderr to `errors`, a file. After
/// `limit_s` seconds of wall time it is killed.
ChildOutcome runChild(const std::vector<std::string>& command, const std::string& errors, double limit_s);

}  // namespace proveout::bench
