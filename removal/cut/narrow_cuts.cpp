#include "removal/cut/narrow_cuts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/parallel_for.h"

namespace proveout {

namespace {

/// A dent that is shallower than this part of a cell is not spoken of.
constexpr double kDent = 0.05;
constexpr int kRim = 8;
constexpr std::size_t kPassesATime = 256;
constexpr double kMostPoints = 1e5;

double radiusAt(const ColumnSolid& solid, double height) {
  double low = 0.0, high = solid.radius;
  if (solid.lower.height(high) <= solid.z_min + height) return high;
  for (int i = 0; i < 50; ++i) {
    const double r = 0.5 * (low + high);
    (solid.lower.height(r) <= solid.z_min + height ? low : high) = r;
  }
  return low;
}

/// Every point has a column of the grid that close, mm.
double columnReach(double h) { return h / std::sqrt(2.0); }

/// A tool that covers the nearest column wherever it stands, and is a cell high, cannot pass between the
/// samples.
bool isNarrow(const ColumnSolid& solid, double h) {
  const double reach = columnReach(h);
  return solid.radius < reach || solid.z_max - solid.z_min < h ||
         solid.lower.height(reach) - solid.z_min > kDent * h;
}

class Search {
 public:
  Search(const Stock::Impl& impl, const Toolpath& path) : impl_(impl), path_(path), reader_(impl) {}

  /// Length of the pass whose cut is lost, mm; `first` and `width` of the first place.
  double follow(const Pass& pass, Vec3& first, double& width) const;

 private:
  const Crossing* crossingAt(int axis, const Coord& at) const;
  double heightAbove(const Coord& at) const;
  bool isMadeBy(int tool, int axis, const Coord& at) const;
  bool inMaterial(const Vec3& p) const;
  bool isLost(const Vec3& p, const Vec2& forward, double rise, int tool) const;
  double depthBelowTop(const Vec3& p, double most) const;
  ToolPlace placeOn(const Motion& motion, double t, double step) const;
  bool isLostAt(const Pass& pass, const ToolPlace& place, Vec3& where) const;

