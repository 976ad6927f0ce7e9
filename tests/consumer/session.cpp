// Runs a whole job from memory as a library: progress, findings, mesh; then cancels one.
#include "app/session/session.h"

#include <atomic>
#include <cstdio>

#include "app/session/run/job_defaults.h"

using namespace proveout;

namespace {

const char* const kJob = R"(schema = "proveout.job/1"
control = "nct"
program = "slot.nc"
[stock]
shape = "box"
min = [0, 0, 0]
max = [20, 20, 10]
[[tool]]
number = 1
type = "flat"
diameter = 4
[[fixture]]
name = "clamp"
shape = "box"
min = [8, 22, 0]
max = [12, 24, 10]
[simulation]
resolution = 0.5
)";
const char* const kProgram = "G21 G90 T1 M6\nS1000 M3\nG0 X10 Y-5 Z8\nN7 G1 Y25 F100\nG0 Z50\nM30\n";

/// Counts what it is told and can cancel at the first word.
class Watcher : public Progress {
 public:
  explicit Watcher(bool cancels) : cancels_(cancels) {}
  void report(std::string_view, double) override {
    ++reports;
    if (cancels_) cancel();
  }
  std::atomic<int> reports{0};

 private:
  bool cancels_;
};

Result<RunResult> run(Watcher& watcher) {
  JobNames names = jobNames();
  names.programs_in_memory = true;
  Diagnostics diagnostics;
  const std::optional<Job> job = parseJob(kJob, "slot.toml", "", names, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) std::fprintf(stderr, "%s\n", d.message.c_str());
  if (!job) return inputError("the job is wrong");
  const MemoryProgramSource program("slot.nc", kProgram);
  return runJob(*job, {&program}, watcher);
}

}  // namespace

int main() {
  Watcher watcher(false), impatient(true);
  const Result<RunResult> result = run(watcher);
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    return 2;
  }
  for (const Finding& f : result->findings)
    std::printf("%s in N%lld\n", std::string(findingKindName(f.kind)).c_str(),
                f.source ? static_cast<long long>(f.source->block) : -1);
  std::printf("volume %.1f mm3, closed %d, progress %d\n", meshVolume(result->surface().mesh),
              result->topology().closedManifold(), watcher.reports > 0);
  const Result<RunResult> cancelled = run(impatient);
  std::printf("cancelled %d\n", !cancelled && cancelled.error().kind == ErrorKind::kInterrupted);
  return 0;
}
