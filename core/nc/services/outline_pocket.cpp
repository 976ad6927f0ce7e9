#include "core/nc/services/outline_pocket.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/geometry/types.h"
#include "core/nc/services/contour/contour_clearance.h"
#include "core/nc/services/contour/contour_offset.h"

namespace proveout {
namespace {

constexpr double kClosedMm = 1e-3;  ///< the outline ends where it began
constexpr double kChordMm = 1e-4;   ///< arcs are taken as chords so near for the lanes
constexpr double kNearMm = 1e-4;    ///< the tool may come so much nearer to the wall by rounding
constexpr int kMaxLanes = 20000;
constexpr double kMostChords = 2000;

struct Chord {
  Vec2 a, b;
};

/// Part of a lane.
struct PocketSpan {
  double from, to;
  double across;
  bool done = false;
};

/// Lanes run along the first coordinate: with lanes along v both are exchanged.
Vec2 laid(const Vec2& p, bool swap) { return swap ? Vec2(p.y(), p.x()) : p; }

std::vector<Chord> chordsOf(const PlaneContour& outline, bool swap) {
  std::vector<Chord> chords;
  for (const ContourElement& e : outline) {
    double pieces = 1.0;
    if (e.arc) {
      const double radius = (e.from - e.center).norm();
      const double ratio = std::clamp(1.0 - kChordMm / std::max(radius, kChordMm), -1.0, 1.0);
      const double angle = std::max(2.0 * std::acos(ratio), 1e-4);
      pieces = std::clamp(std::ceil(std::abs(e.sweep) / angle), 1.0, kMostChords);
    }
    Vec2 last = e.from;
    for (int k = 1; k <= static_cast<int>(pieces); ++k) {
      const Vec2 next = k == static_cast<int>(pieces) ? e.to : pointOn(e, k / pieces);
      chords.push_back({laid(last, swap), laid(next, swap)});
      last = next;
    }
  }
  return chords;
}

double distanceOf(const Vec2& p, const Chord& c) {
  const Vec2 way = c.b - c.a;
  const double length2 = way.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - c.a).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (p - c.a - t * way).norm();
}

double distanceOf(const Chord& x, const Chord& y) {
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  const Vec2 dx = x.b - x.a, dy = y.b - y.a;
  const bool apart = cross(dx, y.a - x.a) * cross(dx, y.b - x.a) > 0.0 ||
                     cross(dy, x.a - y.a) * cross(dy, x.b - y.a) > 0.0 || std::abs(cross(dx, dy)) == 0.0;
  if (!apart) return 0.0;
  return std::min(std::min(distanceOf(x.a, y), distanceOf(x.b, y)),
                  std::min(distanceOf(y.a, x), distanceOf(y.b, x)));
}

bool isInside(const Vec2& p, const std::vector<Chord>& chords) {
  bool in = false;
  for (const Chord& c : chords) {
    if ((c.a.y() > p.y()) == (c.b.y() > p.y())) continue;
    if (p.x() < c.a.x() + (p.y() - c.a.y()) / (c.b.y() - c.a.y()) * (c.b.x() - c.a.x())) in = !in;
  }
  return in;
}

/// The stretch of the line v = `v` that is nearer to a chord than `least`; from > to: there is none. The
/// place of all points so near is convex, hence one stretch.
struct Stretch {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();
  void add(double a, double b) {
    from = std::min(from, a);
    to = std::max(to, b);
  }
};
Stretch nearStretch(const Chord& c, double v, double least) {
  Stretch out;
  for (const Vec2& end : {c.a, c.b}) {
    const double h = v - end.y();
    if (std::abs(h) >= least) continue;
    const double half = std::sqrt(least * least - h * h);
    out.add(end.x() - half, end.x() + half);
  }
  const Vec2 way = c.b - c.a;
  const double length = way.norm();
  if (length == 0.0) return out;
  const Vec2 u = way / length;
  // Points (x, v): 0 <= (p - a) u <= length, |(p - a) n| < least; both are linear in x.
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  bool none = false;
  const auto limit = [&](double slope, double at_zero, double a, double b) {
    if (std::abs(slope) < 1e-12) {
      none = none || at_zero < a || at_zero > b;
      return;
    }
    const double x1 = (a - at_zero) / slope, x2 = (b - at_zero) / slope;
    low = std::max(low, std::min(x1, x2));
    high = std::min(high, std::max(x1, x2));
  };
  limit(u.x(), -c.a.x() * u.x() + (v - c.a.y()) * u.y(), 0.0, length);
  limit(-u.y(), c.a.x() * u.y() + (v - c.a.y()) * u.x(), -least, least);
  if (!none && low < high && std::isfinite(low) && std::isfinite(high)) out.add(low, high);
  return out;
}

/// The ways inside the outline with a distance from it.
class LanePlanner {
 public:
  LanePlanner(std::vector<Chord> chords, double least) : chords_(std::move(chords)), least_(least) {
    for (const Chord& c : chords_) {
      for (const Vec2& p : {c.a, c.b}) {
        low_ = std::min(low_, p.y());
        high_ = std::max(high_, p.y());
      }
    }
  }

