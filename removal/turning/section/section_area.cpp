#include "removal/turning/section/section_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "removal/turning/section/section_labels.h"
#include "removal/turning/section/section_reach.h"
#include "removal/turning/section/section_window.h"

namespace proveout {

namespace {

using section_detail::ChainLoop;
using section_detail::cInt;
using section_detail::clean;
using section_detail::EdgeLabels;
using section_detail::IntPoint;
using section_detail::kUnit;
using section_detail::Loop;
using section_detail::Piece;
using section_detail::reachOf;
using section_detail::WindowCut;

/// Areas with fewer points are clipped whole.
constexpr std::size_t kFewPoints = 150;
constexpr double kThinPiece = 1e-4;  ///< mm

cInt toUnits(double mm) { return static_cast<cInt>(std::llround(mm / kUnit)); }
IntPoint toUnits(const Vec2& p) { return {toUnits(p.x()), toUnits(p.y())}; }
Vec2 toMm(const IntPoint& p) { return {kUnit * static_cast<double>(p.X), kUnit * static_cast<double>(p.Y)}; }

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

/// `tool` less the union of `spared`.
ClipperLib::Paths lessSpared(ClipperLib::Paths tool, const std::vector<SectionPath>& spared) {
  const ClipperLib::Paths less = toPaths(spared);
  if (less.empty()) return tool;
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
  std::vector<ChainLoop> loops;
  IntPoint low{0, 0}, high{0, 0};
  double volume = 0.0;
  std::size_t points = 0;

  void measure() {
    volume = 0.0;
    points = 0;
    bool first = true;
    for (const ChainLoop& loop : loops) {
      PROVEOUT_ASSERT_DEAR(section_detail::isClosed(loop));
      for (const Piece& piece : loop) {
        volume += piece.volume_mm3;
        points += piece.edges();
        if (first) low = piece.low, high = piece.high;
        first = false;
        low = {std::min(low.X, piece.low.X), std::min(low.Y, piece.low.Y)};
        high = {std::max(high.X, piece.high.X), std::max(high.Y, piece.high.Y)};
      }
    }
  }

  std::vector<Loop> flat() const {
    std::vector<Loop> out;
    for (const ChainLoop& loop : loops) out.push_back(section_detail::flat(loop));
    return out;
  }

  /// What rounding may take off all along the surface, mm3.
  double roundingVolume() const {
    const Vec2 size = toMm(high) - toMm(low);
    return 2.0 * kPi * toMm(high).x() * (size.x() + size.y()) * 5.0 * kUnit;
  }
};

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
    PROVEOUT_ASSERT(from.motion.size() == from.points.size());
    Loop loop;
    for (const Vec2& p : from.points) loop.points.push_back(toUnits(p));
    loop.motion = from.motion;
    clean(loop);
    if (loop.points.size() > 2) impl_->loops.push_back(section_detail::chained(loop));
  }
  impl_->measure();
}

bool SectionArea::empty() const { return impl_->loops.empty(); }
Vec2 SectionArea::min() const { return toMm(impl_->low); }
Vec2 SectionArea::max() const { return toMm(impl_->high); }
double SectionArea::volume() const { return impl_->volume; }

std::size_t SectionArea::points() const { return impl_->points; }

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
  ClipperLib::Paths tool = toPaths(sweeps);
  const auto reach = reachOf(impl_->loops, tool);
  if (!reach) return 0.0;
  tool = lessSpared(std::move(tool), spared);
  const double rounding = impl_->roundingVolume();
  if (impl_->points > kFewPoints) {
    const WindowCut window(impl_->loops, reach->low, reach->high);
    const Difference local = difference(window.inside(), tool, motion, rounding);
    if (local.taken_mm3 <= 0.0) return 0.0;
    std::vector<ChainLoop> joined;
    if (window.join(local.loops, joined)) {
      impl_->loops = std::move(joined);
      impl_->measure();
      return local.taken_mm3;
    }
  }
  Difference whole = difference(impl_->flat(), tool, motion, rounding);
  if (whole.taken_mm3 <= 0.0) return 0.0;
  cleanAll(whole.loops);
  impl_->loops.clear();
  for (const Loop& loop : whole.loops) impl_->loops.push_back(section_detail::chained(loop));
  impl_->measure();
  return whole.taken_mm3;
}

double SectionArea::subtractMany(const std::vector<SectionPath>& sweeps, MotionId motion) {
  // Polygons of many points have enough in their own window.
  constexpr std::size_t kAtOnce = 32, kPointsAtOnce = 500;
  double taken = 0.0;
  for (std::size_t i = 0; i < sweeps.size();) {
    std::size_t end = i, points = 0;
    while (end < sweeps.size() && end - i < kAtOnce && points < kPointsAtOnce) points += sweeps[end++].size();
    const auto from = sweeps.begin() + static_cast<std::ptrdiff_t>(i);
    taken += subtract({from, sweeps.begin() + static_cast<std::ptrdiff_t>(end)}, motion);
    i = end;
  }
  return taken;
}

bool SectionArea::mayMeet(const std::vector<SectionPath>& sweeps) const {
  return reachOf(impl_->loops, toPaths(sweeps)).has_value();
}

std::vector<SectionPiece> SectionArea::common(const std::vector<SectionPath>& sweeps,
                                              const std::vector<SectionPath>& spared) const {
  std::vector<SectionPiece> pieces;
  ClipperLib::Paths tool = toPaths(sweeps);
  const auto reach = reachOf(impl_->loops, tool);
  if (!reach) return pieces;
  tool = lessSpared(std::move(tool), spared);
  const bool few = impl_->points <= kFewPoints;
  const ClipperLib::Paths both = few ? combined(impl_->flat(), tool, ClipperLib::ctIntersection)
                                     : combined(WindowCut(impl_->loops, reach->low, reach->high).inside(),
                                                tool, ClipperLib::ctIntersection);
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
                       [](const ChainLoop& loop) { return section_detail::areaOf(loop) >= 0.0; }) > 1;
}

double SectionArea::depthOf(const Vec2& p) const {
  double best = std::numeric_limits<double>::infinity();
  for (const ChainLoop& loop : impl_->loops)
    best = section_detail::nearestEdge2(loop, p.x() / kUnit, p.y() / kUnit, best);
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
  const std::vector<Loop> loops = impl_->flat();
  for (const Loop& loop : loops) {
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
  // Of pieces that end at one face the larger one comes first, in whatever order they were cut.
  std::stable_sort(borders.begin(), borders.end(), [&](const Loop* a, const Loop* b) {
    const cInt low_a = lowest(a), low_b = lowest(b);
    return low_a != low_b ? low_a < low_b : volumeUnder(a->points) > volumeUnder(b->points);
  });
  for (const Loop* border : borders) {
    PROVEOUT_ASSERT(border->motion.size() == border->points.size());
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
