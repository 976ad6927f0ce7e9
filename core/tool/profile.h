// Half-plane profiles of tools: what the sweep kernels turn about the tool axis.
#pragma once

#include <array>

namespace proveout {

/// Signed distance in the half-plane (r >= 0, z) with its gradient; negative inside.
struct ProfileSample {
  double value;   ///< mm
  double radius;  ///< of the curve of equal values through the point, mm; 0 where it is straight
  double gr, gz;  ///< unit gradient; at corners the direction away from the corner
  int element;    ///< id of the nearest element: its index + ConvexProfile::firstElementId()
};

/// A convex region of the half-plane r >= 0 whose mirror image joins it to a convex region: a convex solid of
/// revolution. The boundary runs from the lower end on the axis outwards, up and back to the axis (region on
/// the left).
class ConvexProfile {
 public:
  static constexpr int kMaxElements = 8;
  /// Above every element id; free for ids of the edges between elements.
  static constexpr int kEdgeIds = 1 << 14;

  /// A straight or round piece of the boundary, from a to b. dr > 0 or az < cz: it looks down; dr < 0 or
  /// bz > cz: it looks up (arcTo splits arcs at the height of their centre, so that no arc does both).
  struct Element {
    bool arc = false;
    double ar, az, br, bz;  // end points
    double dr, dz, length;  // unit direction (lines)
    double cr, cz, radius;  // arcs
  };

  /// Adds a straight element to (r, z). The first call of any add sets out from the start point.
  void start(double r, double z);
  void lineTo(double r, double z);
  /// Adds a convex arc about (center_r, center_z), counter-clockwise, to (r, z): two elements where it passes
  /// the height of its centre.
  void arcTo(double center_r, double center_z, double r, double z);

  /// Exact signed distance. Requires r >= 0.
  ProfileSample sample(double r, double z) const;

  double maxRadius() const { return max_radius_; }
  double zMin() const { return z_min_; }
  double zMax() const { return z_max_; }
  /// Radius of a ball end: a half sphere from the tip at z = 0 with a cylinder of its radius on it. A
  /// negative number where there is none, also for a ball with another flank.
  double ballCenter() const { return ball_center_; }
  int elementCount() const { return count_; }
  /// 0 <= i < elementCount(), from the lower end on the axis to the upper.
  const Element& element(int i) const { return elements_[i]; }

  /// Heights between which the solid lies at radius r, mm. Requires 0 <= r <= maxRadius(). The lower boundary
  /// is convex and does not fall with r, the upper is concave and does not rise.
  double lowerHeight(double r) const;
  double upperHeight(double r) const;

  /// Sets ids of several profiles of one tool apart, so that faces of different parts are not taken for one.
  void setFirstElementId(int id) { first_id_ = id; }
  int firstElementId() const { return first_id_; }

 private:
  std::array<Element, kMaxElements> elements_;
  int count_ = 0, first_id_ = 0;
  double r_ = 0.0, z_ = 0.0;
  bool cylinder_ = false;  ///< a flat end, a flank and a flat top
  double max_radius_ = 0.0, z_min_ = 0.0, z_max_ = 0.0, ball_center_ = -1.0;
  void extend(double r, double z);
  bool isCylinder() const;
  ProfileSample sampleCylinder(double r, double z) const;
  void addArc(double center_r, double center_z, double r, double z);
};

}  // namespace proveout
