// Cutting tools as solids of revolution about +z, tip at z = 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/tool/insert.h"
#include "core/tool/outline.h"

namespace proveout {

enum class ToolType {
  kFlat,
  kBall,
  kBull,
  kCone,
  kDrill,
  kTaperBall,   ///< ball nose with a conical flank that touches the ball
  kDovetail,    ///< widest at the bottom, flank leaning inwards
  kTSlot,       ///< disc on a neck
  kLollipop,    ///< ball on a neck
  kThreadMill,  ///< rings of thread teeth, without lead
  kForm,        ///< free outline
  kInsert,      ///< lathe insert: no solid of revolution
  kWire         ///< of wire erosion: no solid of revolution
};
std::string_view toolTypeName(ToolType type);  ///< "flat", "ball", ...: as in job files
std::optional<ToolType> toolTypeOf(std::string_view name);

/// What the job or `--tool` says of a tool. Lengths mm, angles degrees.
struct Tool {
  int number = 0;
  std::string name;
  ToolType type = ToolType::kFlat;
  double diameter =
      0.0;  ///< > 0, the largest of the cutting part; form: see outlineDiameter(); wire: its own
  double corner_radius =
      0.0;  ///< bull nose, dovetail (bottom), T-slot (bottom and top); 0 <= r <= diameter / 2
  double tip_diameter = 0.0;        ///< cone: flat tip, taper ball: the ball; 0 <= tip_diameter < diameter
  double cone_angle_deg = 0.0;      ///< cone, taper ball: included angle, 0 < angle < 180
  double point_angle_deg = 118;     ///< drill: included angle of the point, 0 < angle < 180
  double dovetail_angle_deg = 0.0;  ///< dovetail: between bottom and flank, 0 < angle < 90
  double cutter_height = 0.0;       ///< dovetail: height, T-slot: thickness of the cutting part, > 0
  double pitch = 0.0;               ///< thread mill: distance of the teeth, > 0
  int teeth = 1;                    ///< thread mill: rings of teeth, one above the other
  double thread_angle_deg = 60.0;   ///< thread mill: included angle of a tooth, 0 < angle < 180
  double crest_flat = 0.0;          ///< thread mill: width of the flat on a tooth
  double root_diameter =
      0.0;  ///< thread mill: between the teeth; 0: where the flanks of teeth a pitch apart meet
  std::vector<OutlinePoint> outline;  ///< form
  std::optional<Insert> insert;       ///< insert; none of the lengths and diameters here has a meaning then
  double spark_gap = 0.0;             ///< wire: from its surface to what it leaves, >= 0
  double flute_length = 0.0;    ///< from the tip; 0: as long as the tool, or without limit if that is 0 too.
                                ///< Types with a neck and forms cut over their own height instead.
  double overall_length = 0.0;  ///< tip to gauge line; 0: not given
  /// Dovetail, T-slot, lollipop, thread mill, form: what is above the cutting part and does not cut. Thread
  /// mill: 0 is the root diameter; form: 0 is no neck; the others need it.
  double neck_diameter = 0.0;
  double neck_length = 0.0;     ///< from the tip to where the shank begins; 0: up to overall_length
  double shank_diameter = 0.0;  ///< 0: as the cutting diameter; form: as its last point
  bool left_hand = false;       ///< cuts while the spindle turns counter-clockwise (M4)
  double gauge_length = 0.0;    ///< what a length offset has to make up for; see toolpath.h
  /// (height above gauge line, radius): solid of revolution that starts at overall_length. Empty: no holder.
  std::vector<Vec2> holder;
};

/// Checks ranges and that the parts fit together. The message names the tool and the field.
Status validateTool(const Tool& tool);

/// True for the types that cut over their own height, with a neck above it.
bool hasNeck(ToolType type);

/// Height of the cutting part above the tip, mm; kUnlimitedFluteMm where nothing limits it. Requires
/// validateTool(tool).
double cutterTop(const Tool& tool);
/// Length of flutes that stands for "without limit", mm.
inline constexpr double kUnlimitedFluteMm = 2000.0;

/// Of the surface that it leaves, mm: of a corner or a tip, else of the diameter. 0 for inserts.
double smallestRadius(const Tool& tool);

/// For lists: "bull 10 r2", "drill 5 118 deg".
std::string describe(const Tool& tool);

/// Outline of a thread mill's teeth from the tip up: `teeth` rings, a pitch apart, the lowest on the tip.
/// Requires validateTool(tool).
std::vector<OutlinePoint> threadOutline(const Tool& tool);

/// Diameter between the teeth of a thread mill, mm; at most 0 if the pitch is too large for the diameter.
double rootDiameter(const Tool& tool);

/// Parses the command line's `N=SHAPE` ("1=ball:3.175", "2=bull:10:2", "3=cone:6:0.2:60", "4=drill:5:118").
/// Forms and what goes beyond a shape's main figures need a job file.
Result<Tool> parseToolOption(const std::string& text);

}  // namespace proveout
