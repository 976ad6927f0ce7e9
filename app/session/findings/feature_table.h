// The faces of the CAD model as characteristics: nominal and simulated values.
#pragma once

#include <vector>

#include "io/report.h"
#include "removal/compare/comparison.h"

namespace proveout {

/// A row for each exact face of the nominal that was compared: holes and cylinders by diameter, place and
/// roundness, other rounds by radius, planes by height and flatness, all others by their largest distances.
/// Empty where the nominal is a mesh.
std::vector<ReportFeature> featureTable(const Comparison& comparison);

}  // namespace proveout
