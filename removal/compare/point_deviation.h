// The deviation of single points of the machined surface, for pictures and questions.
#pragma once

#include <memory>

#include "removal/compare/measured_sides.h"

namespace proveout {

/// Measures as measureSides() does: on the exact part where that may matter. Keeps what it needs of the
/// options.
std::unique_ptr<DeviationField> makeDeviationField(std::shared_ptr<const NominalModel> nominal,
                                                   const CompareOptions& options);

}  // namespace proveout