  const Stock::Impl& impl_;
  const Toolpath& path_;
  LeafReader reader_;
};

Coord cellOf(const Stock::Impl& impl, const Vec3& p) {
  const Vec3 q = (p - impl.origin) / impl.h;
  return {static_cast<int>(std::floor(q.x())), static_cast<int>(std::floor(q.y())),
          static_cast<int>(std::floor(q.z()))};
}

/// On the edge from the sample along the axis; null where it is not crossed.
const Crossing* Search::crossingAt(int axis, const Coord& at) const {
  Coord next = at;
  ++next[axis];
  if (reader_.isMaterial(at) == reader_.isMaterial(next)) return nullptr;
  const StockLeaf* leaf = reader_.leaf(at & ~7);
  if (leaf == nullptr) return nullptr;
  const LeafEdges edges = reader_.edges(*leaf);
  return &leaf->crossings[static_cast<std::size_t>(edges.indexOf(axis, at.x() & 7, at.y() & 7, at.z() & 7))];
}

/// Height of the crossing on the edge from the sample upwards; of the sample where there is none.
double Search::heightAbove(const Coord& at) const {
  const Crossing* crossing = crossingAt(2, at);
  return impl_.position(at).z() + (crossing != nullptr ? impl_.h * crossing->t : 0.0);
}

/// Whether the cell around `p` is material, whole or below a surface that lies above `p`.
bool Search::inMaterial(const Vec3& p) const {
  const Coord cell = cellOf(impl_, p);
  int above = 0;
  for (int i = 0; i < 8; ++i) {
    const bool in = reader_.isMaterial(cell.offsetBy(i & 1, i >> 1 & 1, i >> 2));
    if (i < 4 && !in) return false;
    if (i >= 4) above += in;
  }
  if (above == 4) return true;
  if (above != 0) return false;
  int higher = 0;  // the column next to the tool may show a dent
  for (int i = 0; i < 4; ++i) {
    higher += heightAbove(cell.offsetBy(i & 1, i >> 1, 0)) >= p.z() + kDent * impl_.h;
  }
  return higher >= 2;
}

/// The mesh shows a cut whose flank it meets on either side of the path, or that took a sample: then level
/// edges are crossed. `p`: where the tool stood. `rise`: how far its boundary climbs until it is over a
/// column of the grid, mm.
bool Search::isLost(const Vec3& p, const Vec2& forward, double rise, int tool) const {
  if (!inMaterial(p)) return false;
  const Coord cell = cellOf(impl_, p);
  const int above = 2 + static_cast<int>(rise / impl_.h);
  bool left = false, right = false;
  for (int i = 0; i < 4; ++i) {
    for (int z = -1; z <= above; ++z) {
      const Coord at = cell.offsetBy(i & 1, i >> 1, z);
      for (int axis = 0; axis < 2; ++axis) {
        if ((axis == 0 ? i & 1 : i >> 1) == 0 && isMadeBy(tool, axis, at)) return false;
      }
      if (!isMadeBy(tool, 2, at)) continue;
      const Vec3 q = impl_.position(at) - p;
      (forward.x() * q.y() - forward.y() * q.x() > 0.0 ? left : right) = true;
      if (left && right) return false;
    }
  }
  return true;
}

/// Whether the edge from the sample is crossed by a surface that the tool made.
bool Search::isMadeBy(int tool, int axis, const Coord& at) const {
  const Crossing* crossing = crossingAt(axis, at);
  return crossing != nullptr && crossing->motion < path_.motions.size() &&
         path_.motions[crossing->motion].tool == tool;
}

/// How deep `p`, in held material, lies below the first surface above it; not more than `most`, mm.
double Search::depthBelowTop(const Vec3& p, double most) const {
  Coord at = cellOf(impl_, p);
  const double last = p.z() + most;
  while (impl_.position(at).z() < last && reader_.isMaterial(at.offsetBy(0, 0, 1))) ++at[2];
  return std::clamp(heightAbove(at) - p.z(), 0.0, most);
}

bool Search::isLostAt(const Pass& pass, const ToolPlace& place, Vec3& where) const {
  const ColumnSolid& solid = *pass.body.uprightSolid();
  const double height = solid.z_max - solid.z_min, reach = std::min(solid.radius, columnReach(impl_.h));
  const double rise = solid.lower.height(reach) - solid.z_min;
  const int tool = path_.motions[pass.motion].tool;
  where = place.at + Vec3(0, 0, solid.z_min + std::min(kDent * impl_.h, 0.5 * height));
  if (isLost(where, place.forward, rise, tool)) return true;
  if (height >= impl_.h) return false;
  // A disc cuts with its rim, the axis may be outside.
  const double radius = 0.9 * solid.radius;
  const double z = 0.5 * (solid.lower.height(radius) - solid.upper.height(radius));
  for (int i = 0; i < kRim; ++i) {
    const double angle = 2.0 * kPi * i / kRim, c = radius * std::cos(angle), s = radius * std::sin(angle);
    const Vec2 f = place.forward;
    where = place.at + Vec3(c * f.x() - s * f.y(), c * f.y() + s * f.x(), z);
    if (isLost(where, place.forward, 0.0, tool)) return true;
  }
  return false;
}

/// On the motion's own way; `step`: part of it that tells the direction.
ToolPlace Search::placeOn(const Motion& motion, double t, double step) const {
  const Vec2 way = (path_.pointAt(motion, t + step) - path_.pointAt(motion, t - step)).head<2>();
  const double level = way.norm();
  return {path_.pointAt(motion, t), level > 0.0 ? Vec2(way / level) : Vec2::UnitX()};
}

double Search::follow(const Pass& pass, Vec3& first, double& width) const {
  const Motion& motion = path_.motions[pass.motion];
  const std::optional<double> own = pass.body.ownLength();
  const double length = own ? *own : path_.length(motion);
  const int count = static_cast<int>(std::clamp(std::ceil(length / impl_.h), 1.0, kMostPoints));
  int lost = 0;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    const ToolPlace place = own ? pass.body.placeAt(t) : placeOn(motion, t, 0.25 / count);
    Vec3 where;
    if (!isLostAt(pass, place, where)) continue;
    if (lost++ > 0) continue;
    const ColumnSolid& solid = *pass.body.uprightSolid();
    const double height = solid.z_max - solid.z_min;
    first = where;
    width = height;
    if (height >= impl_.h) width = std::min(width, 2.0 * radiusAt(solid, depthBelowTop(where, height)));
  }
  return length * lost / count;
}

}  // namespace

std::vector<NarrowCut> findNarrowCuts(const Stock::Impl& impl, const PassTable& table, const Toolpath& path) {
  std::map<const ColumnSolid*, bool> narrow;
  std::vector<std::uint32_t> passes;
  for (std::uint32_t i = 0; i < table.passes.size(); ++i) {
    const Pass& pass = table.passes[i];
    const ColumnSolid* const solid = pass.body.uprightSolid();
    if (!pass.cuts() || solid == nullptr) continue;
    if (!pass.body.ownLength() && table.goesOn(i)) continue;  // followed from its first piece on
    const auto [known, added] = narrow.try_emplace(solid);
    if (added) known->second = isNarrow(*solid, impl.h);
    if (known->second) passes.push_back(i);
  }
  struct Found {
    double length = 0.0, width = 0.0;
    Vec3 where;
  };
  std::vector<Found> found(passes.size());
  parallelFor(std::size_t{0}, (passes.size() + kPassesATime - 1) / kPassesATime, [&](std::size_t part) {
    const Search search(impl, path);
    const std::size_t last = std::min(passes.size(), (part + 1) * kPassesATime);
    for (std::size_t i = part * kPassesATime; i < last; ++i) {
      found[i].length = search.follow(table.passes[passes[i]], found[i].where, found[i].width);
    }
  });
  std::map<int, NarrowCut> of_tool;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (found[i].length <= 0.0 && found[i].width <= 0.0) continue;
    const MotionId motion = table.passes[passes[i]].motion;
    NarrowCut& cut = of_tool[path.motions[motion].tool];
    if (cut.motion == kNoMotion) cut = {motion, found[i].where, found[i].width, 0.0, 0.0};
    cut.length_mm += found[i].length;
    cut.area_mm2 += found[i].length * found[i].width;
    cut.width_mm = std::min(cut.width_mm, found[i].width);
  }
  std::vector<NarrowCut> out;
  for (const auto& [tool, cut] : of_tool) out.push_back(cut);
  return out;
}

}  // namespace proveout
