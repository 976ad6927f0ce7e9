#include "core/mesh/crowded_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "core/base/parallel_for.h"
#include "core/base/stretches.h"
#include "core/geometry/to_float.h"
#include "core/mesh/mean_edge.h"

namespace proveout {
namespace {

using Coords = std::array<int, 3>;

/// Cosine of the angle to the common direction.
constexpr float kFacing = 0.3f;
/// Surface that faces so changes sides within 2 (1 + tan) times what it was moved by: triangles count for
/// cubes so many times that far from them.
constexpr double kReach = 10.0;
/// Edges of a cube in edges of triangles, and in reaches at the least.
constexpr double kCubeEdges = 3.0, kCubeReaches = 2.0;
constexpr double kLeastCube = 1e-9;  ///< mm
/// Cubes for each triangle at the most.
constexpr double kMostCubes = 4.0;

/// Directions between opposite neighbours of a cube, and zeros.
struct Directions {
  static constexpr float kTwo = 0.70710678f, kThree = 0.57735027f;
  alignas(16) std::array<float, 16> x = {1,    0,    0,      kTwo,   kTwo,   0,     0,
                                         kTwo, kTwo, kThree, kThree, kThree, kThree};
  alignas(16) std::array<float, 16> y = {0, 1, 0,      kTwo,   -kTwo,   kTwo,   kTwo,
                                         0, 0, kThree, kThree, -kThree, -kThree};
  alignas(16) std::array<float, 16> z = {0,    0,     1,      0,       0,      kTwo,   -kTwo,
                                         kTwo, -kTwo, kThree, -kThree, kThree, -kThree};
};
constexpr Directions kDirections;

/// Bit i: the triangle faces direction i of the 13; bit i + 16: the opposite one. A triangle that is none
/// faces nowhere.
std::uint32_t facingOf(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  const Eigen::Vector3f n = (b - a).cross(c - a);
  const float x = n.x(), y = n.y(), z = n.z(), least = kFacing * n.norm();
  std::uint32_t bits = 0;
  if (!(least > 0.0f)) return bits;
#if defined(__SSE2__)
  for (std::size_t i = 0; i < 16; i += 4) {
    const auto times = [i](const std::array<float, 16>& d, float by) {
      return _mm_mul_ps(_mm_load_ps(&d[i]), _mm_set1_ps(by));
    };
    const __m128 along =
        _mm_add_ps(_mm_add_ps(times(kDirections.x, x), times(kDirections.y, y)), times(kDirections.z, z));
    const int facing = _mm_movemask_ps(_mm_cmpge_ps(along, _mm_set1_ps(least)));
    const int opposite = _mm_movemask_ps(_mm_cmple_ps(along, _mm_set1_ps(-least)));
    bits |= static_cast<std::uint32_t>(facing | opposite << 16) << i;
  }
#else
  for (std::size_t i = 0; i < 16; ++i) {
    const float along = x * kDirections.x[i] + y * kDirections.y[i] + z * kDirections.z[i];
    bits |= static_cast<std::uint32_t>(along >= least) << i;
    bits |= static_cast<std::uint32_t>(along <= -least) << (i + 16);
  }
#endif
  return bits;
}

/// The cubes, each with the directions that all triangles in it and near to it face.
class Cubes {
 public:
  Cubes(const TriMesh& mesh, const Box3& bounds, double edge, double reach)
      : mesh_(mesh),
        reach_(toFloat(reach)),
        low_(toFloat(bounds.min)),
        only_(std::make_unique_for_overwrite<std::uint32_t[]>(mesh.triangles.size())) {
    const Vec3 span = bounds.max - bounds.min;
    const double most = kMostCubes * static_cast<double>(mesh.triangles.size());
    double size = std::max({kCubeEdges * edge, kCubeReaches * reach, kLeastCube});
    const auto count = [&] { return ((span / size).array().floor() + 1.0).prod(); };
    while (count() > most) size *= 1.3;
    each_ = toFloat(1.0 / size);
    for (int k = 0; k < 3; ++k) count_[k] = static_cast<int>(span[k] / size) + 1;
    facing_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], kAll);
  }

