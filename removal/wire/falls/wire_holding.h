// What holds the bodies that a wire leaves: others fall.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "removal/wire/section/plane_region.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {

/// Loops with their arcs as chords.
PlanePolygons polygonsOf(const std::vector<PlaneLoop>& loops, double tolerance_mm);
/// Whether the region that loops bound holds a point.
bool holds(const PlanePolygons& region, const Vec2& p);
/// From a point to the border of a region, mm; infinite without one.
double borderDistance(const PlanePolygons& region, const Vec2& p);
/// A point well inside of a body, or of the region that polygons bound.
Vec2 placeIn(const PlaneBody& body);
Vec2 placeIn(const PlanePolygons& region);
/// The middles of the triangles that fill a polygon, that of the largest first.
std::vector<Vec2> placesIn(const std::vector<Vec2>& polygon);

class WireHolding {
 public:
  /// `fixtures`: where fixtures reach between the heights of the workpiece, convex polygons (footprintOf).
  /// `last`: the bodies of `blank` after all `cuts`. The bodies that fixtures touch are held; where they
  /// touch none, heldPlace().
  WireHolding(PlanePolygons fixtures, const std::vector<PlaneLoop>& blank,
              const std::vector<WireStretch>& cuts, const std::vector<PlaneBody>& last);
  /// The same with bodies that are made when they are first needed; not for several threads. `blank` and
  /// `cuts` must outlive it.
  WireHolding(PlanePolygons fixtures, const std::vector<PlaneLoop>& blank,
              const std::vector<WireStretch>& cuts, std::function<std::vector<PlaneBody>()> last);

  /// Whether a fixture touches any of the last bodies.
  bool byFixtures() const;
  /// Of a body at any time.
  bool keeps(const PlaneBody& body) const;

 private:
  bool touched(const PlaneBody& body) const;
  void settle(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
              const std::vector<PlaneBody>& last) const;
  void settle() const;

  PlanePolygons fixtures_;
  const std::vector<PlaneLoop>* blank_ = nullptr;         ///< until it is settled
  const std::vector<WireStretch>* cuts_ = nullptr;        ///< the same
  mutable std::function<std::vector<PlaneBody>()> last_;  ///< null: settled
  mutable bool by_fixtures_ = false;
  mutable std::optional<Vec2> held_;  ///< a place in the held body
};

/// Whether any of the fixtures comes within kHeldWithinMm of a region.
bool anyTouches(const PlanePolygons& fixtures, const PlanePolygons& region);

/// A place in the body that is held from the first cut to the last, where no fixture holds any. Whenever it
/// parts the larger of what keeps some of the blank's outer border stays (the border of a start hole may be a
/// slug's): what comes later does not change what fell. Where nothing keeps some it is the largest. Requires
/// bodies: those after all cuts, the largest first.
Vec2 heldPlace(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
               const std::vector<PlaneBody>& last);

}  // namespace proveout
