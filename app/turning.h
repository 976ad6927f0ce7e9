// The branch of the pipeline for controls that turn the part: the stock is a half section until a thread or a
// saved grid needs more.
#pragma once

#include <vector>

#include "app/outputs.h"
#include "app/run_result.h"
#include "removal/turning/section.h"

namespace proveout {

/// Whether the job's control turns the part about Z.
bool turnsPart(const Job& job);

/// Refuses what turning cannot start from: a blank or a fixture that is not round about Z, clampings that do
/// not keep the axis.
Status checkTurning(const Job& job, const Blank& blank);

/// Distance of the start from the blank along X and along Z, mm.
inline constexpr double kTurningClearanceMm = 10.0;
/// Where the touch-off point of a turning tool starts if the job does not say: outside of the blank and in
/// front of it.
Vec3 turningStart(const Box3& blank);

/// Cuts all clampings, one after the other, and fills everything of them but topology and findings.
/// `run.stock` is made where a grid is to be saved, or the half sections of a thread do not go over into
/// each other. `nominal`: null, or what tells which
/// of several bodies is the part.
Status machineTurned(const Job& job, const Blank& blank, const TriMesh* nominal, RunResult& run,
                     Progress& progress);

/// Bodies that were cut off, or stayed on the bar, beside the part.
void addPartedBodies(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings);

/// Writes the profile chart of the part, or nothing where there is none.
void writeTurnedProfile(const Job& job, const RunResult& run, StagingFolder& staging, Report& report,
                        OutputFailures& failures);

/// Measuring moves against the part as it has been turned so far.
class TurningProbe : public Probe {
 public:
  /// `path` gets what the control does and must hold everything before the move that is asked about.
  TurningProbe(const StockShape& blank, const std::vector<Tool>& tools, const Toolpath& path,
               Progress& progress)
      : blank_(blank), tools_(tools), path_(path), progress_(progress) {}
  /// Errors: a tool that the job does not define, a way out of the plane of the spindle axis, cancelled.
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry* arc,
                                             const AxisSweep* axis) override;
  /// Why the part could not answer.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  const StockShape& blank_;
  const std::vector<Tool>& tools_;
  const Toolpath& path_;
  Progress& progress_;
  std::optional<Error> failure_;
};

/// How far a turned surface may be off, mm: of the part's mesh.
double turnedUncertainty(const SetupRun& setup, double resolution_mm);

}  // namespace proveout
