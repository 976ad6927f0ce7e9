// The files of a run: what they are called and how they are written. They are made in a StagingFolder.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/pictures.h"
#include "app/session/findings/accounting.h"
#include "app/staging_folder.h"
#include "core/base/result.h"
#include "io/job/job.h"
#include "io/report.h"
#include "io/report/profile_chart.h"
#include "io/report/report_page.h"
#include "removal/grid/stock.h"

namespace proveout {

/// What could not be written of the outputs of a run; the others are there.
using OutputFailures = std::vector<Error>;

/// Names of all files that a run of the job may write into its folder, but for those that its programs write.
std::vector<std::string> outputNames(const Job& job);
/// Names of all files that a comparison of two meshes may write. `deviations`: files of them.
std::vector<std::string> comparisonOutputNames(const std::vector<std::string>& deviations = {});

/// Errors: one of the names would be written over an input.
Status checkNames(const std::vector<std::string>& names, const std::string& folder, const OutputGuard& guard);

/// Checks before a run that its outputs can be made and its files be read: that no input is in their way, the
/// folder, and the module that .vdb files and meshes as stock or fixtures need.
Status checkOutputs(const Job& job, const std::string& folder, const OutputGuard& guard);

/// Where a file that a program wrote is put, below the folder of the results. `setup`: of the clamping.
std::string programFileName(const std::string& setup, const std::string& name);

/// Writes the files that a program wrote, in "files", those of clampings in a folder of their name in it.
void writeProgramFiles(const std::map<std::string, std::string>& files, const std::string& setup,
                       StagingFolder& staging, OutputFailures& failures);

/// Writes mesh files and, from `stock`, grids, and records them in the report with their hashes.
void writeMeshes(const TriMesh& mesh, const Stock* stock, const Job& job, StagingFolder& staging,
                 Report& report, OutputFailures& failures);

/// File of a piece that was cut free, numbered from 1.
std::string bodyFileName(const Job& job, OutputFormat format, std::size_t number);
/// Writes pieces that were cut free in all mesh formats of the job, and records them as writeMeshes does.
void writeBodies(const std::vector<TriMesh>& bodies, const Job& job, StagingFolder& staging, Report& report,
                 OutputFailures& failures);

/// Writes a drawing of the part's section, and of pieces beside it, at each height that the job asks for. A
/// height without material is a failure.
std::string sectionFileName(double z);
void writeSections(const TriMesh& mesh, const std::vector<TriMesh>& freed, const Job& job,
                   StagingFolder& staging, Report& report, OutputFailures& failures);

/// Writes blocks.csv and, where something was cut, mrr.svg; records them in the report. findings.csv comes
/// with writeReport.
void writeTables(const std::vector<CutPath>& paths, StagingFolder& staging, Report& report,
                 OutputFailures& failures);

/// Writes profile.svg, the half section of a turned part with its deviations, and records it and the chart
/// for report.html in the report; does nothing where there is nothing to draw. `machined`: closed loops (r,
/// z) as in drawProfileChart; `nominal`: closed mesh about the Z axis of the workpiece frame, null: none.
void writeProfileChart(const std::vector<std::vector<Vec2>>& machined, const TriMesh* nominal,
                       const ProfileChartOptions& options, StagingFolder& staging, Report& report,
                       OutputFailures& failures);

/// Writes pictures, findings.csv (with `findings_csv`), report.html, junit.xml and report.json; records the
/// pictures. What failed before, and fails here, is told by those that come behind it, as findings of kind
/// kOutput. `page`: what report.html has besides the pictures.
void writeReport(const std::vector<Picture>& pictures, StagingFolder& staging, Report& report,
                 OutputFailures& failures, PageContent page = {}, bool findings_csv = false);

/// The exit code of a run: that of its report, unless an output is missing.
int exitCodeOf(const Report& report, const OutputFailures& failures);

}  // namespace proveout
