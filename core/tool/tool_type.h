// The types of tools: a row each, with all that differs from type to type.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/tool/profile.h"
#include "core/tool/tool.h"
#include "core/tool/tool_check.h"

namespace proveout {

/// Whether a type cuts over its own height, with a neck above that does not cut.
enum class ToolNeck {
  kNone,     ///< it cuts as far up as its flutes reach
  kNeeded,   ///< neck_diameter must be given
  kOptional  ///< neck_radius() stands in for it
};

/// Lengths mm, angles degrees. Where tools are handed in, validateTool() has seen them, but for check().
struct ToolTypeRow {
  ToolType type;
  std::string_view name;         ///< as in job files
  std::string_view option = {};  ///< what `--tool N=` takes, "bull:D:R"; empty: a job file is needed
  ToolNeck neck = ToolNeck::kNone;
  bool rotates = true;  ///< false: no solid of revolution, and no dimension of one

  /// Sets the dimensions from the numbers of the option. False: there are too few or too many. Null: without
  /// an option.
  bool (*set)(Tool&, std::span<const double>) = nullptr;
  /// Checks the dimensions that are the type's own; those of all types are good. Null: it has none.
  void (*check)(const Tool&, ToolCheck&) = nullptr;
  /// Height of the cutting part above the tip. Null: the flutes reach it.
  double (*height)(const Tool&) = nullptr;
  /// The cutting part of that height, tip at z = 0, as convex solids about +z. Null: it does not rotate.
  std::vector<ConvexProfile> (*cutter)(const Tool&, double height) = nullptr;
  /// Radius of the neck where the job gives none. Null: there is no neck then.
  double (*neck_radius)(const Tool&) = nullptr;
  /// Smallest radius of curvature of what it cuts, where no corner radius is given. Null: that of its
  /// diameter.
  double (*smallest_radius)(const Tool&) = nullptr;
  /// What a list says behind name and diameter; of a type that does not rotate behind nothing. Null: nothing.
  std::string (*details)(const Tool&) = nullptr;
};

/// All of them, in the order of ToolType.
std::span<const ToolTypeRow* const> toolTypes();
const ToolTypeRow& rowOf(ToolType type);

}  // namespace proveout
