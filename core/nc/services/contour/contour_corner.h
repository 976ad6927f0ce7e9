// Chamfers and roundings between two elements of a contour. Rules: NCT milling manual 17.1 (digest
// nct-3, 5.1).
#pragma once

#include "core/geometry/types.h"

namespace proveout {

/// A line or an arc in the plane (u, v), mm.
struct ContourElement {
  bool arc = false;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  Vec2 center = Vec2::Zero();  ///< of arcs only
  double sweep = 0.0;          ///< rad, signed, > 0 counter-clockwise; of arcs only
  int source = -1;             ///< the caller's number of what it is a part of
};

/// What stands between the two elements.
struct CornerJoin {
  bool none = false;          ///< the elements are tangent: nothing is inserted
  Vec2 leave = Vec2::Zero();  ///< new end of the first element
  Vec2 enter = Vec2::Zero();  ///< new start of the second
  bool arc = false;           ///< from leave to enter by an arc, else straight
  Vec2 center = Vec2::Zero();
  double sweep = 0.0;
};

enum class CornerError {
  kNone,
  kNoDirection,  ///< an element without displacement, or an input that is not finite
  kTooLarge,     ///< does not fit the two elements
};

/// A straight piece between the points at distance `length` (on arcs: as a chord) from the corner.
CornerError chamferCorner(const ContourElement& first, const ContourElement& second, double length,
                          CornerJoin& join);
/// An arc tangent to both elements.
CornerError roundCorner(const ContourElement& first, const ContourElement& second, double radius,
                        CornerJoin& join);

/// Angle from the start of the arc to `p` in the arc's own direction, 0 to a full turn.
double sweepUntil(const ContourElement& arc, const Vec2& p);
/// Angle from `p` to the end of the arc in the arc's own direction, 0 to a full turn.
double sweepFrom(const ContourElement& arc, const Vec2& p);

}  // namespace proveout
