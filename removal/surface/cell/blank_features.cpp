#include "removal/surface/cell/blank_features.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/intersections.h"
#include "removal/grid/edge_root.h"
#include "removal/surface/cell/cell_faces.h"

namespace proveout {

namespace {

/// In cells: how exactly a point is on the blank, and how far away it is looked for.
constexpr double kOn = 1e-3, kReach = 2.0;
constexpr int kMeetRounds = 8;
constexpr std::size_t kMostFaces = 8;

/// As Crossing::face() numbers them.
void addFace(const BlankSample& s, std::vector<std::uint64_t>& faces) {
  const std::uint64_t face = static_cast<std::uint64_t>(s.motion) << 16 | static_cast<std::uint64_t>(s.face);
  if (faces.size() < kMostFaces && std::find(faces.begin(), faces.end(), face) == faces.end())
    faces.push_back(face);
}

}  // namespace

double BlankFeatures::off(const Vec3& p) const { return std::abs(field_.value(p)); }

/// The blank's faces at these triangles.
std::vector<std::uint64_t> BlankFeatures::facesOf(std::span<const std::uint32_t> triangles) const {
  std::vector<std::uint64_t> faces;
  for (const std::uint32_t t : triangles) {
    const auto [a, b, c] = cornersOf(mesh_, t);
    addFace(field_.sample((a + b + c) / 3.0), faces);
  }
  return faces;
}

/// Where faces meet near `m`, by Newton's method, on the blank's surface or not. False: not near.
bool BlankFeatures::meet(std::span<const std::uint64_t> faces, const Vec3& m, Vec3& x) const {
  x = m;
  std::array<Plane, 3> planes;
  PROVEOUT_ASSERT(!faces.empty() && faces.size() <= planes.size());
  for (int round = 0; round < kMeetRounds; ++round) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto foot = field_.facePoint(faces[i], x, 3.0 * h_);
      if (!foot) return false;
      planes[i] = {foot->normal, foot->normal.dot(foot->p - x)};
    }
    const Vec3 step = meetPlanes({planes.data(), faces.size()});
    x += step;
    if (!((x - m).norm() < kReach * h_)) return false;
    if (step.norm() < 1e-2 * kOn * h_) break;
  }
  return true;
}

/// The point between `m` and `x` where the line crosses the blank's surface; `x` if both are on one side.
Vec3 BlankFeatures::surfaceBetween(const Vec3& m, const Vec3& x) const {
  const auto value = [&](double s) { return field_.value(m + s * (x - m)); };
  const double at_m = value(0.0), at_x = value(1.0);
  if ((at_m < 0.0) == (at_x < 0.0)) return x;
  const double at =
      at_m < 0.0 ? edgeRoot(value, 1.0, at_x, 0.0, at_m, kOn) : edgeRoot(value, 0.0, at_m, 1.0, at_x, kOn);
  return m + at * (x - m);
}

/// Adds sliver faces: they cut off edges of the known faces, and are too narrow to have triangles.
void BlankFeatures::addSliverFaces(const Vec3& m, std::vector<std::uint64_t>& faces) const {
  for (std::size_t i = 1; i < faces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 x;
      if (!meet(std::array{faces[i], faces[j]}, m, x)) continue;
      if (off(x) >= kOn * h_) addFace(field_.sample(surfaceBetween(m, x)), faces);
    }
  }
}

std::vector<Vec3> BlankFeatures::near(const Vec3& m, std::span<const std::uint32_t> patch) const {
  std::vector<std::uint64_t> faces = facesOf(patch);
  addSliverFaces(m, faces);
  std::vector<Vec3> out;
  const auto add = [&](std::span<const std::uint64_t> some) {
    Vec3 x;
    if (meet(some, m, x) && off(x) < kOn * h_) out.push_back(x);
  };
  for (std::size_t i = 0; i < faces.size(); ++i) {
    add(std::array{faces[i]});
    for (std::size_t j = 0; j < i; ++j) {
      add(std::array{faces[i], faces[j]});
      for (std::size_t k = 0; k < j; ++k) add(std::array{faces[i], faces[j], faces[k]});
    }
  }
  return out;
}

}  // namespace proveout
