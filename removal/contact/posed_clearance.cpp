#include "removal/contact/posed_clearance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// Nearer than this is a touch, mm.
constexpr double kTouchMm = 1e-3;
/// Cells of the tool are not halved below this (half of their diagonal), mm.
constexpr double kLeastCellMm = 0.1;
/// Steps of one cell along a motion; more are taken for a touch.
constexpr int kMostSteps = 2000;

/// A box around a piece of the tool, in its frame.
struct Cell {
  Vec3 center, half;
};

/// How the tool's frame goes along the motion. A tool of revolution may turn about its own axis as it likes:
/// it is taken along the shortest way.
class PosedWay {
 public:
  PosedWay(const Toolpath& path, const Motion& motion, const AxisSweep& axis)
      : path_(path),
        motion_(motion),
        start_(Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis.from)),
        angle_(Eigen::Quaterniond::FromTwoVectors(axis.from, axis.to)),
        length_(path.length(motion)) {}

  Vec3 at(double share, const Vec3& p) const {
    const Eigen::AngleAxisd turned(share * angle_.angle(), angle_.axis());
    return path_.pointAt(motion_, share) + turned * (start_ * p);
  }
  /// Most that a point moves over the whole motion, mm. Arcs are passed at a constant rate, spirals not
  /// quite.
  double speed(const Vec3& p) const { return kUneven * length_ + angle_.angle() * p.norm(); }

 private:
  static constexpr double kUneven = 1.05;
  const Toolpath& path_;
  const Motion& motion_;
  Eigen::Quaterniond start_;
  Eigen::AngleAxisd angle_;
  double length_;
};

class Search {
 public:
  Search(const PosedWay& way, const ConvexProfile& part, std::span<const BlankField* const> bodies)
      : way_(way), part_(part), bodies_(bodies) {}

  std::optional<UnclearPlace> run() const {
    const double r = part_.maxRadius(), low = part_.zMin(), high = part_.zMax();
    return look({{0.0, 0.0, 0.5 * (low + high)}, {r, r, 0.5 * (high - low)}}, 0.0);
  }

 private:
  double distance(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const BlankField* body : bodies_) least = std::min(least, body->value(p));
    return least;
  }

  /// Whether the part comes into the ball around the cell.
  bool holdsTool(const Cell& cell) const {
    return part_.sample(cell.center.head<2>().norm(), cell.center.z()).value <= cell.half.norm();
  }

  /// The cell is clear up to `from`.
  std::optional<UnclearPlace> look(const Cell& cell, double from) const {
    const double radius = cell.half.norm(), speed = way_.speed(cell.center);
    double share = from;
    for (int step = 0; step < kMostSteps; ++step) {
      const Vec3 p = way_.at(share, cell.center);
      const double clear = distance(p) - radius;
      if (clear <= kTouchMm) {
        if (radius <= kLeastCellMm) return UnclearPlace{share, p};
        return halve(cell, share);
      }
      if (share >= 1.0 || speed <= 0.0) return std::nullopt;
      share = std::min(1.0, share + clear / speed);
    }
    return UnclearPlace{share, way_.at(share, cell.center)};
  }

  std::optional<UnclearPlace> halve(const Cell& cell, double from) const {
    // Long sides are halved first, so that pieces become round.
    const double longest = cell.half.maxCoeff();
    std::optional<UnclearPlace> first;
    for (int k = 0; k < 8; ++k) {
      Cell piece = cell;
      bool twice = false;
      for (int axis = 0; axis < 3; ++axis) {
        const bool upper = (k >> axis & 1) != 0;
        if (cell.half[axis] < 0.5 * longest) {
          twice = twice || upper;
          continue;
        }
        piece.half[axis] = 0.5 * cell.half[axis];
        piece.center[axis] += upper ? piece.half[axis] : -piece.half[axis];
      }
      if (twice || !holdsTool(piece)) continue;
      const std::optional<UnclearPlace> found = look(piece, from);
      if (found && (!first || found->share < first->share)) first = found;
      if (first && first->share <= from) return first;
    }
    return first;
  }

  const PosedWay& way_;
  const ConvexProfile& part_;
  std::span<const BlankField* const> bodies_;
};

}  // namespace

std::optional<UnclearPlace> firstUnclear(const Toolpath& path, const Motion& motion, const AxisSweep& axis,
                                         const ToolSolid& tool, std::span<const BlankField* const> bodies) {
  const PosedWay way(path, motion, axis);
  std::optional<UnclearPlace> first;
  for (const auto* parts : {&tool.cutter, &tool.shank, &tool.holder}) {
    for (const ConvexProfile& part : *parts) {
      const std::optional<UnclearPlace> found = Search(way, part, bodies).run();
      if (found && (!first || found->share < first->share)) first = found;
    }
  }
  return first;
}

}  // namespace proveout
