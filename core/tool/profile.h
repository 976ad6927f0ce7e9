// Half-plane profiles of tools: what the sweep kernels turn about the tool axis.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/tool/tool.h"

namespace proveout {

/// Signed distance in the half-plane (r >= 0, z) with its gradient; negative inside.
struct ProfileSample {
  double value;   ///< mm
  double gr, gz;  ///< unit gradient; at corners the direction away from the corner
  int element;    ///< index of the nearest element
};

/// A convex region of the half-plane r >= 0 whose mirror image joins it to a convex region: a convex solid of
/// revolution. The boundary runs from the lower end on the axis outwards, up and back to the axis (region on
/// the left).
class ConvexProfile {
 public:
  static constexpr int kMaxElements = 6;

  /// A straight or round piece of the boundary, from a to b.
  struct Element {
    bool arc = false;
    double ar, az, br, bz;  // end points
    double dr, dz, length;  // unit direction (lines)
    double cr, cz, radius;  // arcs
  };

  /// Adds a straight element to (r, z). The first call of any add sets out from the start point.
  void start(double r, double z);
  void lineTo(double r, double z);
  /// Adds a convex arc about (center_r, center_z), counter-clockwise, to (r, z).
  void arcTo(double center_r, double center_z, double r, double z);

  /// Exact signed distance. Requires r >= 0.
  ProfileSample sample(double r, double z) const;

  double maxRadius() const { return max_radius_; }
  double zMin() const { return z_min_; }
  double zMax() const { return z_max_; }
  /// Height of the centre of a lower spherical end, or a negative number where there is none.
  double ballCenter() const { return ball_center_; }
  int elementCount() const { return count_; }
  const Element& element(int i) const { return elements_[i]; }

 private:
  std::array<Element, kMaxElements> elements_;
  int count_ = 0;
  double r_ = 0.0, z_ = 0.0;
  double max_radius_ = 0.0, z_min_ = 0.0, z_max_ = 0.0, ball_center_ = -1.0;
  void extend(double r, double z);
};

/// The parts of a tool, tip at z = 0, each a convex solid of revolution.
struct ToolSolid {
  ConvexProfile cutter;
  std::vector<ConvexProfile> shank;   ///< none or one
  std::vector<ConvexProfile> holder;  ///< one per section of the polyline
};

/// Length of flutes that stands for "without limit", mm.
inline constexpr double kUnlimitedFluteMm = 2000.0;

/// Requires validateTool(tool).
ToolSolid makeToolSolid(const Tool& tool);

}  // namespace proveout