  bool keepsOff(const Vec2& a, const Vec2& b) const {
    const Chord way{a, b};
    return std::all_of(chords_.begin(), chords_.end(),
                       [&](const Chord& c) { return distanceOf(way, c) >= least_ - kNearMm; });
  }
  bool holds(const Vec2& p) const { return keepsOff(p, p) && isInside(p, chords_); }

  /// False: they are too many.
  bool makeLanes(double step) {
    const double low = low_ + least_, high = high_ - least_;
    if (high < low - kNearMm) return true;
    const double count = std::max(0.0, std::ceil((high - low) / step - 1e-9));
    if (count > kMaxLanes) return false;
    for (int k = 0; k <= static_cast<int>(count); ++k) addLane(std::min(low + k * step, high));
    return true;
  }
  std::size_t spans() const { return spans_.size(); }

  /// Runs all of them, from the nearest to `at` on, which becomes the end.
  void run(Vec2& at, std::vector<PocketMove>& moves) {
    for (std::size_t k = 0; k < spans_.size(); ++k) {
      bool backwards = false;
      PocketSpan& next = nearest(at, backwards);
      next.done = true;
      const Vec2 from(backwards ? next.to : next.from, next.across);
      const Vec2 to(backwards ? next.from : next.to, next.across);
      const bool clear = keepsOff(at, from);
      moves.push_back({clear ? PocketMove::Kind::kLine : PocketMove::Kind::kOver, from, Vec2::Zero(), 0.0});
      moves.push_back({PocketMove::Kind::kLine, to, Vec2::Zero(), 0.0});
      at = to;
    }
  }

