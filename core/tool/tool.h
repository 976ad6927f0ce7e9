// Cutting tools as solids of revolution about +z, tip at z = 0.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"

namespace proveout {

enum class ToolType { kFlat, kBall, kBull, kCone, kDrill };
std::string_view toolTypeName(ToolType type);  ///< "flat", "ball", ...

/// What the job or `--tool` says of a tool. Lengths mm, angles degrees.
struct Tool {
  int number = 0;
  std::string name;
  ToolType type = ToolType::kFlat;
  double diameter = 0.0;         ///< > 0, of the cutting part
  double corner_radius = 0.0;    ///< bull nose: 0 <= r <= diameter / 2
  double tip_diameter = 0.0;     ///< cone: flat tip, 0 <= tip_diameter < diameter
  double cone_angle_deg = 0.0;   ///< cone: included angle, 0 < angle < 180
  double point_angle_deg = 118;  ///< drill: included angle of the point, 0 < angle < 180
  double flute_length = 0.0;     ///< from the tip; 0: as long as the tool, or without limit if that is 0 too
  double overall_length = 0.0;   ///< tip to gauge line; 0: not given
  double shank_diameter = 0.0;   ///< 0: as the cutting diameter
  double gauge_length = 0.0;     ///< what a length offset has to make up for; see toolpath.h
  /// (height above gauge line, radius): solid of revolution that starts at overall_length. Empty: no holder.
  std::vector<Vec2> holder;
};

/// Checks ranges and that the parts fit together. The message names the tool and the field.
Status validateTool(const Tool& tool);

/// Parses the command line's `N=SHAPE` ("1=ball:3.175", "2=bull:10:2", "3=cone:6:0.2:60", "4=drill:5:118").
Result<Tool> parseToolOption(const std::string& text);

}  // namespace proveout
