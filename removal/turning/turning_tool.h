// A tool as a turning workpiece meets it: convex outlines in the plane of the spindle axis.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/tool/tool.h"
#include "removal/turning/section/sweep_paths.h"

namespace proveout {

struct TurningTool {
  explicit TurningTool(const Tool& tool);

  std::vector<ConvexOutline> cutters;
  std::vector<ConvexOutline> shank, holder;
  /// Of inserts: circles of the nose or the corners, which cut in any direction.
  std::vector<ConvexOutline> noses;
  bool insert = false;
  double lead_z =
      0.0;  ///< of a corner insert: sign of the Z direction that its leading edge looks to; 0: none
  std::shared_ptr<const ConvexOutline> thread;  ///< of inserts: the outline, for threads
  std::optional<ConvexOutline> end_of_edge;     ///< see endOfEdge()
  double nose_mm = 0.0;                         ///< of inserts: nose radius
  double points_r = 0.0;                        ///< of inserts: sign of the X direction that they point to
  double blade_mm = 0.0;                        ///< of grooving inserts: width of the front edge; else 0

  /// Whether an insert works on the far side of the axis (X below 0) on that way: it points to the axis from
  /// there, or is on that side with its holder. What it cuts is what its mirror image cuts on this side.
  bool worksBehind(const PlaneWay& way) const;
  /// The tool on the other side of the axis, half a turn on.
  TurningTool mirrored() const;

  /// All that cuts on the way.
  std::vector<SectionPath> swept(const PlaneWay& way) const;
  /// Where the edge of a blade or a tooth ends, on the way.
  std::vector<SectionPath> sweptEndOfEdge(const PlaneWay& way) const;
  /// Sides that must stay clear on the way, and what the cutting edges take on it.
  std::vector<SectionPath> sweptBacks(const PlaneWay& way) const;
  std::vector<SectionPath> sweptEdges(const PlaneWay& way) const;
};

}  // namespace proveout
