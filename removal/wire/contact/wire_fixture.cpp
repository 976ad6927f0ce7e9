#include "removal/wire/contact/wire_fixture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/tool/tool_table.h"
#include "removal/wire/section/ruled_way.h"

namespace proveout {
namespace {

/// A touch less deep than this is not reported, mm.
constexpr double kLeastMm = 1e-3;
/// How far the wire is followed above and below the fixture, mm: its ends are outside of it.
constexpr double kBeyondMm = 1.0;
/// Farther than anything, mm.
constexpr double kFar = 1e9;
/// Stations along a motion and over the height of the fixture at which depth and volume are taken.
constexpr int kAlong = 64, kUp = 16;

/// A straight piece of the wire's middle line.
struct WirePiece3 {
  Vec3 from, to;
  Box3 bounds() const {
    Box3 box;
    box.extend(from);
    box.extend(to);
    return box;
  }
};

/// Between two segments (C. Ericson, Real-Time Collision Detection, 5.1.9).
double segmentDistance(const WirePiece3& a, const Vec3& from, const Vec3& to) {
  const Vec3 u = a.to - a.from, v = to - from, w = a.from - from;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double det = uu * vv - uv * uv;
  double s = det > 1e-14 * uu * vv ? std::clamp((uv * vw - uw * vv) / det, 0.0, 1.0) : 0.0;
  const double t = vv > 0.0 ? std::clamp((uv * s + vw) / vv, 0.0, 1.0) : 0.0;
  if (uu > 0.0) s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
  return (w + s * u - t * v).norm();
}

/// Whether a segment goes through a triangle, seen by the volumes that it spans with its edges.
bool goesThrough(const WirePiece3& piece, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a), way = piece.to - piece.from;
  const double from = n.dot(piece.from - a), to = n.dot(piece.to - a);
  if (from * to > 0.0 || from == to) return false;
  const Vec3 p = piece.from + from / (from - to) * way;
  return n.dot((b - a).cross(p - a)) >= 0.0 && n.dot((c - b).cross(p - b)) >= 0.0 &&
         n.dot((a - c).cross(p - c)) >= 0.0;
}

double triangleDistance(const WirePiece3& piece, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (goesThrough(piece, a, b, c)) return 0.0;
  double least =
      std::min({segmentDistance(piece, a, b), segmentDistance(piece, b, c), segmentDistance(piece, c, a)});
  for (const Vec3& end : {piece.from, piece.to})
    least = std::min(least, (nearestOfTriangle(end, a, b, c).point - end).norm());
  return least;
}

/// One motion against one fixture.
class MotionCheck {
 public:
  MotionCheck(const SurfaceMesh& solid, const SignedDistance& distance, const Box3& bounds,
              const RuledWay& way, double radius)
      : solid_(solid),
        distance_(distance),
        low_(bounds.min.z()),
        high_(bounds.max.z()),
        way_(way),
        radius_(radius),
        speed_(way.speed(low_ - kBeyondMm, high_ + kBeyondMm)) {}

  /// A share of the motion at which the wire touches; none: at none.
  std::optional<double> touch() const { return touchWithin(0.0, 1.0); }

  /// Deepest place, depth and volume.
  void measure(double touch, Contact& contact) const {
    PROVEOUT_ASSERT(touch >= 0.0 && touch <= 1.0);
    contact.depth_mm = 0.0;
    take(deepestNear(touch), contact);
    const double z = 0.5 * (low_ + high_);
    double inside_mm2 = 0.0;
    for (int k = 0; k < kAlong; ++k) {
      const double way =
          (way_.at((k + 1.0) / kAlong, z) - way_.at(static_cast<double>(k) / kAlong, z)).norm();
      inside_mm2 += way * take((k + 0.5) / kAlong, contact);
    }
    contact.volume_mm3 = inside_mm2 * 2.0 * radius_;
  }

 private:
  WirePiece3 wireAt(double t) const { return {way_.at(t, low_ - kBeyondMm), way_.at(t, high_ + kBeyondMm)}; }

  /// From the middle line to the surface; what is farther than `within` is infinitely far.
  double distanceAt(double t, double within) const {
    const WirePiece3 wire = wireAt(t);
    double least = within;
    bool any = false;
    distance_.tree().forEachIn(wire.bounds().inflated(within), [&](std::uint32_t triangle) {
      const auto& [a, b, c] = solid_.triangles[triangle];
      const double mm = triangleDistance(wire, solid_.points[a], solid_.points[b], solid_.points[c]);
      any = any || mm <= within;
      least = std::min(least, mm);
    });
    return any ? least : std::numeric_limits<double>::infinity();
  }

