#include "app/session/causes/wire_offset.h"

#include <cmath>

#include "core/tool/tool_table.h"

namespace proveout {
namespace {

/// A deviation within this share of half the kerf is about that.
constexpr double kAbout = 0.3;

}  // namespace

std::optional<double> halfKerf(const Toolpath& path, const std::vector<Tool>& tools, MotionId motion) {
  if (motion >= path.motions.size()) return std::nullopt;
  const Motion& m = path.motions[motion];
  const Tool* tool = ToolTable(tools).ofMotion(m.tool);
  if (m.wire < 0 || m.kind != MotionKind::kFeed || tool == nullptr) return std::nullopt;
  return 0.5 * tool->diameter + tool->spark_gap;
}

bool followsContour(const Toolpath& path, const std::vector<Tool>& tools, MotionId motion, double off_mm) {
  const std::optional<double> kerf = halfKerf(path, tools, motion);
  return kerf && !path.motions[motion].compensated && std::abs(off_mm - *kerf) <= kAbout * *kerf;
}

}  // namespace proveout
