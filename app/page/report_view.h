// The 3-D view of report.html, from what a run or a comparison made.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"
#include "io/report/report_page.h"
#include "io/report/view/scene_data.h"

namespace proveout {

/// What is drawn besides the tool path. Null: there is none.
struct ViewInput {
  const TriMesh& part;
  const TriMesh* nominal = nullptr;
  const Comparison* comparison = nullptr;
  const std::vector<DeviationBand>& bands;  ///< whose colours are taken; empty: the usual scale
  const std::vector<Finding>& findings;     ///< with their places in the part's frame, in the report's order
};

/// Differences of deviation below this are not looked for between the places that were measured, mm.
double shownDeviation(const Comparison& comparison);

/// The view of a run's part with its tool path. No view where the part has no triangles.
ReportView viewOfRun(const RunResult& run, const RunSources& sources, const ViewInput& input,
                     const Progress& progress);
/// The same without a program.
ReportView viewOfMeshes(const ViewInput& input, const Progress& progress);

}  // namespace proveout
