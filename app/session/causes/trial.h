// What if: the run again with one thing put otherwise, as far as it takes to see whether a finding goes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/session/causes/changed_source.h"
#include "app/session/causes/trial_budget.h"
#include "app/session/run/prepared_run.h"

namespace proveout {

/// One thing that is put otherwise.
struct Trial {
  std::uint32_t setup = 0;         ///< clamping whose program or data it is
  std::optional<TextChange> text;  ///< a place of the program
  /// A datum of the job. False: it cannot be put so.
  std::function<bool(Job& job)> datum;
};

/// Runs trials of one run. Milled parts are asked as blank less swept volumes, near the samples alone; all
/// others are machined again.
class TrialBench {
 public:
  /// All must outlive this. `reach_mm`: deviations are measured up to there.
  TrialBench(const Job& job, const RunSources& sources, const Blank& blank, const TriMesh& nominal,
             const RunResult& run, Progress& progress);

  /// Whether trials can be run at all: not where programs measure the workpiece, come from templates, or go
  /// in several channels, and not for a stock from a file.
  bool works() const { return works_; }
  /// Deviations of the machined part from the nominal at these points of its surface (frame of the last
  /// clamping), mm, excess positive, up to `reach_mm`. Empty: the program would end in an alarm, or the trial
  /// cannot be run.
  /// Also empty: the trial is too large for what is left of the budget.
  std::vector<double> deviations(const Trial& trial, const std::vector<Vec3>& samples, double reach_mm,
                                 TrialBudget& budget) const;
  /// The same of the run as it is.
  std::vector<double> deviations(const std::vector<Vec3>& samples, double reach_mm) const;
  /// As many trials as take about as long as the run itself, estimated from its size alone.
  TrialBudget budget() const;

 private:
  struct Changed;
  double sizeWith(const Changed* changed) const;
  std::optional<Changed> changedSetup(const Trial& trial) const;
  /// `changed`: null for the run as it is.
  std::vector<double> ofSweptPart(const Changed* changed, const std::vector<Vec3>& samples,
                                  double reach_mm) const;
  std::vector<double> machinedAgain(const Changed& changed, const std::vector<Vec3>& samples,
                                    double reach_mm) const;

  const Job& job_;
  const RunSources& sources_;
  const Blank& blank_;
  const TriMesh& nominal_;
  const RunResult& run_;
  Progress& progress_;
  bool works_ = false, swept_ = false;
};

}  // namespace proveout
