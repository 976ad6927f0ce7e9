#include "app/session/findings/drill_moves.h"

#include <fmt/format.h>

#include <map>

#include "app/session/findings/accounting.h"
#include "app/session/findings/blame.h"
#include "core/tool/tool_table.h"

namespace proveout {
namespace {

/// A way across the axis is no rounding, mm, and no slight lean of a bore, as a share of the way along it.
constexpr double kLeastAcross = 0.01, kLean = 0.02;

bool goesSideways(const Toolpath& path, const Motion& motion) {
  const Box3 way = path.bounds(motion);
  const double across = way.size().head<2>().norm();
  return across > kLeastAcross && across > kLean * way.size().z();
}

struct Moves {
  MotionId first = kNoMotion;
  std::size_t count = 0;
  double length_mm = 0.0;
};

}  // namespace

void addDrillMoves(const Toolpath& path, const std::vector<float>& removed_mm3,
                   const std::vector<Tool>& tools, const RecordingSource& texts,
                   std::vector<Finding>& findings) {
  const ToolTable table(tools);
  std::map<int, Moves> by_tool;
  for (MotionId id = 0; id < path.motions.size() && id < removed_mm3.size(); ++id) {
    const Motion& motion = path.motions[id];
    const Tool* const tool = table.find(motion.tool);
    if (motion.kind != MotionKind::kFeed || tool == nullptr || tool->type != ToolType::kDrill) continue;
    const double length = path.length(motion);
    if (!goesSideways(path, motion) || !isChip(removed_mm3[id], length)) continue;
    Moves& moves = by_tool[motion.tool];
    if (moves.count++ == 0) moves.first = id;
    moves.length_mm += length;
  }
  for (const auto& [number, moves] : by_tool) {
    Finding finding(FindingKind::kDrillSideways);
    blame(finding, moves.first, path, texts);
    finding.where = path.motions[moves.first].to;
    finding.spots = moves.count;
    finding.message = fmt::format(
        "tool {} is a drill and is moved sideways through material, which only a mill can cut: {:.4g} mm of "
        "way in {} {}",
        number, moves.length_mm, moves.count, moves.count == 1 ? "motion" : "motions");
    findings.push_back(std::move(finding));
  }
}

}  // namespace proveout
