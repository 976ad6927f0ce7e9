// Runs the jobs of a random case inside this process, and with the program for what needs one of its own.
#pragma once

#include <optional>
#include <string>

#include "app/session/session.h"
#include "tests/acceptance/program_runner.h"
#include "tests/soak/soak_case.h"

namespace proveout::soak {

struct RunOptions {
  int threads = 1;
  int until = 0;  ///< line of the last program; 0: all of it
};

/// A case in a folder of its own.
class CaseRunner {
 public:
  explicit CaseRunner(const SoakCase& made);

  const SoakCase& made() const { return made_; }
  /// Errors: the job or a program of it is refused.
  Result<RunResult> run(const std::string& job, const RunOptions& options = {});
  /// What the program reports of job.toml at this SIMD level. Nothing: it fails.
  struct Reported {
    std::string part_sha256;
    double peak_mb = 0.0, predicted_mb = 0.0;  ///< of memory
  };
  std::optional<Reported> report(const std::string& simd_level, int threads);
  Job load(const std::string& job, std::string& error) const;

 private:
  SoakCase made_;
  test::Workbench bench_;
  std::optional<Error> before_;  ///< the stock could not be saved
};

}  // namespace proveout::soak
