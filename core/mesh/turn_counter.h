// How far round a face goes, by its triangles.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/cad_faces.h"

namespace proveout {

/// How far round an axis triangles go, in steps of half a degree.
class TurnCounter {
 public:
  explicit TurnCounter(const CadFace& face)
      : origin_(face.origin), u_(face.axis.unitOrthogonal()), v_(face.axis.cross(u_)) {}
  void add(const std::array<Vec3, 3>& corners) {
    double angle[3];
    for (std::size_t c = 0; c < 3; ++c)
      angle[c] = std::atan2((corners[c] - origin_).dot(v_), (corners[c] - origin_).dot(u_));
    double low = 0.0, high = 0.0;  // beside the first corner; the short way round
    for (std::size_t c = 1; c < 3; ++c) {
      const double by = std::remainder(angle[c] - angle[0], 2.0 * kPi);
      low = std::min(low, by);
      high = std::max(high, by);
    }
    const long first = std::lround((angle[0] + low) / kStep), last = std::lround((angle[0] + high) / kStep);
    for (long k = first; k < last; ++k)
      seen_[static_cast<std::size_t>((k % kSteps + kSteps) % kSteps)] = true;
  }
  double turn() const { return kStep * static_cast<double>(std::count(seen_.begin(), seen_.end(), true)); }

 private:
  static constexpr long kSteps = 720;
  static constexpr double kStep = 2.0 * kPi / kSteps;
  Vec3 origin_, u_, v_;
  std::array<bool, kSteps> seen_{};
};

/// Fills in how far round the marked faces go that are cylinders or cones; `marked`: one a face.
void countTurns(const TriMesh& mesh, const std::vector<bool>& marked, CadFaces& faces);

}  // namespace proveout
