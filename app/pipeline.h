// The main path: job -> tool path -> stock -> surface -> comparison -> findings. Each stage is a function
// that can be called alone; runPipeline calls them in order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/blank.h"
#include "app/findings.h"
#include "app/interpretation.h"
#include "app/prediction.h"
#include "io/job.h"
#include "io/report.h"
#include "removal/compare/compare.h"
#include "removal/stock.h"
#include "removal/turning/section.h"

namespace proveout {

/// One clamping of a run. Stages that were not reached leave their part empty.
struct SetupRun {
  std::string name;  ///< empty in a job without setups
  Job job;           ///< as it is in this clamping, see jobOfSetup
  RigidTransform from_previous;
  Interpreted interpreted;
  RemovalSummary removal;  ///< volumes fitted: their sum is initial less final
  /// After it, in its frame. Its volume is initial_mm3 less what was removed: a move into another clamping
  /// that is not exact changes the grid's own volume, and no tool has taken that.
  StockSurface surface;
  std::vector<StockBody> bodies;
  MeshTopology topology;                      ///< of the surface's mesh
  MeshExtent extent;                          ///< of the surface's mesh
  std::string mesh_sha256;                    ///< of the surface's mesh
  double initial_mm3 = 0.0;                   ///< before it: of the blank, or of the stock that came before
  std::shared_ptr<const TurnedShape> turned;  ///< of a turned part: its bodies, the part first
  /// Of a turned part's mesh: how far it may leave the section and its threads, mm; 0: it comes from a grid.
  double facet_error_mm = 0.0;
};

/// What a run makes. Stages that were not reached leave their part empty.
struct RunResult {
  std::vector<SetupRun> setups;  ///< at least one
  bool alarm = false;            ///< a program or its tools are wrong: nothing was cut
  double resolution_mm = 0.0;
  std::optional<Stock> stock;  ///< after the last clamping; of turned parts only where a grid was needed
  std::optional<Comparison> comparison;
  std::vector<Finding> findings;
  std::optional<TriMesh> nominal;  ///< of turned parts, for the profile chart
  Prediction prediction;
  ReportPerformance performance;

  /// Of the part: after the last clamping, in its frame.
  const StockSurface& surface() const { return setups.back().surface; }
  const MeshTopology& topology() const { return setups.back().topology; }
};

/// Errors: a grid of that spacing would need more memory than the run may have; says which would fit.
Status checkMemory(const Job& job, const Workload& work, double resolution_mm);

/// The programs of a run, one source a clamping; they outlive the run.
using RunSources = std::vector<const RecordingSource*>;

/// How far the mesh may leave the surface to save triangles, mm: a tenth of the grid, but where the part is
/// compared no more than a tenth of what is tolerated.
double simplification(const Job& job, double resolution_mm);
/// With that, and the job's threads.
SurfaceOptions surfaceOptions(const Job& setup, double resolution_mm);

/// Cuts the path of a clamping into the stock and fills removal, surface and volume. The stock comes from the
/// blank, or from the clamping before. `initial_mm3`: its volume as the report tells it, `held`: as
/// Stock::volume tells it now; what is left is the first less what the second falls by. The surface's error
/// is that of what was removed.
Status machineSetup(Stock& stock, double initial_mm3, const StockVolume& held, SetupRun& setup,
                    ReportPerformance& performance, Progress& progress);

/// Adds what was repaired in a mesh as warnings with the given code.
void noteRepairs(const PreparedMesh& mesh, const std::string& code, Diagnostics& diagnostics);

/// Reads the nominal mesh and makes a solid of it; what was repaired becomes warnings.
Result<PreparedMesh> loadNominal(const NominalSpec& nominal);

/// Smallest radius that a tool's cutting surface has, mm: of its corner, or of the wall that it leaves.
double smallestRadius(const Tool& tool);

/// How far the exported surface may lie off the true one: chords of the grid on a wall as curved as the
/// smallest radius of the tools used, h^2 / (8 r), at most half a cell. Flat surfaces are exact. mm.
double surfaceUncertainty(const Toolpath& path, const std::vector<Tool>& tools, double resolution_mm);

/// Largest error of the part's surface over all clampings, mm: a move into another clamping that is not
/// exact adds the chords of the mesh that it is made from (Stock::moved).
double partUncertainty(const RunResult& run);
/// The share of it that moves add, mm; 0 with one clamping.
double movesUncertainty(const RunResult& run);

/// A run before anything is cut: programs interpreted, files read, memory and time predicted.
struct PreparedRun {
  RunResult run;
  Blank blank;
  std::optional<PreparedMesh> nominal;
  bool placement_told = false;  ///< what would bring the nominal onto the blank
};

/// The first part of a run. An error of a program is not an Error: it is in the result, with `alarm` set.
/// Errors: files that cannot be read, a start inside the blank, more memory needed than allowed.
Result<PreparedRun> prepareRun(const Job& job, const RunSources& sources, Progress& progress);
/// The second part. Does nothing after an alarm.
Result<RunResult> finishRun(const Job& job, const RunSources& sources, PreparedRun prepared,
                            Progress& progress);

/// Runs everything, one clamping for each of `sources`. An error of a program is not an Error: it is in the
/// result, with `alarm` set.
Result<RunResult> runPipeline(const Job& job, const RunSources& sources, Progress& progress);

}  // namespace proveout
