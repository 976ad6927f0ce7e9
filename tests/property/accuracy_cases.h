// Cuts whose results are known in closed form, for the accuracy tests: a tool along one path at constant
// height, or a slanted line. All mm. Kept apart from the engine: nothing here uses its kernels.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/path/toolpath.h"
#include "removal/grid/stock_shape.h"

namespace proveout::accuracy {

/// Lower outline of a tool about its axis, tip at 0. Its upper side has no end.
struct Outline {
  double radius = 0.0;  ///< of the whole tool
  /// Height of the outline at radius r <= radius. Convex, does not fall.
  std::function<double(double)> lower;
  /// Signed distance to the outline from (r, z), exact near it. Negative inside.
  std::function<double(double, double)> distance;
  /// (r, z) of the sharp edges of the outline.
  std::vector<Vec2> edges;
  /// Least radius of curvature of the outline itself; infinite where it is straight.
  double curvature_radius = 0.0;

  /// Largest r with lower(r) <= z; 0 <= z.
  double radiusAt(double z) const;
};

Outline flatOutline(double diameter);
Outline ballOutline(double diameter);
Outline bullOutline(double diameter, double corner);
Outline coneOutline(double diameter, double tip, double angle_deg);
Outline drillOutline(double diameter, double angle_deg);
/// A ball nose and a cone that touches it.
Outline taperOutline(double ball_diameter, double side_deg, double diameter);

/// A level curve that the tip follows, seen from above.
struct Curve {
  std::function<double(const Vec2&)> distance;  ///< to the curve
  /// Area of all points within q of the curve.
  std::function<double(double)> area_within;
  /// Points at distance q, `n` of them, spread over the whole contour.
  std::function<std::vector<Vec2>(double q, int n)> contour;
  /// Radius of curvature of the contour through a point.
  std::function<double(const Vec2&)> contour_radius;
};

Curve pointCurve(const Vec2& at);
Curve segmentCurve(const Vec2& from, const Vec2& to);
/// Requires the radius to be larger than any q asked for.
Curve circleCurve(const Vec2& center, double radius);

struct Case {
  std::string name, tool;  ///< of the test; option of the command line
  BoxShape blank;          ///< top at 0
  Toolpath path;
  double removed_mm3 = 0.0;
  /// Signed distance to the solid that is removed; exact near its surface.
  std::function<double(const Vec3&)> removed;
  /// How far a point is from the nearest sharp edge of the result; never more than the truth.
  std::function<double(const Vec3&)> edge_distance;
  std::vector<Vec3> edge_points;  ///< on sharp edges of the cut
  /// Least radius of curvature of the result's surface near a point on it; infinite on flat faces.
  std::function<double(const Vec3&)> curvature_radius;
};

void PrintTo(const Case& c, std::ostream* out);

/// The tip goes along the curve at height z < 0.
Case levelCase(const std::string& name, const std::string& tool, const Outline& outline, const Curve& curve,
               Toolpath path, double z);
/// The tip goes from one point to another, lower one. Both below the top of the blank.
Case slantedCase(const std::string& name, const std::string& tool, const Outline& outline, const Vec3& from,
                 const Vec3& to);

/// Feeds from point to point.
Toolpath linePath(const std::vector<Vec3>& points);

std::vector<Case> allCases();

/// Integral of a piecewise smooth f from a to b; `breaks` are where it is not smooth. To about 1e-10 of
/// `scale`.
double integrate(const std::function<double(double)>& f, double a, double b,
                 const std::vector<double>& breaks, double scale);

}  // namespace proveout::accuracy