  /// Enters triangles first..last-1.
  void enter(std::size_t first, std::size_t last) {
    Pending pending;
    for (std::size_t t = first; t < last; ++t) {
      const auto& v = mesh_.triangles[t];
      const std::uint32_t facing =
          facingOf(mesh_.positions[v[0]], mesh_.positions[v[1]], mesh_.positions[v[2]]);
      std::uint32_t cubes = 0;
      forEachCube(t, reach_, [&](std::uint32_t& cube) {
        if (&cube != pending.cube) pending.moveTo(&cube);
        pending.facing &= facing;
        ++cubes;
        return true;
      });
      only_[t] = cubes == 1 ? static_cast<std::uint32_t>(pending.cube - facing_.data()) : kMany;
    }
    pending.moveTo(nullptr);
  }
  /// Requires that all are entered.
  bool isCrowded(std::size_t t) {
    if (only_[t] != kMany) return facing_[only_[t]] == 0;
    bool crowded = false;
    forEachCube(t, 0.0f, [&](const std::uint32_t& cube) { return !(crowded = cube == 0); });
    return crowded;
  }

 private:
  static constexpr std::uint32_t kAll = 0xFFFFFFFFu, kMany = 0xFFFFFFFFu;

  /// What goes into one cube, before it does: triangles that follow each other are mostly in the same.
  struct Pending {
    std::uint32_t* cube = nullptr;
    std::uint32_t facing = kAll;

    void moveTo(std::uint32_t* next) {
      if (cube != nullptr) {
        const std::atomic_ref all(*cube);
        if ((all.load(std::memory_order_relaxed) & ~facing) != 0)
          all.fetch_and(facing, std::memory_order_relaxed);
      }
      cube = next;
      facing = kAll;
    }
  };
  /// Calls body(cube) for those that the bounds of a triangle touch, until it returns false.
  template <typename Body>
  void forEachCube(std::size_t t, float reach, const Body& body) {
    const auto& v = mesh_.triangles[t];
    const auto &a = mesh_.positions[v[0]], &b = mesh_.positions[v[1]], &c = mesh_.positions[v[2]];
    const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c) - low_, high = a.cwiseMax(b).cwiseMax(c) - low_;
    Coords first, last;
    for (int k = 0; k < 3; ++k) {
      first[k] = std::clamp(static_cast<int>((low[k] - reach) * each_), 0, count_[k] - 1);
      last[k] = std::clamp(static_cast<int>((high[k] + reach) * each_), 0, count_[k] - 1);
    }
    for (int x = first[0]; x <= last[0]; ++x) {
      for (int y = first[1]; y <= last[1]; ++y) {
        std::uint32_t* const row = &facing_[(static_cast<std::size_t>(x) * count_[1] + y) * count_[2]];
        for (int z = first[2]; z <= last[2]; ++z) {
          if (!body(row[z])) return;
        }
      }
    }
  }

  const TriMesh& mesh_;
  const float reach_;
  const Eigen::Vector3f low_;
  float each_ = 0.0f;  ///< cubes for a mm
  Coords count_{};
  std::vector<std::uint32_t> facing_;
  std::unique_ptr<std::uint32_t[]> only_;  ///< by triangle: the one cube that it is entered in, or kMany
};

}  // namespace

std::vector<std::uint32_t> trianglesInCrowdedPlaces(const TriMesh& mesh, double moved_mm) {
  if (mesh.triangles.empty()) return {};
  // Two units in the last place of the coordinates are as good as moved.
  const Box3 bounds = meshBounds(mesh);
  const double far = std::max(bounds.min.cwiseAbs().maxCoeff(), bounds.max.cwiseAbs().maxCoeff());
  const double moved = moved_mm + 2.0 * std::numeric_limits<float>::epsilon() * far;
  Cubes cubes(mesh, bounds, meanEdge(mesh), kReach * moved);
  constexpr std::size_t kStretch = 2048;
  const std::size_t count = mesh.triangles.size();
  parallelFor(std::size_t{0}, (count + kStretch - 1) / kStretch,
              [&](std::size_t i) { cubes.enter(i * kStretch, std::min(count, (i + 1) * kStretch)); });
  std::vector<std::uint8_t> crowded(mesh.triangles.size());
  forEachBelow(crowded.size(), [&](std::size_t t) { crowded[t] = cubes.isCrowded(t) ? 1 : 0; });
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < crowded.size(); ++t) {
    if (crowded[t] != 0) out.push_back(t);
  }
  return out;
}

}  // namespace proveout