 private:
  void addLane(double v) {
    std::vector<Stretch> closed;
    for (const Chord& c : chords_) {
      const Stretch s = nearStretch(c, v, least_ + kChordMm);  // arcs lie so much beside their chords
      if (s.from < s.to) closed.push_back(s);
    }
    std::sort(closed.begin(), closed.end(),
              [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    double open = -std::numeric_limits<double>::infinity();
    for (const Stretch& s : closed) {
      if (std::isfinite(open) && s.from > open + 1e-9) addSpan(open, s.from, v);
      open = std::max(open, s.to);
    }
  }
  void addSpan(double from, double to, double v) {
    if (isInside(Vec2(0.5 * (from + to), v), chords_)) spans_.push_back({from, to, v, false});
  }
  /// The span whose nearer end is next; of ways that keep off the wall before others.
  PocketSpan& nearest(const Vec2& at, bool& backwards) {
    PocketSpan* best = nullptr;
    double best_cost = std::numeric_limits<double>::infinity();
    for (PocketSpan& span : spans_) {
      if (span.done) continue;
      for (const bool back : {false, true}) {
        const Vec2 end(back ? span.to : span.from, span.across);
        const double cost = (end - at).norm();
        if (cost >= best_cost) continue;
        best = &span;
        best_cost = cost;
        backwards = back;
      }
    }
    return *best;
  }

  std::vector<Chord> chords_;
  double least_;
  double low_ = std::numeric_limits<double>::infinity();  ///< of the outline, across the lanes
  double high_ = -std::numeric_limits<double>::infinity();
  std::vector<PocketSpan> spans_;
};

PlaneContour reversedContour(const PlaneContour& contour) {
  PlaneContour out;
  for (auto e = contour.rbegin(); e != contour.rend(); ++e) {
    ContourElement back = *e;
    std::swap(back.from, back.to);
    back.sweep = -back.sweep;
    out.push_back(back);
  }
  return out;
}

/// The contour from the middle of its longest element on: there it joins itself without a corner.
PlaneContour fromMiddle(const PlaneContour& contour) {
  const auto length = [](const ContourElement& e) {
    return e.arc ? std::abs(e.sweep) * (e.from - e.center).norm() : (e.to - e.from).norm();
  };
  const auto longest = std::max_element(contour.begin(), contour.end(),
                                        [&](const auto& a, const auto& b) { return length(a) < length(b); });
  PlaneContour out{partOf(*longest, 0.5, 1.0)};
  out.insert(out.end(), longest + 1, contour.end());
  out.insert(out.end(), contour.begin(), longest);
  out.push_back(partOf(*longest, 0.0, 0.5));
  return out;
}

/// Along the wall, at a distance, from `at`, which becomes the end.
void alongWall(const PlaneContour& wall, const LanePlanner& plan, bool swap, Vec2& at,
               std::vector<PocketMove>& moves) {
  const Vec2 first = wall.front().from;
  const bool clear = plan.keepsOff(laid(at, swap), laid(first, swap));
  moves.push_back({clear ? PocketMove::Kind::kLine : PocketMove::Kind::kOver, first, Vec2::Zero(), 0.0});
  for (const ContourElement& e : wall)
    moves.push_back({e.arc ? PocketMove::Kind::kArc : PocketMove::Kind::kLine, e.to, e.center, e.sweep});
  at = wall.back().to;
}

std::string faultOf(const OutlinePocket& p) {
  if (p.outline.size() < 2) return "the outline has fewer than two elements";
  if (!(p.tool_radius > 0.0)) return "the radius of the tool is not known: program D";
  if (!(p.step > 0.0)) return "the step from lane to lane is not above 0";
  if (!(p.allowance >= 0.0)) return "the allowance for the finishing pass is negative";
  if ((p.outline.back().to - p.outline.front().from).norm() > kClosedMm) return "the outline is not closed";
  return {};
}

}  // namespace

bool turnsLeft(const PlaneContour& closed) {
  double area = 0.0;
  for (const ContourElement& e : closed) {
    area += 0.5 * (e.from.x() * e.to.y() - e.to.x() * e.from.y());
    if (!e.arc) continue;
    const double radius = (e.from - e.center).norm();
    area += 0.5 * radius * radius * (e.sweep - std::sin(e.sweep));
  }
  return area > 0.0;
}

Result<OutlinePocketWays> outlinePocketWays(const OutlinePocket& p) {
  if (const std::string fault = faultOf(p); !fault.empty()) return inputError(fault);
  const PlaneContour contour = fromMiddle(turnsLeft(p.outline) ? p.outline : reversedContour(p.outline));
  const double rough = p.tool_radius + p.allowance;
  OutlinePocketWays ways;
  bool fits = true;
  const Result<PlaneContour> rough_wall = offsetContour(contour, rough, fits);
  if (!rough_wall.ok()) return inputError(rough_wall.error().message);
  LanePlanner lanes(chordsOf(contour, p.along_v), rough);
  const LanePlanner tool(chordsOf(contour, p.along_v), p.tool_radius);
  if (!tool.holds(laid(p.start, p.along_v)))
    return inputError("the start is outside of the outline, or nearer to it than the radius of the tool");
  if (!lanes.makeLanes(p.step)) return inputError("the step from lane to lane is too small");
  Vec2 at = laid(p.start, p.along_v);
  lanes.run(at, ways.rough);
  for (PocketMove& move : ways.rough) move.to = laid(move.to, p.along_v);
  at = laid(at, p.along_v);
  alongWall(rough_wall.value(), tool, p.along_v, at, ways.rough);
  PlaneContour wall = rough_wall.value();
  if (p.allowance > 0.0) {
    const Result<PlaneContour> finish = offsetContour(contour, p.tool_radius, fits);
    if (!finish.ok()) return inputError(finish.error().message);
    alongWall(finish.value(), tool, p.along_v, at, ways.finish);
    if (firstNearPass(finish.value(), contour, p.tool_radius - kNearMm)) fits = false;
  }
  if (firstNearPass(wall, contour, rough - kNearMm))
    return inputError("the tool does not fit between the walls of the outline");
  ways.all_reached = fits;
  return ways;
}

}  // namespace proveout
