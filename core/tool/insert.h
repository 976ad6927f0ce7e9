// Lathe inserts: the outline in the plane of the spindle axis.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/tool/convex_outline.h"
#include "core/tool/tip.h"

namespace proveout {

enum class InsertShape : std::uint8_t {
  kCorner,  ///< rhombic or triangular: a nose between a leading and a trailing edge
  kGroove,  ///< grooving and parting blade: a front edge between two corners
  kThread,  ///< symmetric tooth
  kRound    ///< button
};
std::string_view insertShapeName(
    InsertShape shape);  ///< "corner", "groove", "thread", "round": as in job files

/// Lengths mm, angles degrees. Directions: X grows away from the spindle axis, Z away from the chuck.
///
/// `orientation` says where the insert points to, and the touch-off point P lies, seen from the nose centre
/// S, as is usual on lathes: 1 (+X +Z), 2 (+X -Z), 3 (-X -Z), 4 (-X +Z), 5 (+Z), 6 (+X), 7 (-Z), 8 (-X). The
/// control point is P, or S for tools that are set up so (orientation 9 of tables of tools).
struct Insert {
  InsertShape shape = InsertShape::kCorner;
  int orientation = 3;
  bool at_center = false;    ///< the control point is S; `orientation` says where the insert points to
  double nose_radius = 0.0;  ///< >= 0; groove: of both corners; thread: of the tip; round: of the insert
  /// Corner: included angle of the corner, 0 < angle < 180 less lead angle; thread: of the tooth.
  double insert_angle_deg = 0.0;
  /// Corner, orientations 1 to 4: between the direction in which the insert feeds along Z (the Z of its
  /// orientation) and the leading edge, 0 < angle: 95 for a usual facing and turning tool. With 5 to 8 the
  /// corner is symmetric.
  double lead_angle_deg = 0.0;
  double edge_length =
      0.0;             ///< corner: of both edges; groove, thread: how far the blade reaches behind its front
  double width = 0.0;  ///< groove: of the front edge
  double side_relief_deg = 0.0;  ///< groove: by which each side falls back
  double tip_flat = 0.0;         ///< thread: width of the tip, in place of a nose radius
  /// (x, z) of what the machine counts from, seen from the control point: what the offsets of the tool have
  /// to make up for. None: the operator has measured right.
  std::optional<Vec2> gauge;
  /// Toolholder in the plane, any simple polygon of (x, z) seen from the control point; empty: none.
  std::vector<Vec2> holder;
};

/// Checks ranges and that the parts fit together. The message names the field.
Status validateInsert(const Insert& insert);

/// Outline with the control point at (0, 0), r being X. Requires validateInsert(insert).
ConvexOutline insertOutline(const Insert& insert);
/// Centre of the nose (groove: of the corner that the orientation names; thread with a flat: the middle of
/// the flat) seen from the control point, mm. Zero for tools with `at_center`.
Vec2 noseCenter(const Insert& insert);

/// The holder as convex pieces.
std::vector<ConvexOutline> holderPieces(const Insert& insert);
/// Of grooving and thread inserts, a thin strip where the edge ends, a little wider than the insert: what
/// holds the edge begins there, so that it must stay out of material. Nothing for others, whose backs are
/// sides.
std::optional<ConvexOutline> endOfEdge(const Insert& insert);

}  // namespace proveout
