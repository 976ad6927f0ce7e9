#include "core/tool/tool_table.h"

#include <algorithm>

namespace proveout {

const Tool* ToolTable::find(int number) const {
  const auto found =
      std::find_if(tools_.begin(), tools_.end(), [&](const Tool& tool) { return tool.number == number; });
  return found == tools_.end() ? nullptr : &*found;
}

const Tool* ToolTable::unnamed() const {
  const auto lowest = std::min_element(tools_.begin(), tools_.end(),
                                       [](const Tool& a, const Tool& b) { return a.number < b.number; });
  return lowest == tools_.end() ? nullptr : &*lowest;
}

const Tool* ToolTable::ofMotion(int number) const {
  const Tool* tool = find(number);
  return tool == nullptr && number == 0 ? unnamed() : tool;
}

Vec3 gaugeOf(const Tool& tool) {
  if (!tool.insert) return {0.0, 0.0, tool.gauge_length};
  const Vec2 gauge = tool.insert->gauge.value_or(Vec2::Zero());
  return {gauge.x(), 0.0, gauge.y()};
}

}  // namespace proveout
