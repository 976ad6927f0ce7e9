#include "removal/wire/wire_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel_for.h"
#include "core/geometry/plane.h"
#include "removal/wire/edge_curves.h"
#include "removal/wire/face_triangles.h"
#include "removal/wire/kerf_section.h"
#include "removal/wire/stretch_index.h"

namespace proveout {
namespace {

/// Contacts thinner than this are touches, mm.
constexpr double kTouch = 1e-3;
/// The blank's arcs, where only places in the middle of the kerf are asked about, mm.
constexpr double kCoarse = 0.02;
/// Stations along a motion, at most; places across the kerf at each.
constexpr int kMostStations = 32, kAcross = 6;
/// Places along a rapid whose depth is looked at.
constexpr int kDepthStations = 64;

using Polygons = std::vector<std::vector<Vec2>>;

Polygons polygonsOf(const std::vector<PlaneLoop>& loops, double tolerance) {
  Polygons out;
  for (const PlaneLoop& loop : loops) out.push_back(chordsOf(loop, tolerance).points);
  return out;
}

bool holds(const Polygons& region, const Vec2& p) {
  const auto around = [&](const std::vector<Vec2>& polygon) { return surrounds(polygon, p); };
  return std::count_if(region.begin(), region.end(), around) % 2 == 1;
}

/// The middle of the largest triangle of a polygon.
Vec2 placeIn(const std::vector<Vec2>& polygon) {
  Vec2 best = polygon.front();
  double largest = 0.0;
  for (const auto& [a, b, c] : faceTriangles({polygon})) {
    const double twice = cross2(polygon[b] - polygon[a], polygon[c] - polygon[a]);
    if (twice <= largest) continue;
    largest = twice;
    best = (polygon[a] + polygon[b] + polygon[c]) / 3.0;
  }
  return best;
}

/// Looks at rapids one after the other; sections are made only for those that meet something.
class RapidCheck {
 public:
  RapidCheck(const PrismBlank& blank, const WireWork& work)
      : blank_(blank), work_(work), index_(work.cuts), sides_(wire_detail::sidesOf(blank.loops)) {}

  std::optional<Contact> of(const WireWork::Rapid& rapid) {
    std::vector<WireStretch> earlier;
    const Box3 box = boundsOf(rapid.stretch).inflated(rapid.stretch.kerf_mm);
    for (const std::uint32_t i : index_.near(box, rapid.after)) earlier.push_back(work_.cuts[i]);
    Contact contact;
    contact.motion = contact.last = rapid.stretch.motion;
    for (const std::vector<Vec2>& piece : metBy(rapid.stretch, blank_.loops, earlier, kTouch)) {
      const Vec2 at = placeIn(piece);
      if (!isHeld(at, rapid.after)) continue;
      contact.volume_mm3 += std::abs(areaOfPolygon(piece)) * (blank_.z_high - blank_.z_low);
      deepen(at, rapid, contact);
    }
    if (contact.volume_mm3 <= 0.0) return std::nullopt;
    for (int k = 0; k <= kDepthStations; ++k)
      deepen(rapid.stretch.at(static_cast<double>(k) / kDepthStations), rapid, contact);
    return contact;
  }

 private:
  static double areaOfPolygon(const std::vector<Vec2>& points) {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += 0.5 * cross2(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
    return sum;
  }

  /// Whether the body there has not fallen before the rapid.
  bool isHeld(const Vec2& p, std::uint32_t cuts) {
    if (!held_ || held_at_ != cuts) {
      const std::vector<WireStretch> done(work_.cuts.begin(), work_.cuts.begin() + cuts);
      const std::vector<PlaneBody> bodies = cutSection(blank_.loops, done);
      held_ = bodies.empty() ? Polygons{} : polygonsOf(bodies[heldBody(bodies)].loops, kTouch);
      held_at_ = cuts;
    }
    return holds(*held_, p);
  }

  void deepen(const Vec2& p, const WireWork::Rapid& rapid, Contact& contact) const {
    if (!held_ || !holds(*held_, p)) return;
    double depth = std::numeric_limits<double>::infinity();
    for (const WireStretch& side : sides_) depth = std::min(depth, distanceTo(side, p).mm);
    const double off = index_.nearest(p, depth, rapid.after).off_mm;
    depth = std::clamp(off, 0.0, depth);
    if (depth < contact.depth_mm) return;
    contact.depth_mm = depth;
    contact.where = Vec3(p.x(), p.y(), 0.5 * (blank_.z_low + blank_.z_high));
  }

  const PrismBlank& blank_;
  const WireWork& work_;
  StretchIndex index_;
  std::vector<WireStretch> sides_;
  std::optional<Polygons> held_;  ///< before the motion behind held_at_ cuts
  std::uint32_t held_at_ = 0;
};

}  // namespace

std::size_t heldBody(const std::vector<PlaneBody>& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::vector<PlaneEdge>& border = bodies[k].loops.front().edges;
    if (std::any_of(border.begin(), border.end(), [](const PlaneEdge& e) { return e.motion == kNoMotion; }))
      return k;
  }
  return 0;
}

std::vector<Contact> rapidContacts(const PrismBlank& blank, const WireWork& work, Progress& progress) {
  std::vector<Contact> contacts;
  if (work.rapids.empty()) return contacts;
  RapidCheck check(blank, work);
  for (const WireWork::Rapid& rapid : work.rapids) {
    if (progress.cancelled()) break;
    if (const std::optional<Contact> contact = check.of(rapid)) contacts.push_back(*contact);
  }
  return contacts;
}

std::vector<double> removedAreas(const PrismBlank& blank, const std::vector<WireStretch>& cuts) {
  const Polygons region = polygonsOf(blank.loops, kCoarse);
  const StretchIndex index(cuts);
  std::vector<double> areas(cuts.size());
  parallelFor(std::uint32_t{0}, static_cast<std::uint32_t>(cuts.size()), [&](std::uint32_t i) {
    const WireStretch& s = cuts[i];
    const int stations = std::clamp(static_cast<int>(s.length() / s.kerf_mm), 1, kMostStations);
    int taken = 0;
    for (int k = 0; k < stations; ++k) {
      // Ahead of the wire, where it cuts.
      const double t = (k + 0.5) / stations, next = std::min(1.0, t + 1e-6);
      const Vec2 at = s.at(t), to = s.at(next) - at;
      const Vec2 left = to.norm() > 0.0 ? Vec2(leftOf(to) / to.norm()) : leftOf(s.directionAtStart());
      for (int a = 0; a < kAcross; ++a) {
        const Vec2 p = at + left * (s.kerf_mm * (2.0 * (a + 0.5) / kAcross - 1.0));
        if (holds(region, p) && index.nearest(p, 0.0, i).stretch == StretchIndex::kNone) ++taken;
      }
    }
    areas[i] = 2.0 * s.kerf_mm * s.length() * taken / (stations * kAcross);
  });
  return areas;
}

}  // namespace proveout
