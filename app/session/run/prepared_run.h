// A run that is ready to be machined.
#pragma once

#include <optional>

#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"
#include "removal/compare/nominal.h"

namespace proveout {

/// A run before anything is cut: programs interpreted, files read, memory and time predicted.
struct PreparedRun {
  RunResult run;
  Blank blank;
  std::optional<PreparedMesh> nominal;
};

}  // namespace proveout
