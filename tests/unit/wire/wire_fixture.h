// Ways of a wire for tests, and what may be asked of a mesh.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/wire/section/kerf_section.h"

namespace proveout::test {

inline WireStretch lineWay(const Vec2& from, const Vec2& to, double kerf_mm, MotionId motion) {
  WireStretch s;
  s.from = from;
  s.to = to;
  s.kerf_mm = kerf_mm;
  s.motion = motion;
  return s;
}

inline WireStretch arcWay(const Vec2& from, const Vec2& center, double sweep_rad, double kerf_mm,
                          MotionId motion) {
  WireStretch s = lineWay(from, center + turnedBy(from - center, sweep_rad), kerf_mm, motion);
  s.center = center;
  s.sweep_rad = sweep_rad;
  return s;
}

/// A closed polygon, a motion a side.
inline std::vector<WireStretch> closedWay(const std::vector<Vec2>& corners, double kerf_mm) {
  std::vector<WireStretch> way;
  for (std::size_t i = 0; i < corners.size(); ++i)
    way.push_back(lineWay(corners[i], corners[(i + 1) % corners.size()], kerf_mm, static_cast<MotionId>(i)));
  return way;
}

inline double totalArea(const std::vector<PlaneBody>& bodies) {
  double sum = 0.0;
  for (const PlaneBody& body : bodies) sum += body.area_mm2;
  return sum;
}

/// Of the triangles at a height, mm2; those that are turned over count as well.
inline double faceArea(const TriMesh& mesh, float z) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    if (a.z() == z && b.z() == z && c.z() == z)
      sum += 0.5 * (b - a).cast<double>().cross((c - a).cast<double>()).norm();
  }
  return sum;
}

}  // namespace proveout::test
