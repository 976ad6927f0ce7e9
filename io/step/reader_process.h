// A program that reads a file for us, and what it said.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace proveout {

struct ReaderEnd {
  int exit_code = 0, signal = 0;  ///< one of them is 0
  bool too_long = false;          ///< it was ended, or ended itself, for want of time
  bool interrupted = false;       ///< Ctrl-C reached it
  std::string bytes;              ///< its standard output
  std::string told;               ///< its standard error, up to some kB
};

/// Runs `program` and waits for it. It is killed where it takes three times `most_s`, and is expected to end
/// itself behind so much processor time. Errors: it cannot be started, its output does not fit into memory.
Result<ReaderEnd> runReader(const std::string& program, const std::vector<std::string>& arguments,
                            int most_s);

}  // namespace proveout
