// Close-ups of findings and the program around their blocks, for report.html.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/run/run_result.h"
#include "io/report/report_page.h"

namespace proveout {

/// Draws a finding of that number from near, seen from `back` (unit, from the part to the eye), `width_mm` of
/// the part, and gives the bytes of a PNG file; empty: it cannot be drawn. Errors: interrupted.
using DrawCloseUp = std::function<Result<std::string>(std::size_t number, const Finding& finding,
                                                      const Vec3& back, double width_mm)>;

/// Of the first findings that have a place or a block. `findings`: with their places in the mesh's frame, in
/// the report's order. `run`, `sources`: null: there is no program. Errors: interrupted.
Result<std::vector<FindingDetail>> findingDetails(const DrawCloseUp& draw, const TriMesh& mesh,
                                                  const std::vector<Finding>& findings, const RunResult* run,
                                                  const RunSources* sources);

}  // namespace proveout
