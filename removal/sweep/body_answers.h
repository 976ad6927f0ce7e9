// What bodies answer: surfaces, cuts, places.
#pragma once

#include "core/geometry/types.h"
#include "removal/sweep/swept_field.h"

namespace proveout {

/// The surface of a swept volume at a point.
struct SweptSurface {
  Vec3 normal;  ///< unit, away from the swept volume
  int element;  ///< as SweepSample::element
};

/// Where an edge enters a volume.
struct EdgeCut {
  double at;            ///< distance from its end, mm
  double start = -1.0;  ///< about the parameter of the motion whose tool is there; below 0: not known
};

/// A place of an upright tool on its way.
struct ToolPlace {
  Vec3 at;       ///< tip, mm
  Vec2 forward;  ///< unit
};

/// A place where the edge from `a` along a unit direction goes into the volume, by the root of the exact
/// distance; as SweptBody::levelCut.
double searchCut(const SweptField& field, const Vec3& a, const Vec3& direction, double inside);

}  // namespace proveout
