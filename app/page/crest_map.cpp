#include "app/page/crest_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/path/toolpath.h"

namespace proveout {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cellOf(const Vec3& p, double size) {
  return {static_cast<std::int64_t>(std::floor(p.x() / size)),
          static_cast<std::int64_t>(std::floor(p.y() / size)),
          static_cast<std::int64_t>(std::floor(p.z() / size))};
}

}  // namespace

std::vector<float> crestHeights(const TriMesh& mesh, const std::vector<CrestSample>& crests) {
  std::vector<float> out(mesh.triangles.size(), std::numeric_limits<float>::quiet_NaN());
  if (crests.empty()) return out;
  Box3 bounds;
  double widest = 0.0;
  for (const CrestSample& crest : crests) {
    bounds.extend(crest.where);
    widest = std::max(widest, crest.width_mm);
  }
  // As on a flat surface of the size of their bounds.
  const Vec3 size = bounds.size();
  const double area = std::max({size.x() * size.y(), size.y() * size.z(), size.z() * size.x()});
  const double apart = std::sqrt(area / static_cast<double>(crests.size()));
  const double reach = std::max({2.0 * widest, 1.5 * apart, 1e-3});
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t k = 0; k < crests.size(); ++k) cells[cellOf(crests[k].where, reach)].push_back(k);
  for (std::size_t t = 0; t < out.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t v : mesh.triangles[t]) middle += mesh.positions[v].cast<double>() / 3.0;
    if (!mesh.motion.empty() && mesh.motion[t] == kNoMotion) continue;
    const Cell at = cellOf(middle, reach);
    for (int i = 0; i < 27; ++i) {
      const auto near = cells.find({at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1});
      if (near == cells.end()) continue;
      for (const std::size_t k : near->second) {
        if ((crests[k].where - middle).squaredNorm() > reach * reach) continue;
        // Joints along a pass are crests as well, low ones.
        const auto height = static_cast<float>(crests[k].height_mm);
        if (!(out[t] >= height)) out[t] = height;
      }
    }
  }
  return out;
}

}  // namespace proveout
