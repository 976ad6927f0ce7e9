// A contour as a profile over one axis of its plane (u, v): where it crosses a level, and what of it lies
// below one. For passes of one depth after the other.
#pragma once

#include <cstddef>
#include <vector>

#include "core/nc/services/contour/contour_elements.h"

namespace proveout {

/// The way along the contour is one parameter, 0 to length(). Levels are heights over the axis across the
/// passes, mm, higher towards the tool.
class ContourProfile {
 public:
  /// A stretch of the way.
  struct Zone {
    double a, b;
  };

  /// `contour` is not empty and must outlive the profile. `depth_axis`: the coordinate that levels count
  /// along, 0: u, 1: v. `side`: +1 where the tool is towards larger values of it, else -1.
  ContourProfile(const PlaneContour& contour, int depth_axis, double side);

  double length() const { return static_cast<double>(stretches_.size()); }
  Vec2 at(double t) const;
  /// The ContourElement::source there.
  int sourceAt(double t) const;
  double level(const Vec2& p) const { return side_ * p[depth_axis_]; }
  /// Coordinate of the depth axis at a level.
  double coordinate(double level) const { return side_ * level; }

  /// The longest stretches of the zone below a level, in order; what is less than 1e-6 mm below it counts as
  /// on it.
  std::vector<Zone> zonesBelow(const Zone& zone, double height) const;
  /// Level of the lowest point of the zone.
  double lowest(const Zone& zone) const;
  /// The contour between two parameters, one piece of an element each.
  PlaneContour between(double a, double b) const;

 private:
  /// A stretch of an element on which both coordinates go one way.
  struct Monotone {
    std::size_t element;
    double t0, t1;
  };

  void split(std::size_t k);
  std::size_t stretchAt(double t) const;
  double partAt(double t, std::size_t stretch) const;
  double crossing(double a, double b, double height) const;

  const PlaneContour& contour_;
  const int depth_axis_;
  const double side_;
  std::vector<Monotone> stretches_;
};

}  // namespace proveout
