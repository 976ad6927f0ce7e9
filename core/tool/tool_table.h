// Tools by number.
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

}  // namespace proveout
