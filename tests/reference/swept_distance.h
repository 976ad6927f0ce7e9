// How far points are from what a program removes, without facets. All mm.
#pragma once

#include <vector>

#include "tests/reference/cutter_section.h"
#include "tests/reference/small_program.h"

namespace proveout::reference {

/// What one convex part of a cutter sweeps during one motion, found by searching for the nearest place on its
/// way.
class SweptPart {
 public:
  SweptPart(Section section, const Toolpath& path, const Motion& motion);

  /// Below 0 inside; outside it is the distance, inside no more than it.
  double distance(const Vec3& p) const;
  /// No more than `distance` where that is above 0.
  double atLeast(const Vec3& p) const;

 private:
  double at(const Vec3& p, double t) const;
  Vec3 tip(double t) const;

  Section section_;
  Motion motion_;
  const Toolpath* path_;
  Vec3 low_, high_;  ///< it is between them
};

/// The part that a program leaves: the block less all that is swept.
class ExactPart {
 public:
  explicit ExactPart(const SmallProgram& program);

  /// Below 0 in the material. Near the surface it is the distance to it, but beside edges that bulge out.
  double distance(const Vec3& p) const;
  /// How far `p` is from the surface, where it is near: the value over its slope.
  double off(const Vec3& p) const;
  /// The place near `p` at which two of the surfaces meet, or one breaks; `p` itself where none is found.
  /// `normal`: unit, out of the material.
  Vec3 onEdge(const Vec3& p, const Vec3& normal) const;

 private:
  SmallProgram program_;
  std::vector<SweptPart> parts_;
};

}  // namespace proveout::reference
