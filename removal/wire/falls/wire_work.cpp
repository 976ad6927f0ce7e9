#include "removal/wire/falls/wire_work.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/assert.h"
#include "core/tool/tool_table.h"

namespace proveout {
namespace {

std::string placeOf(const Toolpath& path, const Motion& motion) {
  const std::string file =
      motion.source.file < path.files.size() ? path.files[motion.source.file] : std::string("the program");
  const std::string block = motion.source.block >= 0 ? fmt::format(" (N{})", motion.source.block) : "";
  return fmt::format("{}:{}{}", file, motion.source.line, block);
}

/// Calls visit(id, motion, sweep, tool) for each feed or rapid motion of a threaded wire.
template <typename Visit>
Status forEachWireMotion(const Toolpath& path, const std::vector<Tool>& tools, const Visit& visit) {
  const ToolTable table(tools);
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    const Motion& motion = path.motions[id];
    PROVEOUT_ASSERT(motion.wire < 0 || static_cast<std::size_t>(motion.wire) < path.wires.size());
    if (motion.wire < 0 || !path.wires[static_cast<std::size_t>(motion.wire)].state.threaded) continue;
    const Tool* tool = table.ofMotion(motion.tool);
    if (tool == nullptr)
      return inputError(
          fmt::format("{}: the job does not define tool {}", placeOf(path, motion), motion.tool));
    if (tool->type != ToolType::kWire)
      return inputError(fmt::format("{}: tool {} is no wire; give it type = \"wire\"", placeOf(path, motion),
                                    tool->number));
    if (motion.kind == MotionKind::kFeed || motion.kind == MotionKind::kRapid)
      visit(id, motion, path.wires[static_cast<std::size_t>(motion.wire)], *tool);
  }
  return Done{};
}

double kerfOf(const Tool& tool, const Motion& motion) {
  return 0.5 * tool.diameter + (motion.kind == MotionKind::kFeed ? tool.spark_gap : 0.0);
}

/// Leaves out stretches that go nowhere, if others join them.
void addMoving(const WireStretch& stretch, std::vector<WireStretch>& out) {
  const bool still = !stretch.isArc() && (stretch.to - stretch.from).norm() == 0.0;
  if (still && !out.empty() && (out.back().to - stretch.from).norm() == 0.0) return;
  out.push_back(stretch);
}

WireStretch asCircle(const LevelStretch& s) {
  WireStretch out;
  out.from = s.from;
  out.to = s.to;
  out.kerf_mm = s.radius_mm;
  out.motion = s.motion;
  return out;
}

}  // namespace

WireWork LeanWork::atHeight(const HeightSpan& span, double z) const {
  WireWork work;
  for (const LevelStretch& s : proveout::atHeight(cuts, span, z)) work.cuts.push_back(asCircle(s));
  for (const Rapid& rapid : rapids)
    work.rapids.push_back({asCircle(proveout::atHeight({rapid.stretch}, span, z).front()), rapid.after});
  return work;
}

bool standsUpright(const Toolpath& path) {
  return std::all_of(path.motions.begin(), path.motions.end(), [&](const Motion& motion) {
    if (motion.wire < 0) return true;
    PROVEOUT_ASSERT(static_cast<std::size_t>(motion.wire) < path.wires.size());
    const WireSweep& wire = path.wires[static_cast<std::size_t>(motion.wire)];
    return !wire.state.threaded || isUpright(wire);
  });
}

Result<WireWork> wireWork(const Toolpath& path, const std::vector<Tool>& tools) {
  WireWork work;
  std::vector<WireStretch> stretches;
  const Status good = forEachWireMotion(
      path, tools, [&](MotionId id, const Motion& motion, const WireSweep& wire, const Tool& tool) {
        stretches.clear();
        addStretches(wire.lower, kerfOf(tool, motion), id, stretches);
        for (const WireStretch& stretch : stretches) {
          if (motion.kind == MotionKind::kFeed)
            addMoving(stretch, work.cuts);
          else
            work.rapids.push_back({stretch, static_cast<std::uint32_t>(work.cuts.size())});
        }
      });
  if (!good) return good.error();
  return work;
}

Result<LeanWork> leanWork(const Toolpath& path, const std::vector<Tool>& tools, const HeightSpan& span,
                          double twist_mm) {
  LeanWork work;
  std::vector<LeanStretch> stretches;
  const Status good = forEachWireMotion(
      path, tools, [&](MotionId id, const Motion& motion, const WireSweep& wire, const Tool& tool) {
        if (motion.kind == MotionKind::kFeed) {
          addLeanStretches(wire, span, kerfOf(tool, motion), twist_mm, id, work.cuts);
          return;
        }
        stretches.clear();
        addLeanStretches(wire, span, kerfOf(tool, motion), twist_mm, id, stretches);
        for (const LeanStretch& stretch : stretches)
          work.rapids.push_back({stretch, static_cast<std::uint32_t>(work.cuts.size())});
      });
  if (!good) return good.error();
  return work;
}

}  // namespace proveout
