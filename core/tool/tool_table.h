// Tools by number, and how they stand in the machine.
#pragma once

#include <algorithm>
#include <vector>

#include "core/tool/tool.h"

namespace proveout {

/// The tool with that number; null: there is none.
inline const Tool* findTool(const std::vector<Tool>& tools, int number) {
  const auto found =
      std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return tool.number == number; });
  return found == tools.end() ? nullptr : &*found;
}

/// From a tool's control point to what the machine counts from, mm: what its offsets have to make up for.
inline Vec3 gaugeOf(const Tool& tool) {
  if (!tool.insert) return {0.0, 0.0, tool.gauge_length};
  const Vec2 gauge = tool.insert->gauge.value_or(Vec2::Zero());
  return {gauge.x(), 0.0, gauge.y()};
}

}  // namespace proveout
