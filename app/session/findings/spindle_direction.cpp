#include "app/session/findings/spindle_direction.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "app/session/findings/accounting.h"
#include "app/session/findings/blame.h"
#include "app/session/findings/spindle_watch.h"
#include "core/tool/tool_table.h"

namespace proveout {
namespace {

bool turnsBackwards(const Motion& motion, const Tool& tool) {
  return tool.left_hand ? motion.spindle > 0.0 : motion.spindle < 0.0;
}

}  // namespace

void addSpindleDirection(const Toolpath& path, const std::vector<float>& removed_mm3,
                         const std::vector<Tool>& tools, const RecordingSource& texts,
                         std::vector<Finding>& findings) {
  const ToolTable table(tools);
  SpindleWatch starts(path);
  std::set<std::pair<int, const PathEvent*>> told;
  for (MotionId id = 0; id < path.motions.size() && id < removed_mm3.size(); ++id) {
    const Motion& motion = path.motions[id];
    const PathEvent* const start = starts.before(id);
    const Tool* const tool = table.find(motion.tool);
    if (motion.kind != MotionKind::kFeed || tool == nullptr || tool->insert) continue;
    if (!turnsBackwards(motion, *tool) || !isChip(removed_mm3[id], path.length(motion))) continue;
    if (!told.emplace(motion.tool, start).second) continue;
    Finding finding(FindingKind::kSpindleDirection);
    blame(finding, id, path, texts);
    finding.where = motion.to;
    const std::string cut =
        finding.source ? fmt::format("{}:{}", finding.source->file, finding.source->line) : std::string();
    if (start != nullptr) finding.source = blockRef(path, start->source, texts);
    finding.message = fmt::format(
        "the spindle turns {} here, and tool {}, which is a {}-hand cutter, cuts with it from {} on",
        motion.spindle < 0.0 ? "counter-clockwise (M4)" : "clockwise (M3)", motion.tool,
        tool->left_hand ? "left" : "right", cut);
    findings.push_back(std::move(finding));
  }
}

}  // namespace proveout
