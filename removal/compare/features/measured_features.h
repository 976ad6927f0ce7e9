// The dimensions that the features of a model have on the machined part.
#pragma once

#include <vector>

#include "removal/compare/exact_part.h"
#include "removal/compare/features/face_fit.h"
#include "removal/compare/features/feature.h"

namespace proveout {

/// Fills in `measured` and `missing` from the faces as they fit the part. Whether a through hole goes through
/// is asked of the part itself: its depth is what is free in it.
void measureFeatures(const CadFaces& faces, const std::vector<FaceFit>& fits, const ExactPart& part,
                     std::vector<Feature>& features);

}  // namespace proveout
