// The files of a run. They are made in a folder aside and moved into place together at the end, so that a run
// that fails or is interrupted leaves earlier results alone.
#pragma once

#include <functional>
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

/// A folder inside the target that is removed with what is left in it when the object goes; so are folders
/// that were made for it and are empty.
class StagingFolder {
 public:
  /// Makes `target` and a new folder in it.
  static Result<StagingFolder> create(const std::string& target);
  StagingFolder(StagingFolder&& other) noexcept;
  StagingFolder(const StagingFolder&) = delete;
  ~StagingFolder();

  /// Lets `make` write the file that will be called `name` to a path aside. A file that fails is left out.
  /// Errors: those of `make`; a folder stands in the target under that name.
  Status write(const std::string& name, const std::function<Status(const std::string& path)>& make);
  /// Moves every file into the target. Call once, when all are complete. The error is that of the first one
  /// that cannot be moved; the others are.
  Status commit();

 private:
  StagingFolder() = default;
  std::string asTarget(std::string message) const;

  std::string target_, aside_;
  std::vector<std::string> names_;
  std::vector<std::string> made_;  ///< folders that were not there, the innermost first
};

/// What could not be written of the outputs of a run; the others are there.
using OutputFailures = std::vector<Error>;

/// Checks before a run that its outputs can be made and its files be read: the folder, and the module that
/// .vdb files and meshes as stock or fixtures need.
Status checkOutputs(const Job& job, const std::string& folder);

/// Writes the files that a program wrote, in "files", those of clampings in a folder of their name in it.
void writeProgramFiles(const std::map<std::string, std::string>& files, const std::string& setup,
                       StagingFolder& staging, OutputFailures& failures);

/// Writes mesh files and, from `stock`, grids, and records them in the report with their hashes.
void writeMeshes(const TriMesh& mesh, const Stock* stock, const Job& job, StagingFolder& staging,
                 Report& report, OutputFailures& failures);

/// Writes blocks.csv and, where something was cut, mrr.svg; records them in the report.
void writeTables(const std::vector<CutPath>& paths, StagingFolder& staging, Report& report,
                 OutputFailures& failures);

/// Writes profile.svg, the half section of a turned part with its deviations, and records it and the chart
/// for report.html in the report; does nothing where there is nothing to draw. `machined`: closed loops (r,
/// z) as in drawProfileChart; `nominal`: closed mesh about the Z axis of the workpiece frame, null: none.
void writeProfileChart(const std::vector<std::vector<Vec2>>& machined, const TriMesh* nominal,
                       const ProfileChartOptions& options, StagingFolder& staging, Report& report,
                       OutputFailures& failures);

/// Writes pictures, report.html, junit.xml and report.json; records the pictures. What failed before, and
/// fails here, is told by those that come behind it, as findings of kind "output".
void writeReport(const std::vector<Picture>& pictures, StagingFolder& staging, Report& report,
                 OutputFailures& failures);

/// The exit code of a run: that of its report, unless an output is missing.
int exitCodeOf(const Report& report, const OutputFailures& failures);

}  // namespace proveout
