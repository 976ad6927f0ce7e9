// Tools by number, and how they stand in the machine.
#pragma once

#include <span>

#include "core/tool/tool.h"

namespace proveout {

/// The tools of a clamping by their numbers: a view, to be made where it is asked. The list must outlive it.
/// Of tools with one number the first counts.
class ToolTable {
 public:
  explicit ToolTable(std::span<const Tool> tools) : tools_(tools) {}

  /// The tool with that number; null: there is none.
  const Tool* find(int number) const;
  /// What is taken to be in the spindle where nobody has named a tool: the one with the lowest number. Null:
  /// there are no tools.
  const Tool* unnamed() const;
  /// The tool that a motion is cut with which names `number`: 0, where no tool has it, stands for unnamed().
  /// Null: there is none.
  const Tool* ofMotion(int number) const;

 private:
  std::span<const Tool> tools_;
};

/// From a tool's control point to what the machine counts from, mm: what its offsets have to make up for.
Vec3 gaugeOf(const Tool& tool);

}  // namespace proveout
