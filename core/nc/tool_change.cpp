#include "core/nc/tool_change.h"

#include <algorithm>

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

}  // namespace proveout::nc
