#include "core/nc/stages/tool_change.h"

#include <algorithm>
#include <limits>

namespace proveout::nc {

std::vector<AxisPoint> toolChangeWay(const ControlSettings& settings, const AxisPoint& from, double ceiling) {
  const ToolChangePlace& place = settings.tool_change;
  double height = place.z.value_or(from[2]);
  if (place.by_default) {
    if (settings.limits[2]) ceiling = std::min(ceiling, settings.limits[2]->max);
    height = std::min(height, ceiling);
  }
  std::vector<AxisPoint> way;
  AxisPoint at = from;
  at[2] = std::max(height, from[2]);
  if (at[2] > from[2]) way.push_back(at);
  AxisPoint beside = at;
  beside[0] = place.x.value_or(at[0]);
  beside[1] = place.y.value_or(at[1]);
  if (!(beside == at)) way.push_back(beside);
  return way;
}

KindSet unsaidBehind(const ToolChangePlace& place) {
  KindSet kinds;
  if (place.z) kinds.add(OriginKind::kZ);
  if (place.x) kinds.add(OriginKind::kX);
  if (place.y) kinds.add(OriginKind::kY);
  return kinds;
}

bool goToToolChange(const ControlSettings& settings, const ToolChangeParts& parts, const WorkPlane& plane,
                    const SourceRef& source, AxisPoint& machine, bool& moves) {
  const ToolChangePlace& place = settings.tool_change;
  moves = false;
  if (!place.any()) return true;
  if (!parts.pipe.flush(FlushReason::kBuffer)) return false;
  const auto way = toolChangeWay(settings, parts.emitter.machine(), std::numeric_limits<double>::infinity());
  if (way.empty()) return true;
  moves = true;
  parts.recorder.clear(unsaidBehind(place));
  for (const AxisPoint& to : way) {
    PathItem item;
    item.kind = PathItem::Kind::kLine;
    item.space = PathItem::Space::kMachine;
    item.rapid = true;
    item.feed.join.stops = true;
    item.plane = plane;
    item.to = to;
    item.source = source;
    item.source.origins = parts.recorder.index();
    if (!parts.pipe.push(item)) return false;
  }
  // Beside cutter compensation the programmed point is not the machine's: axes that stayed keep it.
  machine[2] = way.back()[2];
  if (place.x) machine[0] = *place.x;
  if (place.y) machine[1] = *place.y;
  parts.pipe.rebase(machine, plane);
  return true;
}

}  // namespace proveout::nc
