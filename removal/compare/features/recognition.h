// Features of a model from its faces and how they meet.
#pragma once

#include <vector>

#include "removal/compare/features/face_network.h"
#include "removal/compare/features/feature.h"

namespace proveout {

/// How exactly faces are known: those of a CAD model to the last digits, those found in a mesh to its chord.
struct FaceAccuracy {
  double near_mm = 1e-4;
  double near_rad = 1e-5;
};

/// Holes (through, blind, stepped, countersunk), bosses, pockets and slots, then the planes, cones, spheres
/// and fillets that are no part of these, in the order of the faces. Characteristics have their nominal
/// values.
std::vector<Feature> recognizeFeatures(const FaceNetwork& network, const FaceAccuracy& accuracy);

}  // namespace proveout
