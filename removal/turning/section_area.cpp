#include "removal/turning/section_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "removal/turning/section_loops.h"

namespace proveout {

namespace {

using section_detail::cInt;
using section_detail::clean;
using section_detail::distance2;
using section_detail::IntPoint;
using section_detail::kNear;
using section_detail::Loop;
using section_detail::WindowCut;

constexpr double kUnit = 1e-6;  ///< mm: a nanometre
/// Areas with fewer points are clipped whole.
constexpr std::size_t kFewPoints = 150;
constexpr double kThinPiece = 1e-4;  ///< mm

cInt toUnits(double mm) { return static_cast<cInt>(std::llround(mm / kUnit)); }
IntPoint toUnits(const Vec2& p) { return {toUnits(p.x()), toUnits(p.y())}; }
Vec2 toMm(const IntPoint& p) { return {kUnit * static_cast<double>(p.X), kUnit * static_cast<double>(p.Y)}; }

struct Edge {
  IntPoint a, b;
  bool operator==(const Edge& o) const { return a == o.a && b == o.b; }
};

struct EdgeHash {
  std::size_t operator()(const Edge& e) const {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;
    for (const cInt v : {e.a.X, e.a.Y, e.b.X, e.b.Y}) {
      h ^= static_cast<std::uint64_t>(v);
      h *= 0xFF51AFD7ED558CCDull;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
};

double volumeUnder(const ClipperLib::Path& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 a = toMm(p[i]), b = toMm(p[(i + 1) % p.size()]);
    sum += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
  }
  return kPi / 3.0 * sum;
}

double thickness(const ClipperLib::Path& p) {
  double around = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) around += (toMm(p[(i + 1) % p.size()]) - toMm(p[i])).norm();
  return around > 0.0 ? 2.0 * std::abs(ClipperLib::Area(p)) * kUnit * kUnit / around : 0.0;
}

ClipperLib::Paths toPaths(const std::vector<SectionPath>& polygons) {
  ClipperLib::Paths paths;
  paths.reserve(polygons.size());
  for (const SectionPath& polygon : polygons) {
    ClipperLib::Path path;
    path.reserve(polygon.size());
    for (const Vec2& p : polygon) {
      const IntPoint at = toUnits(p);
      if (path.empty() || !(path.back() == at)) path.push_back(at);
    }
    while (path.size() > 1 && path.front() == path.back()) path.pop_back();
    if (path.size() > 2) paths.push_back(std::move(path));
  }
  return paths;
}

ClipperLib::Paths toolPaths(const std::vector<SectionPath>& sweeps, const std::vector<SectionPath>& spared) {
  ClipperLib::Paths tool = toPaths(sweeps);
  const ClipperLib::Paths less = toPaths(spared);
  if (tool.empty() || less.empty()) return tool;
  ClipperLib::Clipper clipper;
  clipper.AddPaths(tool, ClipperLib::ptSubject, true);
  clipper.AddPaths(less, ClipperLib::ptClip, true);
  clipper.Execute(ClipperLib::ctDifference, tool, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return tool;
}

}  // namespace

double revolvedVolume(const std::vector<Vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
    sum += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
  }
  return kPi / 3.0 * sum;
}

namespace {

struct Bounds {
  IntPoint low{std::numeric_limits<cInt>::max(), std::numeric_limits<cInt>::max()};
  IntPoint high{std::numeric_limits<cInt>::min(), std::numeric_limits<cInt>::min()};
};

Bounds boundsOf(const ClipperLib::Paths& paths) {
  Bounds box;
  for (const auto& path : paths) {
    for (const IntPoint& p : path) {
      box.low = {std::min(box.low.X, p.X), std::min(box.low.Y, p.Y)};
      box.high = {std::max(box.high.X, p.X), std::max(box.high.Y, p.Y)};
    }
  }
  return box;
}

ClipperLib::Paths combined(const std::vector<Loop>& loops, const ClipperLib::Paths& tool,
                           ClipperLib::ClipType how) {
  ClipperLib::Clipper clipper(ClipperLib::ioPreserveCollinear);
  for (const Loop& loop : loops) clipper.AddPath(loop.points, ClipperLib::ptSubject, true);
  clipper.AddPaths(tool, ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  clipper.Execute(how, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return result;
}

double volumeOf(const ClipperLib::Paths& paths) {
  double volume = 0.0;
  for (const auto& path : paths) volume += volumeUnder(path);
  return volume;
}

}  // namespace

struct SectionArea::Impl {
  std::vector<Loop> loops;
  IntPoint low{0, 0}, high{0, 0};
  double volume = 0.0;

  void measure() {
    volume = 0.0;
    bool first = true;
    for (const Loop& loop : loops) {
      volume += volumeUnder(loop.points);
      for (const IntPoint& p : loop.points) {
        if (first) low = high = p;
        first = false;
        low = {std::min(low.X, p.X), std::min(low.Y, p.Y)};
        high = {std::max(high.X, p.X), std::max(high.Y, p.Y)};
      }
    }
  }

  std::size_t points() const {
    std::size_t count = 0;
    for (const Loop& loop : loops) count += loop.points.size();
    return count;
  }

  /// False where a box surely has nothing in common with the area.
  bool reaches(const Bounds& box) const {
    const IntPoint &l = box.low, &h = box.high;
    if (l.X >= high.X || l.Y >= high.Y || h.X <= low.X || h.Y <= low.Y) return false;
    for (const Loop& loop : loops) {
      const IntPoint* a = &loop.points.back();
      for (const IntPoint& b : loop.points) {
        const bool beside = std::min(a->X, b.X) >= h.X || std::max(a->X, b.X) <= l.X ||
                            std::min(a->Y, b.Y) >= h.Y || std::max(a->Y, b.Y) <= l.Y;
        if (!beside) return true;
        a = &b;
      }
    }
    // No edge comes near: all inside or all outside.
    int inside = 0;
    const IntPoint middle((l.X + h.X) / 2, (l.Y + h.Y) / 2);
    for (const Loop& loop : loops) inside += ClipperLib::PointInPolygon(middle, loop.points) != 0 ? 1 : 0;
    return inside % 2 == 1;
  }

  /// What rounding may take off all along the surface, mm3.
  double roundingVolume() const {
    const Vec2 size = toMm(high) - toMm(low);
    return 2.0 * kPi * toMm(high).x() * (size.x() + size.y()) * 5.0 * kUnit;
  }
};

namespace {

/// Finds the labels of the edges that a difference leaves.
class EdgeLabels {
 public:
  explicit EdgeLabels(const std::vector<Loop>& old) : old_(old) {
    std::size_t count = 0;
    for (const Loop& loop : old) count += loop.points.size();
    known_.reserve(count);
    for (const Loop& loop : old) {
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        known_[{loop.points[i], loop.points[(i + 1) % loop.points.size()]}] = loop.motion[i];
    }
  }

  /// What does not lie on an old edge was made by `motion`.
  MotionId of(const IntPoint& a, const IntPoint& b, MotionId motion) const {
    const auto found = known_.find({a, b});
    if (found != known_.end()) return found->second;
    const double x = 0.5 * static_cast<double>(a.X + b.X), y = 0.5 * static_cast<double>(a.Y + b.Y);
    const double dx = static_cast<double>(b.X - a.X), dy = static_cast<double>(b.Y - a.Y);
    for (const Loop& loop : old_) {
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const IntPoint &p = loop.points[i], &q = loop.points[(i + 1) % loop.points.size()];
        if (x < static_cast<double>(std::min(p.X, q.X)) - 2 ||
            x > static_cast<double>(std::max(p.X, q.X)) + 2 ||
            y < static_cast<double>(std::min(p.Y, q.Y)) - 2 ||
            y > static_cast<double>(std::max(p.Y, q.Y)) + 2)
          continue;
        const double ex = static_cast<double>(q.X - p.X), ey = static_cast<double>(q.Y - p.Y);
        // The same way round, and not just touched in a point.
        if (dx * ex + dy * ey <= 0.0) continue;
        if (distance2(x, y, p, q) <= kNear * kNear) return loop.motion[i];
      }
    }
    return motion;
  }

 private:
  const std::vector<Loop>& old_;
  std::unordered_map<Edge, MotionId, EdgeHash> known_;
};

}  // namespace

SectionArea::SectionArea() : impl_(std::make_unique<Impl>()) {}
SectionArea::~SectionArea() = default;
SectionArea::SectionArea(const SectionArea& o) : impl_(std::make_unique<Impl>(*o.impl_)) {}
SectionArea& SectionArea::operator=(const SectionArea& o) {
  *impl_ = *o.impl_;
  return *this;
}
SectionArea::SectionArea(SectionArea&&) noexcept = default;
SectionArea& SectionArea::operator=(SectionArea&&) noexcept = default;

SectionArea::SectionArea(const std::vector<SectionLoop>& loops) : SectionArea() {
  for (const SectionLoop& from : loops) {
    Loop loop;
    for (const Vec2& p : from.points) loop.points.push_back(toUnits(p));
    loop.motion = from.motion;
    clean(loop);
    if (loop.points.size() > 2) impl_->loops.push_back(std::move(loop));
  }
  impl_->measure();
}

bool SectionArea::empty() const { return impl_->loops.empty(); }
Vec2 SectionArea::min() const { return toMm(impl_->low); }
Vec2 SectionArea::max() const { return toMm(impl_->high); }
double SectionArea::volume() const { return impl_->volume; }

std::size_t SectionArea::points() const { return impl_->points(); }

namespace {

/// `loops` less the tool, with the labels of what stays and of what is new; or nothing where only rounding
/// would be taken.
struct Difference {
  std::vector<Loop> loops;
  double taken_mm3 = 0.0;
};

Difference difference(const std::vector<Loop>& loops, const ClipperLib::Paths& tool, MotionId motion,
                      double rounding_mm3) {
  Difference result;
  double before = 0.0;
  for (const Loop& loop : loops) before += volumeUnder(loop.points);
  ClipperLib::Paths left = combined(loops, tool, ClipperLib::ctDifference);
  result.taken_mm3 = before - volumeOf(left);
  if (result.taken_mm3 < rounding_mm3) {
    const ClipperLib::Paths both = combined(loops, tool, ClipperLib::ctIntersection);
    const auto thick = [](const auto& path) { return thickness(path) >= kThinPiece; };
    if (std::none_of(both.begin(), both.end(), thick)) result.taken_mm3 = 0.0;
  }
  if (result.taken_mm3 <= 0.0) return result;
  const EdgeLabels labels(loops);
  for (auto& path : left) {
    Loop loop;
    loop.motion.reserve(path.size());
    for (std::size_t i = 0; i < path.size(); ++i)
      loop.motion.push_back(labels.of(path[i], path[(i + 1) % path.size()], motion));
    loop.points = std::move(path);
    result.loops.push_back(std::move(loop));
  }
  return result;
}

void cleanAll(std::vector<Loop>& loops) {
  for (Loop& loop : loops) clean(loop);
  std::erase_if(loops, [](const Loop& loop) { return loop.points.size() < 3; });
}

}  // namespace

double SectionArea::subtract(const std::vector<SectionPath>& sweeps, MotionId motion,
                             const std::vector<SectionPath>& spared) {
  const ClipperLib::Paths tool = toolPaths(sweeps, spared);
  const Bounds box = boundsOf(tool);
  if (empty() || tool.empty() || !impl_->reaches(box)) return 0.0;
  const double rounding = impl_->roundingVolume();
  if (impl_->points() > kFewPoints) {
    const WindowCut window(impl_->loops, box.low, box.high);
    const Difference local = difference(window.inside(), tool, motion, rounding);
    if (local.taken_mm3 <= 0.0) return 0.0;
    std::vector<Loop> joined;
    if (window.join(local.loops, joined)) {
      impl_->loops = std::move(joined);
      impl_->measure();
      return local.taken_mm3;
    }
  }
  Difference whole = difference(impl_->loops, tool, motion, rounding);
  if (whole.taken_mm3 <= 0.0) return 0.0;
  cleanAll(whole.loops);
  impl_->loops = std::move(whole.loops);
  impl_->measure();
  return whole.taken_mm3;
}

std::vector<SectionPiece> SectionArea::common(const std::vector<SectionPath>& sweeps,
                                              const std::vector<SectionPath>& spared) const {
  std::vector<SectionPiece> pieces;
  const ClipperLib::Paths tool = toolPaths(sweeps, spared);
  const Bounds box = boundsOf(tool);
  if (empty() || tool.empty() || !impl_->reaches(box)) return pieces;
  const bool few = impl_->points() <= kFewPoints;
  const ClipperLib::Paths both =
      few ? combined(impl_->loops, tool, ClipperLib::ctIntersection)
          : combined(WindowCut(impl_->loops, box.low, box.high).inside(), tool, ClipperLib::ctIntersection);
  for (const auto& path : both) {
    if (!ClipperLib::Orientation(path)) continue;
    SectionPiece piece;
    for (const IntPoint& p : path) piece.outline.push_back(toMm(p));
    piece.volume_mm3 = volumeUnder(path);
    piece.thickness_mm = thickness(path);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool SectionArea::apart() const {
  return std::count_if(impl_->loops.begin(), impl_->loops.end(),
                       [](const Loop& loop) { return ClipperLib::Orientation(loop.points); }) > 1;
}

double SectionArea::depthOf(const Vec2& p) const {
  double best = std::numeric_limits<double>::infinity();
  const double x = p.x() / kUnit, y = p.y() / kUnit;
  for (const Loop& loop : impl_->loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const IntPoint &a = loop.points[i], &b = loop.points[(i + 1) % loop.points.size()];
      if (a.X == 0 && b.X == 0) continue;  // the axis is no surface
      best = std::min(best, distance2(x, y, a, b));
    }
  }
  return kUnit * std::sqrt(best);
}

std::vector<SectionBody> SectionArea::bodies() const {
  std::vector<SectionBody> bodies;
  std::vector<const Loop*> hollows;
  std::vector<const Loop*> borders;
  const auto take = [](const Loop& loop) {
    SectionLoop out;
    for (const IntPoint& p : loop.points) out.points.push_back(toMm(p));
    out.motion = loop.motion;
    return out;
  };
  for (const Loop& loop : impl_->loops) {
    if (!ClipperLib::Orientation(loop.points)) {
      hollows.push_back(&loop);
      continue;
    }
    if (thickness(loop.points) < kThinPiece) continue;
    borders.push_back(&loop);
  }
  const auto lowest = [](const Loop* loop) {
    cInt low = std::numeric_limits<cInt>::max();
    for (const IntPoint& p : loop->points) low = std::min(low, p.Y);
    return low;
  };
  std::stable_sort(borders.begin(), borders.end(),
                   [&](const Loop* a, const Loop* b) { return lowest(a) < lowest(b); });
  for (const Loop* border : borders) {
    SectionBody body;
    body.loops.push_back(take(*border));
    body.volume_mm3 = volumeUnder(border->points);
    for (const Loop* hollow : hollows) {
      if (ClipperLib::PointInPolygon(hollow->points.front(), border->points) == 0) continue;
      body.loops.push_back(take(*hollow));
      body.volume_mm3 += volumeUnder(hollow->points);
    }
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace proveout
