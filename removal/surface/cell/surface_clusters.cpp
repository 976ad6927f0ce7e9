#include "removal/surface/cell/surface_clusters.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/geometry/to_float.h"
#include "removal/surface/cell/surface_grid.h"

namespace proveout {

namespace {

/// Normals of a merged patch are within 12 degrees of their mean.
constexpr float kConeCos = 0.978f;
/// Cells of one plane: heights (grid steps) and normals agree to this. Normals are stored to 3e-5.
constexpr float kSamePlane = 2e-4f;

bool occupied(const LeafBits& cells, const CellCube& cube) {
  std::uint64_t any = 0;
  for (int z = cube.z0; z < cube.z0 + cube.size; ++z) any |= cells[z];
  return (any & cube.columns) != 0;
}

/// Cells less connections plus crossed edges inside the cube: 1 for a disk (and, connected, for nothing
/// else).
int eulerNumber(const SurfaceLeaf& leaf, const LeafPatch& patch, const CellCube& cube) {
  const std::uint64_t c = cube.columns;
  const std::uint64_t high_x = c & c << 8, high_y = c & c << 1 & ~kColumnY0;  // not in the lowest row
  const std::uint64_t low_x = c & c >> 8, low_y = c & (c & ~kColumnY0) >> 1;  // not in the highest row
  int number = 0;
  for (int z = cube.z0; z < cube.z0 + cube.size; ++z) {
    number += countBits(leaf.mixed[z] & c);
    number -= countBits(patch.faces[0][z] & low_x) + countBits(patch.faces[1][z] & low_y);
    number += countBits(leaf.edges.crossed[2][z] & high_x & high_y);
    if (z > cube.z0) {
      number += countBits(leaf.edges.crossed[0][z] & high_y) + countBits(leaf.edges.crossed[1][z] & high_x);
      number -= countBits(patch.faces[2][z - 1] & c);
    }
  }
  return number;
}

/// Whether every cell of the cube can be reached from every other through crossed faces.
bool connected(const SurfaceLeaf& leaf, const LeafPatch& patch, const CellCube& cube) {
  LeafBits reached{};
  const int end = cube.z0 + cube.size;
  for (int z = cube.z0; z < end; ++z) {
    const std::uint64_t cells = leaf.mixed[z] & cube.columns;
    if (cells == 0) continue;
    reached[z] = cells & (~cells + 1);
    break;
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (int z = cube.z0; z < end; ++z) {
      const std::uint64_t x = patch.faces[0][z], y = patch.faces[1][z] & ~(kColumnY0 << 7);
      std::uint64_t r = reached[z];
      r |= (r & x) << 8 | (r >> 8 & x) | (r & y) << 1 | (r >> 1 & y);
      if (z > cube.z0) r |= reached[z - 1] & patch.faces[2][z - 1];
      if (z + 1 < end) r |= reached[z + 1] & patch.faces[2][z];
      r &= cube.columns;
      grown = grown || r != reached[z];
      reached[z] = r;
    }
  }
  for (int z = cube.z0; z < end; ++z) {
    if (reached[z] != (leaf.mixed[z] & cube.columns)) return false;
  }
  return true;
}

bool isFlatDisk(const SurfaceLeaf& leaf, const LeafPatch& patch, const CellCube& cube, float flatness) {
  std::array<std::uint16_t, 512> ranks;
  int count = 0;
  Eigen::Vector3f n = Eigen::Vector3f::Zero(), middle = n;
  for (int z = cube.z0; z < cube.z0 + cube.size; ++z) {
    const std::uint64_t cells = leaf.mixed[z] & cube.columns;
    if ((cells & ~patch.gentle[z]) != 0) return false;
    for (std::uint64_t rest = cells; rest != 0; rest &= rest - 1) {
      const std::uint64_t below = (rest & (~rest + 1)) - 1;
      ranks[count] = static_cast<std::uint16_t>(leaf.first_cell[z] + countBits(leaf.mixed[z] & below));
      n += patch.n[ranks[count]];
      middle += patch.p[ranks[count++]];
    }
  }
  if (count == 1) return true;
  n.normalize();
  middle /= toFloat(count);
  const std::uint16_t stand_in = *std::min_element(ranks.begin(), ranks.begin() + count, [&](int a, int b) {
    return (patch.p[a] - middle).squaredNorm() < (patch.p[b] - middle).squaredNorm();
  });
  float low = 1e9f, high = -1e9f, bow2 = 0.0f;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f &p = patch.p[ranks[i]], &normal = patch.n[ranks[i]];
    if (n.dot(normal) < kConeCos) return false;
    const float h = n.dot(p);
    low = std::min(low, h);
    high = std::max(high, h);
    bow2 = std::max(bow2, (p - patch.p[stand_in]).squaredNorm() * (normal - patch.n[stand_in]).squaredNorm());
  }
  return high - low <= flatness && bow2 <= 4.0f * flatness * flatness &&
         eulerNumber(leaf, patch, cube) == 1 && connected(leaf, patch, cube);
}

/// Whether all cells of the leaf lie on one plane, as exactly as normals are stored. Then every cube of it
/// holds a convex piece of the plane: a disk.
bool isPlane(const SurfaceLeaf& leaf, const LeafPatch& patch) {
  if (leaf.cells == 0 || leaf.mixed != patch.gentle) return false;
  const Eigen::Vector3f &p = patch.p[0], &n = patch.n[0];
  for (int i = 1; i < leaf.cells; ++i) {
    if ((patch.n[i] - n).squaredNorm() > kSamePlane * kSamePlane ||
        std::abs(n.dot(patch.p[i] - p)) > kSamePlane) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool mergesPlanes(float flatness) { return flatness >= kSamePlane; }

LeafClusters planeClusters(const Eigen::Vector3f& normal) {
  LeafClusters out;
  out.two = ~0ull;
  out.four = 0xFF;
  out.eight = true;
  out.normal = normal;
  return out;
}

LeafClusters findClusters(const SurfaceLeaf& leaf, const LeafPatch& patch, float flatness) {
  if (mergesPlanes(flatness) && isPlane(leaf, patch)) return planeClusters(patch.n[0]);
  LeafClusters out;
  bool all = true;
  for (int four = 0; four < 8; ++four) {
    const int z4 = (four >> 2) * 4, x4 = (four >> 1 & 1) * 4, y4 = (four & 1) * 4;
    const CellCube cube4 = cubeAt(4, x4, y4, z4);
    if (!occupied(leaf.mixed, cube4)) continue;
    bool whole = true;
    for (int two = 0; two < 8; ++two) {
      const int z = z4 + (two >> 2) * 2, x = x4 + (two >> 1 & 1) * 2, y = y4 + (two & 1) * 2;
      const CellCube cube = cubeAt(2, x, y, z);
      if (!occupied(leaf.mixed, cube)) continue;
      if (isFlatDisk(leaf, patch, cube, flatness)) {
        out.two |= 1ull << (z / 2 * 16 + x / 2 * 4 + y / 2);
      } else {
        whole = false;
      }
    }
    if (whole && isFlatDisk(leaf, patch, cube4, flatness)) {
      out.four |= static_cast<std::uint8_t>(1 << four);
    } else {
      all = false;
    }
  }
  out.eight = all && leaf.cells > 0 && isFlatDisk(leaf, patch, CellCube{}, flatness);
  if (out.eight) {
    out.normal.setZero();
    for (int i = 0; i < leaf.cells; ++i) out.normal += patch.n[i];
    out.normal.normalize();
  }
  return out;
}

}  // namespace proveout
