#include "app/session/programs/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/session/programs/placed_path.h"
#include "app/session/run/process.h"
#include "core/tool/tool_table.h"

namespace proveout {
namespace {

/// How far an insert that points outwards, and its bar, reach towards the chuck, mm. Others stay beside the
/// blank.
double insertReach(const Insert& insert) {
  Vec2 low = insertOutline(insert).min();
  for (const Vec2& p : insert.holder) low = low.cwiseMin(p);
  return low.x() > -kTurningClearanceMm ? 0.0 : std::max(0.0, -low.y());
}

bool anyGaugeLength(const std::vector<Tool>& tools) {
  return std::any_of(tools.begin(), tools.end(), [](const Tool& tool) { return tool.gauge_length != 0.0; });
}

/// How far inserts reach in front of what the machine counts from, along X and Z.
Vec3 insertGauges(const std::vector<Tool>& tools) {
  Vec3 most = Vec3::Zero();
  for (const Tool& tool : tools) {
    if (tool.insert) most = most.cwiseMax(gaugeOf(tool));
  }
  return most;
}

const Tool* longestTool(const std::vector<Tool>& tools) {
  const auto longest = std::max_element(tools.begin(), tools.end(), [](const Tool& a, const Tool& b) {
    return a.gauge_length < b.gauge_length;
  });
  return longest == tools.end() ? nullptr : &*longest;
}

double originHeight(const ControlSettings& settings) { return workpieceZero(settings).z(); }

/// Whether a tool that stands at `tip` cuts into the shape; `radius`: of the tool, 0 for inserts.
bool standsIn(const StockShape& shape, const Vec3& tip, double radius) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    const double x = std::max({box->min.x() - tip.x(), tip.x() - box->max.x(), 0.0});
    const double y = std::max({box->min.y() - tip.y(), tip.y() - box->max.y(), 0.0});
    return tip.z() < box->max.z() && (x > 0.0 || y > 0.0 ? std::hypot(x, y) < radius : true);
  }
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (cylinder == nullptr) return false;
  if (cylinder->axis != 2) {
    Vec3 reach = Vec3::Constant(cylinder->radius);
    reach[cylinder->axis] = 0.0;
    Vec3 end = cylinder->base;
    end[cylinder->axis] += cylinder->length;
    return standsIn(BoxShape{cylinder->base - reach, end + reach}, tip, radius);
  }
  const double r = (tip - cylinder->base).head<2>().norm();
  const bool in_hole = cylinder->inner_radius > 0.0 && r + radius <= cylinder->inner_radius;
  return tip.z() < cylinder->base.z() + cylinder->length && r < cylinder->radius + radius && !in_hole;
}

}  // namespace

double toolReach(const std::vector<Tool>& tools) {
  const bool gauged = anyGaugeLength(tools);
  double reach = 0.0;
  for (const Tool& tool : tools) {
    if (tool.insert) {
      reach = std::max(reach, insertReach(*tool.insert));
    } else if (gauged) {
      reach = std::max({reach, tool.gauge_length, tool.overall_length});
    }
  }
  return reach;
}

void placeMachine(const Job& job, const Box3& blank, ControlSettings& settings) {
  const Process& process = processOf(job.control);
  const double reach = toolReach(job.tools);
  const ToolTable tools(job.tools);
  const Tool* unnamed = tools.unnamed();
  settings.unnamed_gauge = unnamed == nullptr ? Vec3(Vec3::Zero()) : gaugeOf(*unnamed);
  Vec3 start = process.start(blank);
  start.z() += reach;
  start += insertGauges(job.tools);
  if (!settings.tool_change.any() && (process.always_changes_tool || anyGaugeLength(job.tools))) {
    settings.tool_change.z = start.z() + originHeight(settings);
    settings.tool_change.by_default = true;
  }
  settings.start_by_default = !job.start;
  if (settings.limits[2]) start.z() = std::min(start.z(), settings.limits[2]->max - originHeight(settings));
  const Tool* named = tools.find(settings.tool);
  if (settings.tool == 0) {
    start -= settings.unnamed_gauge;
  } else if (named != nullptr) {
    start -= gaugeOf(*named);
  }
  settings.start = job.start.value_or(start);
}

ToolChangePlace placeInChannel(const ControlSettings& control, const ControlSettings& channel) {
  ToolChangePlace place = control.tool_change;
  if (place.by_default && place.z) *place.z += originHeight(channel) - originHeight(control);
  return place;
}

Status checkToolChange(const Job& job, const Blank& blank) {
  const ToolChangePlace& place = job.settings.tool_change;
  if (!place.x || !place.y || !place.z) return Done{};
  const RigidTransform into = machineIntoWorkpiece(job.settings);
  for (const Tool& tool : job.tools) {
    const Vec3 tip = into(Vec3(*place.x, *place.y, *place.z)) - gaugeOf(tool);
    if (!standsIn(blank.shape, tip, 0.5 * tool.diameter)) continue;
    return inputError(
        fmt::format("at the place of the tool change, X{:g} Y{:g} Z{:g} (machine frame), the tip of tool {} "
                    "would stand in "
                    "the blank, at X{:g} Y{:g} Z{:g} of the workpiece; take it higher or beside the blank",
                    *place.x, *place.y, *place.z, tool.number, tip.x(), tip.y(), tip.z()));
  }
  return Done{};
}

void noteLowToolChange(const Job& job, const Box3& blank, Diagnostics& diagnostics) {
  const ToolChangePlace& place = job.settings.tool_change;
  const Tool* longest = longestTool(job.tools);
  if (!place.z || (place.x && place.y) || longest == nullptr) return;
  const double tip = *place.z - originHeight(job.settings) - longest->gauge_length;
  if (tip >= blank.max.z()) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.code = "tool-change";
  warning.message = fmt::format(
      "at the height of the tool change, Z{:g} (machine frame), tool {} reaches down to Z{:g} of the "
      "workpiece, "
      "below the top of the blank at Z{:g}",
      *place.z, longest->number, tip, blank.max.z());
  diagnostics.add(std::move(warning));
}

}  // namespace proveout
