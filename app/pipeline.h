// The main path: job -> tool path -> stock -> surface -> comparison -> findings. Each stage is a function
// that can be called alone; runPipeline calls them in order.
#pragma once

#include <optional>
#include <vector>

#include "app/blank.h"
#include "app/findings.h"
#include "app/interpretation.h"
#include "io/job.h"
#include "io/report.h"
#include "removal/compare.h"
#include "removal/stock.h"

namespace proveout {

/// What a run makes. Stages that were not reached leave their part empty.
struct RunResult {
  Interpreted interpreted;
  bool alarm = false;  ///< the program or its tools are wrong: nothing was cut
  double resolution_mm = 0.0;
  std::optional<Stock> stock;
  RemovalSummary removal;
  StockSurface surface;
  double initial_mm3 = 0.0;
  MeshTopology topology;
  std::vector<StockBody> bodies;
  std::string part_sha256;  ///< of the surface's mesh
  std::optional<Comparison> comparison;
  std::vector<Finding> findings;
  ReportPerformance performance;
};

/// The surface of the machined stock and its fitted removal figures.
struct Machined {
  Stock stock;
  RemovalSummary removal;
  StockSurface surface;
  double initial_mm3 = 0.0;  ///< before this run: of the blank, or of the stock that an earlier run saved
};
Result<Machined> machineStock(Blank& blank, const Toolpath& path, const Job& job,
                              ReportPerformance& performance, Progress& progress);

/// Adds what was repaired in a mesh as warnings with the given code.
void noteRepairs(const PreparedMesh& mesh, const std::string& code, Diagnostics& diagnostics);

/// Reads the nominal mesh and makes a solid of it; what was repaired becomes warnings.
Result<PreparedMesh> loadNominal(const NominalSpec& nominal);

/// How far the exported surface may lie off the true one: chords of the grid on a wall as curved as the
/// smallest radius of the tools used, h^2 / (8 r), at most half a cell. Flat surfaces are exact. mm.
double surfaceUncertainty(const Toolpath& path, const std::vector<Tool>& tools, double resolution_mm);

/// Runs everything. An error of the program is not an Error: it is in the result, with `alarm` set.
Result<RunResult> runPipeline(const Job& job, const RecordingSource& source, Progress& progress);

}  // namespace proveout
