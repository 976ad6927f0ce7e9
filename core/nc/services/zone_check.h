// Where a motion of the machine's axes first enters a forbidden area.
#pragma once

#include <limits>
#include <optional>

#include "core/machine/axis_point.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// A box over some axes of the machine: mm, rotary axes degrees. Sides may be infinite.
struct Zone {
  AxisSet axes;   ///< that it bounds
  AxisPoint low;  ///< low <= high on these
  AxisPoint high;
  /// true: forbidden is where any of the axes is beyond its side. false: where all of them are within their
  /// sides, which belong to the area.
  bool outside = false;
};

/// A motion of the axes: all of them straight, or three along an arc.
class ZonePath {
 public:
  /// `count`: axes that there are.
  ZonePath(const AxisPoint& from, const AxisPoint& to, int count) : from_(from), to_(to), count_(count) {}
  /// The axes u, v, w go along `arc`, given in their coordinates.
  void setArc(int u, int v, int w, const ArcGeometry& arc);

  int count() const { return count_; }
  const AxisPoint& end() const { return to_; }
  /// 0 <= t <= 1.
  AxisPoint at(double t) const;
  /// Bound of how far any axis goes off the straight line between two points of the path that are `span`
  /// apart in t.
  double bulge(int axis, double span) const;

 private:
  int arcIndex(int axis) const;

  AxisPoint from_, to_;
  int count_;
  bool is_arc_ = false;
  std::array<int, 3> arc_axes_{};
  ArcGeometry arc_;
  ArcFrame frame_{};
  double bend_ = 0.0;  ///< bound of the second derivative of the arc's radius vector, mm
};

struct ZoneHit {
  double t = 0.0;      ///< the first point of the path that is forbidden; just before it, within 1e-9 mm
  int axis = -1;       ///< that goes beyond its side, of zones with `outside`
  bool above = false;  ///< beyond the higher side
};

/// Whether a point is forbidden; with `outside` also which axis is beyond which side (the first of them).
std::optional<ZoneHit> forbidden(const Zone& zone, const AxisPoint& point, int count);

/// The first forbidden point of the path; nothing: there is none. Exact to 1e-9 mm: pieces are divided until
/// bounds of the path decide.
std::optional<ZoneHit> firstForbidden(const Zone& zone, const ZonePath& path);

}  // namespace proveout::nc
