#include "app/page/crest_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/path/toolpath.h"
#include "removal/compare/fit/point_cells.h"

namespace proveout {
std::vector<float> crestHeights(const TriMesh& mesh, const std::vector<CrestSample>& crests) {
  std::vector<float> out(mesh.triangles.size(), std::numeric_limits<float>::quiet_NaN());
  if (crests.empty()) return out;
  Box3 bounds;
  std::vector<Vec3> places;
  double widest = 0.0;
  for (const CrestSample& crest : crests) {
    bounds.extend(crest.where);
    places.push_back(crest.where);
    widest = std::max(widest, crest.width_mm);
  }
  // As on a flat surface of the size of their bounds.
  const Vec3 size = bounds.size();
  const double area = std::max({size.x() * size.y(), size.y() * size.z(), size.z() * size.x()});
  const double apart = std::sqrt(area / static_cast<double>(crests.size()));
  const double reach = std::max({2.0 * widest, 1.5 * apart, 1e-3});
  const PointCells cells(std::move(places), reach);
  for (std::size_t t = 0; t < out.size(); ++t) {
    if (!mesh.motion.empty() && mesh.motion[t] == kNoMotion) continue;
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t v : mesh.triangles[t]) middle += mesh.positions[v].cast<double>() / 3.0;
    cells.forEachNear(middle, reach, [&](std::uint32_t k, double) {
      // Joints along a pass are crests as well, low ones.
      const auto height = static_cast<float>(crests[k].height_mm);
      if (!(out[t] >= height)) out[t] = height;
    });
  }
  return out;
}

}  // namespace proveout