  /// No place of the wire goes farther than speed_ times the share: what is far at the middle of a span is
  /// clear all over it.
  std::optional<double> touchWithin(double begin, double end) const {
    const double middle = 0.5 * (begin + end), reach = 0.5 * speed_ * (end - begin);
    const double off = distanceAt(middle, radius_ + reach);
    if (off < radius_) return middle;
    if (std::isinf(off) || reach < kLeastMm) return std::nullopt;
    if (const auto first = touchWithin(begin, middle)) return first;
    return touchWithin(middle, end);
  }

  /// Between the stations beside a touch, by thirds.
  double deepestNear(double touch) const {
    double begin = std::max(0.0, touch - 1.0 / kAlong), end = std::min(1.0, touch + 1.0 / kAlong);
    while ((end - begin) * speed_ > kLeastMm) {
      const double third = (end - begin) / 3.0;
      const bool first = distanceAt(begin + third, kFar) <= distanceAt(end - third, kFar);
      (first ? end : begin) = first ? end - third : begin + third;
    }
    const double middle = 0.5 * (begin + end);
    return distanceAt(middle, kFar) <= distanceAt(touch, kFar) ? middle : touch;
  }

  /// Looks at the wire at one share of the motion. Returns how long it is inside, mm.
  double take(double t, Contact& contact) const {
    const double off = distanceAt(t, radius_);
    if (std::isinf(off)) return 0.0;
    deepen(radius_ - off, nearestOn(wireAt(t)), contact);
    int inside = 0;
    for (int k = 0; k < kUp; ++k) {
      const Vec3 p = way_.at(t, low_ + (k + 0.5) / kUp * (high_ - low_));
      const double mm = distance_.at(p).distance;
      if (mm < 0.0) ++inside;
      deepen(radius_ - mm, p, contact);
    }
    return inside * (high_ - low_) / kUp;
  }

  static void deepen(double depth, const Vec3& p, Contact& contact) {
    if (depth <= contact.depth_mm) return;
    contact.depth_mm = depth;
    contact.where = p;
  }

  /// The station of the wire that is nearest to the surface.
  Vec3 nearestOn(const WirePiece3& wire) const {
    Vec3 best = wire.from;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 4 * kUp; ++k) {
      const Vec3 p = wire.from + static_cast<double>(k) / (4 * kUp) * (wire.to - wire.from);
      const double mm = std::abs(distance_.at(p).distance);
      if (mm >= least) continue;
      least = mm;
      best = p;
    }
    return best;
  }

  const SurfaceMesh& solid_;
  const SignedDistance& distance_;
  double low_, high_;
  const RuledWay& way_;
  double radius_, speed_;
};

Box3 boundsOf(const SurfaceMesh& solid) {
  Box3 box;
  for (const Vec3& p : solid.points) box.extend(p);
  return box;
}

}  // namespace

WireFixture::WireFixture(const SurfaceMesh& solid)
    : solid_(solid), distance_(solid), bounds_(boundsOf(solid)) {}

std::vector<Contact> WireFixture::touches(const Toolpath& path, const std::vector<Tool>& tools,
                                          Progress& progress) const {
  const ToolTable table(tools);
  std::vector<Contact> found(path.motions.size());
  parallelFor(std::size_t{0}, path.motions.size(), [&](std::size_t id) {
    const Motion& motion = path.motions[id];
    const Tool* tool = table.ofMotion(motion.tool);
    if (motion.wire < 0 || tool == nullptr || tool->type != ToolType::kWire || progress.cancelled()) return;
    PROVEOUT_ASSERT(static_cast<std::size_t>(motion.wire) < path.wires.size());
    const WireSweep& sweep = path.wires[static_cast<std::size_t>(motion.wire)];
    if (!sweep.state.threaded) return;
    const RuledWay way(sweep);
    const double radius = 0.5 * tool->diameter;
    if (!way.bounds(bounds_.min.z(), bounds_.max.z()).inflated(radius).overlaps(bounds_)) return;
    const MotionCheck check(solid_, distance_, bounds_, way, radius);
    const std::optional<double> touch = check.touch();
    if (!touch) return;
    Contact& contact = found[id];
    contact.kind = ContactKind::kWire;
    contact.motion = contact.last = static_cast<MotionId>(id);
    check.measure(*touch, contact);
  });
  std::erase_if(found, [](const Contact& contact) { return contact.motion == kNoMotion; });
  return found;
}

}  // namespace proveout
