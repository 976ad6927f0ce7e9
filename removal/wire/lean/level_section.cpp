#include "removal/wire/lean/level_section.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "removal/wire/lean/lean_outline.h"
#include "removal/wire/lean/thin_places.h"
#include "removal/wire/section/edge_curves.h"
#include "removal/wire/section/kerf_outline.h"
#include "removal/wire/section/kerf_union.h"
#include "removal/wire/section/stretch_index.h"

namespace proveout {
namespace {

using namespace wire_detail;

/// An edge deviates from its curve by its chord height and by rounding; the search reaches somewhat farther,
/// mm.
constexpr double kNameReach = 3e-4;
/// Largest deviation of the blank's chords from its arcs, mm.
constexpr double kBlankChord = 2e-5;
/// Distances that differ by less count as equal, mm: the wire went the same way twice.
constexpr double kOneDistance = 1e-8;
/// Straight edges with the same name are joined where their common corner is nearer to the line than this,
/// mm.
constexpr double kOnLine = 2e-6;
/// Edges that are named by one task.
constexpr std::size_t kNamesATask = 512;

/// Names: the number of the stretch, and which part of it.
constexpr int kPartBits = 2;
constexpr WallName kLeft = 0, kRight = 1, kEnd = 2;
constexpr WallName kBlankName = WallName{1} << 63;

struct Named {
  WallName name = 0;
  MotionId motion = kNoMotion;
  double off_mm = 0.0;  ///< from the curve
};

/// Finds the stretch whose kerf's border a point lies on.
class KerfNames {
 public:
  explicit KerfNames(const std::vector<LevelStretch>& stretches) : stretches_(stretches) {
    std::vector<Box3> boxes;
    boxes.reserve(stretches.size());
    for (const LevelStretch& s : stretches) {
      Box3 box;
      for (const Vec2& p : {s.from, s.to}) box.extend(Vec3(p.x(), p.y(), 0.0));
      boxes.push_back(box.inflated(s.reach()));
    }
    tree_ = BoxTree(boxes);
  }

  std::optional<Named> at(const Vec2& p, double reach) const {
    const Box3 box = Box3{Vec3(p.x(), p.y(), 0.0), Vec3(p.x(), p.y(), 0.0)}.inflated(reach);
    std::uint32_t best = kNone;
    Place place;
    double least = reach;
    tree_.forEachPlace(box, [&](std::uint32_t k) {
      const std::uint32_t i = tree_.order()[k];
      const Place here = placeOf(stretches_[i], p);
      const double gain = least - here.off;
      if (gain < -kOneDistance || (gain <= kOneDistance && i >= best)) return;
      best = i;
      place = here;
      least = std::min(least, here.off);
    });
    if (best == kNone) return std::nullopt;
    return Named{nameOf(best, place), stretches_[best].motion, std::abs(place.off)};
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  struct Place {
    double off = 0.0;  ///< from the border, inside below 0
    double share = 0.0;
    bool left = false;
  };

  /// By the distance to the middle line of the wire in space.
  static Place placeOf(const LevelStretch& s, const Vec2& p) {
    const Vec2 lean = 0.5 * (s.lean_from + s.lean_to);
    const double less = 1.0 / (1.0 + lean.squaredNorm());
    const auto product = [&](const Vec2& a, const Vec2& b) {
      return a.dot(b) - less * a.dot(lean) * b.dot(lean);
    };
    const Vec2 way = s.to - s.from, d = p - s.from;
    const double length2 = product(way, way);
    const double share = length2 > 0.0 ? std::clamp(product(d, way) / length2, 0.0, 1.0) : 0.0;
    const Vec2 off = d - share * way;
    return {std::sqrt(std::max(0.0, product(off, off))) - s.radius_mm, share, cross2(way, d) > 0.0};
  }

  /// Ends are numbered by the stretch that begins there: the end of one is the start of the next.
  static WallName nameOf(std::uint32_t i, const Place& place) {
    if (place.share == 0.0 || place.share == 1.0)
      return ((WallName{i} + (place.share == 1.0 ? 1 : 0)) << kPartBits) | kEnd;
    return (WallName{i} << kPartBits) | (place.left ? kLeft : kRight);
  }

  const std::vector<LevelStretch>& stretches_;
  BoxTree tree_;
};

class WallNamer {
 public:
  WallNamer(const std::vector<PlaneLoop>& blank, const std::vector<LevelStretch>& stretches)
      : kerf_(stretches), sides_(sidesOf(blank)), blank_(sides_) {}

