// A block to be milled, and what a run says of it: jobs for tests of programs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/session/session.h"

namespace proveout::app_test {

inline Tool toolOf(int number, double diameter, ToolType type = ToolType::kFlat) {
  Tool tool;
  tool.number = number;
  tool.diameter = diameter;
  tool.type = type;
  return tool;
}

/// For nct, on a grid of 0.5 mm. The block begins at X0 Y0, its top is Z0.
inline Job blockJob(const std::string& name, const Vec3& size, std::vector<Tool> tools) {
  Job job;
  job.name = name;
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -size.z()}, {size.x(), size.y(), 0}};
  job.tools = std::move(tools);
  job.simulation.resolution_mm = 0.5;
  return job;
}

inline std::vector<Finding> ofKind(const std::vector<Finding>& all, FindingKind kind) {
  std::vector<Finding> found;
  for (const Finding& finding : all) {
    if (finding.kind == kind) found.push_back(finding);
  }
  return found;
}

}  // namespace proveout::app_test
