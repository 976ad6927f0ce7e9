// Resolves a circular block to geometry: centre and signed sweep. Works in plane coordinates (plane_frame.h);
// covers plane arcs, full circles, helices, planar spirals and conical helices.
// Decision order and formulas: NCT milling manual 4.3 - 4.3.3 (digest nct-1, 7.2 and 7.3).
#pragma once

#include <cstdint>
#include <optional>

#include "core/geometry/types.h"
#include "core/nc/services/plane_frame.h"
#include "core/path/toolpath.h"

namespace proveout {

enum class ArcError {
  kNone,
  kNoDefinition,        ///< neither a radius nor a centre word
  kCenterOutsidePlane,  ///< a centre word of the axis outside the plane
  kRadiusWithoutEnd,    ///< radius word, no plane end word, but another axis is to move
  kZeroRadius,          ///< start and centre coincide, and so does the end
  kRadiusDifference,    ///< start and end radius differ by more than the tolerance
  kBadTurns,            ///< turns < 1, or so many that the sweep has no exact meaning
  kNotFinite,           ///< an input is NaN or infinite
};

/// What may differ from control to control.
struct ArcPolicy {
  double radius_tolerance = 0.01;  ///< mm, |start radius - end radius| allowed without a turns word
  /// Start and end directions closer than this count as equal: full turn. 1e-7 deg is 1e-6 mm at a radius of
  /// 500 mm, below any control's increment and above rounding noise.
  double angle_tolerance_rad = degToRad(1e-7);
  std::int64_t max_turns = 1000000;
  /// A radius word below half the chord, by the tolerance at most, makes a half circle; beyond it the radii
  /// differ too much. False: the arc goes on as a spiral (ArcRequest::radius).
  bool short_radius_is_half = false;
};

/// One circular block in plane coordinates (u, v, w), mm.
struct ArcRequest {
  Vec3 start = Vec3::Zero();
  Vec3 end = Vec3::Zero();         ///< unchanged coordinates equal those of `start`
  bool has_plane_end = false;      ///< an end word of u or v is in the block
  bool has_other_axis = false;     ///< an end word of any other axis is in the block
  bool counter_clockwise = false;  ///< from +u to +v
  std::optional<double> center_u;  ///< from start to centre, incremental
  std::optional<double> center_v;  ///< from start to centre, incremental
  bool center_word_outside_plane = false;
  std::optional<double> radius;       ///< > 0: up to 180 deg; < 0: 180 deg and more. Wins over a centre
  std::optional<std::int64_t> turns;  ///< begun turns, >= 1; frees the radius from the tolerance
};

/// An arc in plane coordinates. Angle, radius and w go linearly together from start to end.
struct PlaneArc {
  Vec3 start = Vec3::Zero();   ///< (u, v, w), mm
  Vec3 end = Vec3::Zero();     ///< (u, v, w), mm
  Vec2 center = Vec2::Zero();  ///< (u, v), mm
  double sweep_rad = 0.0;      ///< signed, > 0 counter-clockwise, more than a turn is allowed, never 0

  double startRadius() const { return (start.head<2>() - center).norm(); }
  double endRadius() const { return (end.head<2>() - center).norm(); }
};

struct ArcResolution {
  ArcError error = ArcError::kNone;
  /// The block is legal and does not move: a radius word alone, or with an end equal to the start.
  bool no_motion = false;
  bool center_ignored = false;     ///< radius and centre were both given
  double radius_difference = 0.0;  ///< mm, |start radius - end radius|
  PlaneArc arc;                    ///< valid if error == kNone and !no_motion

  bool ok() const { return error == ArcError::kNone; }
};

ArcResolution resolveArc(const ArcRequest& request, const ArcPolicy& policy = {});

/// The arc as the tool path wants it; `arc.start` and `arc.end` through frame.fromPlane() are the motion's
/// ends.
ArcGeometry toArcGeometry(const PlaneArc& arc, const PlaneFrame& frame);

/// The same arc run from its end to its start.
PlaneArc reversed(const PlaneArc& arc);

/// How far the arc leads away from its start in the plane, mm; of spirals at least.
double farthestFromStart(const PlaneArc& arc);

/// Length in the plane (w ignored), mm; exact for circles and for spirals (closed form).
double planeLength(const PlaneArc& arc);

}  // namespace proveout
