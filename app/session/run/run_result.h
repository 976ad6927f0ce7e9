// What a run makes, one clamping after the other.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/forecast/prediction.h"
#include "app/session/run/interpreted.h"
#include "app/session/run/recording_source.h"
#include "io/job/job.h"
#include "io/report.h"
#include "removal/compare/compare.h"
#include "removal/compare/fit/alignment.h"
#include "removal/compare/part/part_feature.h"
#include "removal/grid/stock.h"
#include "removal/process/part_form.h"

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
  std::size_t mesh_bodies = 0;               ///< so many of them are in the surface's mesh, the first ones
  std::optional<std::size_t> rival;          ///< see Machined::rival
  MeshTopology topology;                     ///< of the surface's mesh
  MeshExtent extent;                         ///< of the surface's mesh
  std::string mesh_sha256;                   ///< of the surface's mesh
  double initial_error_mm3 = 0.0;            ///< by how much that may be off, about
  double initial_mm3 = 0.0;                  ///< before it: of the blank, or of the stock that came before
  std::vector<TriMesh> freed;                ///< see Machined::freed
  std::size_t freed_self_intersections = 0;  ///< see Machined
  std::shared_ptr<const PartForm> form = PartForm::plain();
  /// Of a mesh from a section: how far it may leave that and its threads, mm; 0: it comes from a grid.
  double facet_error_mm = 0.0;
};

/// What a run makes. Stages that were not reached leave their part empty.
struct RunResult {
  std::vector<SetupRun> setups;  ///< at least one
  bool alarm = false;            ///< a program or its tools are wrong: nothing was cut
  double resolution_mm = 0.0;
  std::optional<Stock> stock;  ///< after the last clamping; of turned parts only where a grid was needed
  std::optional<Comparison> comparison;
  std::optional<Alignment> alignment;      ///< of the nominal, where the job asks for one
  std::vector<PartFeature> part_features;  ///< [[characteristic]] of the part as a whole, as measured
  std::vector<Finding> findings;
  std::optional<TriMesh> nominal;  ///< as it was compared; none where nothing is left of the part
  Prediction prediction;           ///< its time is that of this machine
  ReportPerformance performance;

  /// Of the part: after the last clamping, in its frame.
  const StockSurface& surface() const { return setups.back().surface; }
  const MeshTopology& topology() const { return setups.back().topology; }
  /// Whether its mesh is made of a section's facets, not of a grid's cells.
  bool isOfFacets() const { return setups.back().facet_error_mm > 0.0; }
  /// What it was made with, mm: the profile resolution, or the grid's spacing.
  double meshResolution() const {
    return isOfFacets() ? setups.back().job.simulation.profile_resolution_mm : resolution_mm;
  }
};

/// The programs of a run, one source a clamping; they outlive the run.
using RunSources = std::vector<const RecordingSource*>;

}  // namespace proveout
