// Findings of one clamping.
#pragma once

#include "app/session/run/run_result.h"

namespace proveout {

/// Calls `add`, which adds findings to `run`, and puts the name of the clamping into them.
template <typename Add>
void inSetup(RunResult& run, const SetupRun& setup, const Add& add) {
  const std::size_t before = run.findings.size();
  add(run.findings);
  for (std::size_t i = before; i < run.findings.size(); ++i) run.findings[i].setup = setup.name;
}

}  // namespace proveout
