// Tools as unions of convex solids of revolution: what is moved through the stock.
#pragma once

#include <vector>

#include "core/tool/profile.h"
#include "core/tool/tool.h"

namespace proveout {

/// The parts of a tool, tip at z = 0, each a convex solid of revolution about +z.
struct ToolSolid {
  /// What cuts: the union of these. One for every type whose outline is convex. Parts that meet overlap, so
  /// that no gap opens between them by rounding; their element ids differ.
  std::vector<ConvexProfile> cutter;
  std::vector<ConvexProfile> shank;   ///< neck and shank: none, one or two
  std::vector<ConvexProfile> holder;  ///< one per section of the polyline
};

/// Requires validateTool(tool) and a type that rotates.
ToolSolid makeToolSolid(const Tool& tool);

/// Of all parts, mm.
Box3 boundsOf(const ToolSolid& solid);

}  // namespace proveout