  Named of(const Vec2& middle) const {
    for (double reach = kNameReach;; reach *= 16.0) {
      const std::optional<Named> old = ofBlank(middle, reach), cut = kerf_.at(middle, reach);
      if (old && (!cut || old->off_mm <= cut->off_mm)) return *old;
      if (cut) return *cut;
      PROVEOUT_ASSERT(reach < 1e9);
    }
  }

 private:
  std::optional<Named> ofBlank(const Vec2& p, double reach) const {
    const StretchIndex::Found found = blank_.nearest(p, reach);
    if (found.stretch == StretchIndex::kNone) return std::nullopt;
    return Named{kBlankName | found.stretch, sides_[found.stretch].motion, found.off_mm};
  }

  KerfNames kerf_;
  std::vector<WireStretch> sides_;
  StretchIndex blank_;
};

/// Leaves out points inside straight runs of one name.
class RunJoiner {
 public:
  explicit RunJoiner(const std::vector<bool>& straight) : straight_(straight) {}

  LevelLoop join(const LevelLoop& in) const {
    const std::size_t n = in.points.size();
    PROVEOUT_ASSERT(in.names.size() == n && in.motions.size() == n && straight_.size() == n);
    std::size_t start = 0;
    while (start < n && in.names[start] == in.names[(start + n - 1) % n]) ++start;
    if (start == n) start = 0;
    LevelLoop out;
    for (std::size_t k = 0; k < n; ++k) add(in, (start + k) % n, out);
    return out;
  }

 private:
  void add(const LevelLoop& in, std::size_t i, LevelLoop& out) const {
    const Vec2& p = in.points[i];
    if (!out.points.empty() && out.names.back() == in.names[i] && straight_[i] &&
        distanceToSegment(p, out.points.back(), in.points[(i + 1) % in.points.size()]) <= kOnLine)
      return;
    out.points.push_back(p);
    out.names.push_back(in.names[i]);
    out.motions.push_back(in.motions[i]);
  }

  const std::vector<bool>& straight_;  ///< by edge
};

LevelLoop asMeshHolds(const LevelLoop& in) {
  LevelLoop out;
  for (const auto& [point, edge] : meshCorners(in.points)) {
    out.points.push_back(in.points[point]);
    out.names.push_back(in.names[edge]);
    out.motions.push_back(in.motions[edge]);
  }
  return out;
}

LevelLoop loopOf(const ClipperLib::Path& path, const WallNamer& namer) {
  const std::size_t n = path.size(), tasks = (n + kNamesATask - 1) / kNamesATask;
  LevelLoop loop;
  for (const ClipperLib::IntPoint& p : path) loop.points.push_back(toMm(p));
  std::vector<Named> named(n);
  parallelFor(std::size_t{0}, tasks, [&](std::size_t task) {
    for (std::size_t i = task * kNamesATask; i < std::min(n, (task + 1) * kNamesATask); ++i)
      named[i] = namer.of(0.5 * (loop.points[i] + loop.points[(i + 1) % n]));
  });
  std::vector<bool> straight(n);
  for (std::size_t i = 0; i < n; ++i) {
    loop.names.push_back(named[i].name);
    loop.motions.push_back(named[i].motion);
    straight[i] = isSide(named[i].name);
  }
  return asMeshHolds(RunJoiner(straight).join(loop));
}

LevelSection sectionOf(const std::vector<PathRegion>& regions, const WallNamer& namer, double z) {
  LevelSection section;
  section.z = z;
  for (const PathRegion& paths : regions) {
    LevelRegion region;
    for (const ClipperLib::Path& path : paths) {
      LevelLoop loop = loopOf(path, namer);
      const bool flat = loop.points.size() < 3;
      if (flat && region.loops.empty()) break;
      if (flat) continue;
      region.loops.push_back(static_cast<std::uint32_t>(section.loops.size()));
      section.loops.push_back(std::move(loop));
    }
    if (!region.loops.empty()) section.regions.push_back(std::move(region));
  }
  return section;
}

}  // namespace

bool isSide(WallName name) { return (name & kBlankName) != 0 || (name & 3) != kEnd; }

double areaOf(const LevelLoop& loop) { return polygonArea(loop.points); }

LevelSection levelSection(const std::vector<PlaneLoop>& blank, const std::vector<LevelStretch>& stretches,
                          double z, ThinPlaces thin) {
  const WallNamer namer(blank, stretches);
  const std::vector<PathRegion> left = regionsLeft(pathsOf(blank, kBlankChord), leanKerf(stretches));
  LevelSection section = sectionOf(left, namer, z);
  if (thin == ThinPlaces::kStay) return section;
  const double width = leastWidth(section.loops);
  if (!hasThinPlaces(section.loops, width)) return section;
  return sectionOf(withoutThinPlaces(left, width + kUnit), namer, z);
}

}  // namespace proveout
