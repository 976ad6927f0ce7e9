// The files of a run. They are made in a folder aside and moved into place together at the end, so that a run
// that fails or is interrupted leaves earlier results alone.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/accounting.h"
#include "app/pictures.h"
#include "core/base/result.h"
#include "io/job.h"
#include "io/profile_chart.h"
#include "io/report.h"
#include "removal/stock.h"

namespace proveout {

/// A folder inside the target that is removed with what is left in it when the object goes.
class StagingFolder {
 public:
  /// Makes `target` and a new folder in it.
  static Result<StagingFolder> create(const std::string& target);
  StagingFolder(StagingFolder&& other) noexcept;
  StagingFolder(const StagingFolder&) = delete;
  ~StagingFolder();

  /// Path aside of a file that will be called `name`.
  std::string path(const std::string& name);
  /// Moves every file asked for into the target. Call once, when all are complete.
  Status commit();

 private:
  StagingFolder() = default;
  std::string target_, aside_;
  std::vector<std::string> names_;
};

/// Writes the files that a program wrote, in "files", those of clampings in a folder of their name in it.
Status writeProgramFiles(const std::map<std::string, std::string>& files, const std::string& setup,
                         StagingFolder& staging);

/// Writes mesh files and, from `stock`, grids, and records them in the report with their hashes.
Status writeMeshes(const TriMesh& mesh, const Stock* stock, const Job& job, StagingFolder& staging,
                   Report& report);

/// Writes blocks.csv and, where something was cut, mrr.svg; records them in the report.
Status writeTables(const std::vector<CutPath>& paths, StagingFolder& staging, Report& report);

/// Writes profile.svg, the half section of a turned part with its deviations, and records it and the chart
/// for report.html in the report; does nothing where there is nothing to draw. `machined`: closed loops (r,
/// z) as in drawProfileChart; `nominal`: closed mesh about the Z axis of the workpiece frame, null: none.
Status writeProfileChart(const std::vector<std::vector<Vec2>>& machined, const TriMesh* nominal,
                         const ProfileChartOptions& options, StagingFolder& staging, Report& report);

/// Writes pictures, report.json, junit.xml and report.html; records the pictures.
Status writeReport(const std::vector<Picture>& pictures, StagingFolder& staging, Report& report);

}  // namespace proveout
