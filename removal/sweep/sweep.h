// The volume that a solid of revolution sweeps along a line, arc, helix or spiral, as a signed distance
// field.
//
// Sign: negative inside the swept volume. Outside the value is the exact Euclidean distance; inside it is
// minus the largest depth below the surface of the solid at one position, a lower bound of the depth in the
// swept volume. The zero set is exact in both cases: the position is never sampled. Error below
// kSweepToleranceMm.
//
// Method: the distance to a convex solid is convex in the solid's position, so along a line its minimum over
// time is found by closed form (level moves) or by Newton's method, which stops on a proven bound; along an
// arc spans are bounded below by the chord's convexity less the sagitta, and split until the bound meets the
// value. On a helix about z the level distance from the tool's axis is convex over much of each turn, and the
// distance with it: there Newton's method serves as on lines, and the other turns are left out by bounds
// (sweep_curve.cpp).
#pragma once

#include "core/geometry/types.h"
#include "core/path/toolpath.h"
#include "core/tool/profile.h"

namespace proveout {

/// Bound of the error of Sweep::sample's value near the surface, mm. Pinned by the property test of the
/// sweeps.
inline constexpr double kSweepToleranceMm = 1e-7;

/// Where the search along a line stops: far below what anybody sees.
inline constexpr double kLineToleranceMm = 0.01 * kSweepToleranceMm;

struct SweepSample {
  double value;   ///< mm
  Vec3 gradient;  ///< unit, away from the swept volume
  int element;    ///< element of the profile that is nearest; from kEdgeIds on: the sharp rim behind an
                  ///< element
};

class Sweep {
 public:
  /// Start of a search that may set out anywhere.
  static constexpr double kAnywhere = -1.0;

  /// `profile` must outlive the sweep. `arc` is null for lines.
  Sweep(const ConvexProfile& profile, const Vec3& from, const Vec3& to, const ArcGeometry* arc);

  /// Distance at `p`, on lines to within `tolerance`, mm. Values above `cutoff` may be returned as any lower
  /// bound above `cutoff`.
  double distance(const Vec3& p, double cutoff, double tolerance = kLineToleranceMm) const;
  SweepSample sample(const Vec3& p) const;
  /// The same of a point on the surface of the swept volume, where the solid touches it at about the
  /// parameter `start`: on curves a short search from there, or that of sample() if it finds no such place.
  SweepSample sampleOnSurface(const Vec3& p, double start) const;
  /// Parameter of the place of a curve that lies at the angle of `at` about its axis; on several turns that
  /// of them which is nearest along the axis.
  double parameterAt(const Vec3& at) const;
  /// Whether the solid holds both points, and so all between them, at one place of its way; false also where
  /// no place is found.
  bool holds(const Vec3& a, const Vec3& b) const;
  /// The same for a point outside, where the distance has no kinks, to within `tolerance` > 0, mm, on lines;
  /// cheaper. An element from kEdgeIds on: an end of that straight element is nearest, not its face. `start`:
  /// where on the path (0 to 1) the search on a line or helix sets out, or kAnywhere; becomes a good start
  /// for points nearby.
  SweepSample sampleOutside(const Vec3& p, double tolerance, double& start) const;

  /// Distances at the `count` points (x, y, z0 + k * dz), each with its own cutoff as in distance().
  void column(double x, double y, double z0, double dz, int count, const double* cutoff, double* out) const;

  /// The way is a curve but not a level arc: its distance takes a search.
  bool isSlow() const { return kind_ == Kind::kCurve; }
  /// The way is a helix about z (its radius changes by no more than rounding): then the distance is found
  /// about as fast as on a line.
  bool replacesChords() const { return kind_ == Kind::kCurve && round_turns_; }

  /// Bounds of the swept volume, mm.
  Box3 bounds() const;

 private:
  enum class Kind { kPoint, kLevelLine, kLine, kLevelArc, kCurve };
  struct At {
    double value, slope;  ///< slope: derivative of the value by the path parameter
    int element;
    Vec3 gradient;
    /// Minus slope over Newton's step to the least value of the distance, or of its square where that is a
    /// distance from a point.
    double bend = 0.0;
  };
  /// A place on the path.
  struct Place {
    double t;
    At at;
  };

  At evaluate(const Vec3& p, double t) const;
  bool touch(const Vec3& p, Place& place) const;
  SweepSample withRim(const Vec3& p, const Place& place) const;
  /// Of the tool, that shows `at`. Many places of a tool that goes upright leave one wall: it is named after
  /// what stands there at the lowest, where it goes over into what is below.
  int elementAt(const Vec3& p, const At& at) const;
  At evaluateLine(const Vec3& p, double t) const;
  At evaluateCurve(const Vec3& p, double t) const;
  Vec3 position(double t) const;
  double levelParameter(double x, double y) const;
  double refineLevel(double x, double y, double t) const;
  /// Whether a search on a line ends on its proven bound, or already where the next step promises to gain
  /// less than the tolerance.
  enum class Search { kProven, kSettled };
  /// The place of the least value, on a line to within `tolerance`; `bound` receives a proven lower bound of
  /// the value. Where that is above `cutoff`, any place.
  Place minimise(const Vec3& p, double cutoff, double tolerance, double& bound, double start = kAnywhere,
                 Search search = Search::kProven) const;
  Place minimiseLine(const Vec3& p, double cutoff, double tolerance, double& bound, double start,
                     Search search) const;
  bool isSettled(const Vec3& p, const Place& place, double low, double high, double tolerance) const;
  double guessOnLine(const Vec3& p) const;
  double stepToEdge(const Vec3& p, const Place& from) const;
  double newtonStep(const Vec3& p, const Place& from) const;
  Place minimiseCurve(const Vec3& p, double cutoff, double tolerance, double& bound, double start) const;
  /// Newton's method: a step that promises to gain so many tolerances goes this much farther, and has to take
  /// away this much of the slope.
  static constexpr double kNear = 1000.0, kOvershoot = 1.1, kHelps = 0.5;

  struct CurveSearch;
  Box3 wayBounds(double a, double b) const;
  double boxBound(const Vec3& p, double a, double b) const;
  void slantedColumn(double x, double y, double z0, double dz, int count, const double* cutoff,
                     double* out) const;
  double ballGap(const Vec3& p, Vec3& from_center) const;
  double horizontalGap(double x, double y) const;
  double helixBound(const Vec3& p) const;

  const ConvexProfile* profile_;
  Kind kind_;
  Vec3 from_, delta_;
  double level_length2_ = 0.0, length2_ = 0.0;
  ArcGeometry arc_;
  ArcFrame frame_;
  bool vertical_ = false;         // the arc turns about z
  bool round_turns_ = false;      // and its radius is one, but for the rounding of a program's digits
  double curvature_bound_ = 0.0;  // upper bound of |c''(t)|, mm
  Box3 curve_bounds_;             // of the points of a curve; empty for lines, which are asked by the million
};

}  // namespace proveout
