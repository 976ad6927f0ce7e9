#include "removal/wire/contact/wire_contacts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "removal/grid/start_hole.h"
#include "removal/wire/section/edge_curves.h"
#include "removal/wire/section/kerf_section.h"
#include "removal/wire/section/stretch_index.h"

namespace proveout {
namespace {

/// Contacts thinner than this are mere touches, and not reported, mm.
constexpr double kTouch = 1e-3;
/// The blank's arcs, where only places in the middle of the kerf are asked about, mm.
constexpr double kCoarse = 0.02;
/// Stations along a motion, at most; places across the kerf at each.
constexpr int kMostStations = 32, kAcross = 6;
/// Places along a rapid whose depth is looked at.
constexpr int kDepthStations = 64;

/// Looks at ways and places of the wire one after the other; sections are made only for those that meet
/// something.
class MaterialCheck {
 public:
  MaterialCheck(const PrismBlank& blank, const WireWork& work, const WireHolding& holding)
      : blank_(blank),
        work_(work),
        holding_(holding),
        index_(work.cuts),
        sides_(wire_detail::sidesOf(blank.loops)) {}

  std::optional<Contact> of(const WireWork::Rapid& rapid) {
    PROVEOUT_ASSERT(rapid.after <= work_.cuts.size());
    std::vector<WireStretch> earlier;
    const Box3 box = boundsOf(rapid.stretch).inflated(rapid.stretch.kerf_mm);
    for (const std::uint32_t i : index_.near(box, rapid.after)) earlier.push_back(work_.cuts[i]);
    Contact contact;
    contact.motion = contact.last = rapid.stretch.motion;
    for (const std::vector<Vec2>& piece : metBy(rapid.stretch, blank_.loops, earlier, kTouch)) {
      // A polygon is told without its hollows.
      const std::vector<Vec2> places = placesIn(piece);
      const auto at =
          std::find_if(places.begin(), places.end(), [&](const Vec2& p) { return isHeld(p, rapid.after); });
      if (at == places.end()) continue;
      contact.volume_mm3 += std::abs(polygonArea(piece)) * (blank_.z_high - blank_.z_low);
      deepen(*at, rapid, contact);
    }
    if (contact.volume_mm3 <= 0.0) return std::nullopt;
    for (int k = 0; k <= kDepthStations; ++k)
      deepen(rapid.stretch.at(static_cast<double>(k) / kDepthStations), rapid, contact);
    return contact;
  }

 private:
  /// Whether the body there has not fallen before the rapid.
  bool isHeld(const Vec2& p, std::uint32_t cuts) {
    if (!held_ || held_at_ != cuts) {
      const std::vector<WireStretch> done(work_.cuts.begin(), work_.cuts.begin() + cuts);
      const std::vector<PlaneBody> bodies = cutSection(blank_.loops, done);
      held_.emplace();
      for (const PlaneBody& body : bodies) {
        if (!holding_.keeps(body)) continue;
        PlanePolygons loops = polygonsOf(body.loops, kTouch);
        std::move(loops.begin(), loops.end(), std::back_inserter(*held_));
      }
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
  const WireHolding& holding_;
  StretchIndex index_;
  std::vector<WireStretch> sides_;
  std::optional<PlanePolygons> held_;  ///< before the motion behind held_at_ cuts
  std::uint32_t held_at_ = 0;
};

/// The round hollow of the blank in which a point lies.
std::optional<StartHole> holeAt(const PrismBlank& blank, const Vec2& p) {
  for (const PlaneLoop& loop : blank.loops) {
    const PlaneEdge& edge = loop.edges.front();
    const double radius = (edge.from - edge.center).norm();
    const bool hollow = loop.edges.size() == 1 && edge.sweep_rad < 0.0;
    if (hollow && (p - edge.center).norm() < radius) return StartHole{edge.center, 2.0 * radius};
  }
  return std::nullopt;
}

/// Pieces that had fallen are cut no more.
bool hasFallen(const std::vector<FreePiece>& fallen, const CutTime& time, const Vec2& p) {
  return std::any_of(fallen.begin(), fallen.end(), [&](const FreePiece& piece) {
    return piece.passed_over && piece.fell <= time && holds(piece.region, p);
  });
}

}  // namespace

std::vector<Contact> rapidContacts(const PrismBlank& blank, const WireWork& work, const WireHolding& holding,
                                   Progress& progress) {
  std::vector<Contact> contacts;
  if (work.rapids.empty()) return contacts;
  MaterialCheck check(blank, work, holding);
  for (const WireWork::Rapid& rapid : work.rapids) {
    if (progress.cancelled()) break;
    if (const std::optional<Contact> contact = check.of(rapid)) contacts.push_back(*contact);
  }
  return contacts;
}

std::vector<ThreadingFault> threadingFaults(const PrismBlank& blank, const WireWork& work,
                                            const std::vector<ThreadingPlace>& places,
                                            const WireHolding& holding, Progress& progress) {
  std::vector<ThreadingFault> faults;
  MaterialCheck check(blank, work, holding);
  for (const ThreadingPlace& place : places) {
    if (progress.cancelled()) break;
    WireStretch standing;
    standing.from = standing.to = place.at;
    standing.kerf_mm = 0.5 * place.wire_mm;
    if (!check.of({standing, place.after})) continue;
    ThreadingFault fault;
    fault.next = place.next;
    fault.where = Vec3(place.at.x(), place.at.y(), blank.z_high);
    fault.wire_mm = fault.needs_mm = place.wire_mm;
    if (const auto hole = holeAt(blank, place.at)) {
      fault.hole_mm = hole->diameter;
      fault.needs_mm = 2.0 * (place.at - hole->at).norm() + place.wire_mm;
    }
    faults.push_back(fault);
  }
  return faults;
}

std::vector<double> removedAreas(const PrismBlank& blank, const std::vector<WireStretch>& cuts,
                                 const std::vector<FreePiece>& fallen) {
  const PlanePolygons region = polygonsOf(blank.loops, kCoarse);
  const StretchIndex index(cuts);
  std::vector<double> areas(cuts.size());
  parallelFor(std::uint32_t{0}, static_cast<std::uint32_t>(cuts.size()), [&](std::uint32_t i) {
    const WireStretch& s = cuts[i];
    const int stations = std::clamp(static_cast<int>(s.length() / s.kerf_mm), 1, kMostStations);
    int taken = 0;
    for (int k = 0; k < stations; ++k) {
      const double t = (k + 0.5) / stations;
      for (int a = 0; a < kAcross; ++a) {
        const Vec2 p = onFront(s, t, 2.0 * (a + 0.5) / kAcross - 1.0);
        if (holds(region, p) && index.nearest(p, 0.0, i).stretch == StretchIndex::kNone &&
            !hasFallen(fallen, {i, t}, p))
          ++taken;
      }
    }
    areas[i] = 2.0 * s.kerf_mm * s.length() * taken / (stations * kAcross);
  });
  return areas;
}

}  // namespace proveout
