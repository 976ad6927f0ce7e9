// A machine as it is built: axes, what carries what, the spindle, bodies. Plain data.
//
// Machine frame: right-handed, mm. A coordinate is 0 where its axis is said to be at 0. All directions and
// points below are those with all axes at 0.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// Travel limits of one axis, machine coordinates, mm or deg.
struct AxisLimit {
  double min = 0.0;
  double max = 0.0;
};

enum class AxisKind : std::uint8_t { kLinear, kRotary };

/// What an axis carries in the end.
enum class AxisSide : std::uint8_t {
  kTool,    ///< it moves the tool: a slide, a head
  kPart,    ///< it moves the part: a table
  kNothing  ///< its position is only told
};

/// What an axis or the spindle stands on: the index of an axis, or the bed.
inline constexpr int kOnBed = -1;

struct MachineAxis {
  std::string name;  ///< "X", "A", "Z1": upper case
  AxisKind kind = AxisKind::kLinear;
  AxisSide side = AxisSide::kTool;
  int on = kOnBed;  ///< of the same side
  Vec3 direction =
      Vec3::UnitZ();  ///< unit. Linear: the tool goes so as seen from the part, whatever the axis moves
  Vec3 point = Vec3::Zero();  ///< rotary: a point of the axis, mm
  bool left = false;  ///< rotary: a positive angle turns what it carries left-handed about `direction`
  std::optional<AxisLimit> travel;  ///< without: endless
  double rapid = 15000.0;           ///< mm/min or deg/min, > 0
  double acceleration = 0.0;        ///< mm/s^2 or deg/s^2; 0: it reaches its speed at once
  double start = 0.0;               ///< position at power-on, mm or deg
  double reference = 0.0;           ///< of the reference points, mm or deg
  bool clamped = false;             ///< it stands still while a tool cuts
  double step = 0.0;                ///< deg; > 0: it stands at whole multiples only (teeth)
};

/// Where the tool's gauge point is.
struct SpindleMount {
  int on = kOnBed;                 ///< an axis that carries the tool
  Vec3 gauge = Vec3::Zero();       ///< gauge point, seen from the control point, mm
  Vec3 direction = Vec3::UnitZ();  ///< of the tool, unit, from its tip to its holder
};

/// Something that moves with an axis and must not meet others.
struct MachineBody {
  struct Box {
    Vec3 min, max;
  };
  struct Cylinder {
    Vec3 from, to;
    double radius = 0.0;
  };
  std::string name;
  int on = kOnBed;
  std::variant<std::string, Box, Cylinder> shape;  ///< a mesh file, or a simple body, machine frame, mm
  std::vector<std::string> watch;                  ///< names of bodies, "spindle", "holder", "tool"
};

/// The axes X, Y and Z come first, the others as the file has them: the order of AxisPoint.
struct MachineModel {
  std::string name;
  std::vector<MachineAxis> axes;
  SpindleMount spindle;
  std::vector<MachineBody> bodies;

  /// Index of the axis of that name, or -1.
  int find(const std::string& axis_name) const {
    for (std::size_t k = 0; k < axes.size(); ++k) {
      if (axes[k].name == axis_name) return static_cast<int>(k);
    }
    return -1;
  }
};

/// Whether an axis may have this name (nct manual, 2.2): X Y Z U V W A B or C, then up to two letters or
/// digits; AX and AXN are taken.
bool isAxisName(std::string_view name);
/// What is told of another name.
std::string axisNameFault(std::string_view name);

/// Why this can be no machine: an axis on one that is not there or in a loop, tool and part side mixed, a
/// direction of length 0, travel with low above high, a step that does not divide the travel, names twice, X,
/// Y or Z missing.
struct MachineFault {
  int axis = -1;         ///< index; -1: the spindle
  const char* key = "";  ///< of the machine file
  std::string text;
};
/// All faults of a machine's axes and its spindle; empty: it can be.
std::vector<MachineFault> machineFaults(const MachineModel& model);

}  // namespace proveout
