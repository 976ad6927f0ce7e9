// Figures of found faces as a drawing has them.
#pragma once

#include <vector>

#include "core/mesh/cad_faces.h"

namespace proveout {

/// A face and points that it was fitted to.
struct FittedFace {
  CadFace face;
  std::vector<Vec3> points;
  double weight = 0.0;  ///< of several faces the heaviest gives the figures
};

/// How far the points are off the face at most, mm.
double residualOf(const CadFace& face, const std::vector<Vec3>& points);

/// Gives faces the directions of the frame's axes, or of each other, common axes and round figures, each
/// where the points stay within `near_mm` of the face.
void tidyFaces(double near_mm, std::vector<FittedFace>& faces);

}  // namespace proveout
