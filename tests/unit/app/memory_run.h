// A run whose programs are texts of the test.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace proveout::app_test {

/// One program a clamping, each with the name part.nc.
inline Result<RunResult> run(const Job& job, const std::vector<std::string>& programs) {
  std::vector<std::unique_ptr<MemoryProgramSource>> memory;
  std::vector<std::unique_ptr<RecordingSource>> sources;
  RunSources all;
  for (const std::string& program : programs) {
    memory.push_back(std::make_unique<MemoryProgramSource>("part.nc", program));
    sources.push_back(std::make_unique<RecordingSource>(*memory.back(), TextEncoding::kAuto));
    all.push_back(sources.back().get());
  }
  Progress progress;
  return runRecorded(job, all, progress);
}

}  // namespace proveout::app_test
