// What a block of the nct control may change and that stays: modal codes and words.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/nc/iso/model/axis_modal.h"
#include "core/nc/iso/model/code_names.h"
#include "core/nc/iso/model/codes.h"
#include "core/nc/iso/model/held_way.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/kinematics/frames.h"
#include "core/nc/kinematics/program_transforms.h"
#include "core/nc/services/plane_frame.h"

namespace proveout::nc {

/// Words of a drilling cycle that stay in force until the cycle ends. Lengths mm, raw as programmed.
struct CycleWords {
  std::optional<double> r, bottom;
  bool r_incremental = false, bottom_incremental = false;
  double initial = 0.0;  ///< drill axis, program coordinates, at entry
  int drill_axis = 2;
  double peck = 0.0;
  std::optional<double> clearance;
  double dwell = 0.0;
  std::array<double, 3> shift{};  ///< I, J, K, mm
  std::optional<double> retract_percent;
};

/// Tapping without a floating chuck where a function of its own asks for it (M29 of Fanuc-like controls):
/// off, asked for, in force in a tapping cycle.
enum class RigidTap : std::int8_t { kOff, kAsked, kOn };

/// Last words that variables tell of and nothing else keeps (#4101 to #4130).
struct LastWords {
  double e = 0.0;
  std::int64_t n = 0;
  std::int32_t m = 0;
  std::int32_t extended_system = 0;   ///< P of G54.1
  std::array<double, 3> auxiliary{};  ///< auxiliary functions (N1333 to N1335)
};

/// What programs suppress in automatic mode (#3003, #3004).
struct AutomaticBits {
  bool no_single_block = false;
  bool no_stop = false;      ///< STOP key
  bool no_override = false;  ///< override and STOP key
  bool no_exact_stop = false;
};

/// Tool centre point control: off, with angles of the rotary axes (G43.4), with directions (G43.5).
enum class TipControl : std::int8_t { kOff, kAngles, kVector };

/// Tilted planes and what follows the rotary axes (manual chapter 25).
struct FiveAxisState {
  FrameStep tilt;                ///< of G68.1, G68.2: from programmed to workpiece coordinates
  std::int8_t rotations = 0;     ///< G68.1 in force, one or two
  bool tilted = false;           ///< G68.2 is in force
  bool on_table = false;         ///< the coordinates turn with the tables: since G53.1
  bool along_tool = false;       ///< the length offset follows the heads: G43.1, and G43 since G53.1
  std::int8_t dynamic_zero = 0;  ///< P of G54.2; 0: it is off
  TipControl tip = TipControl::kOff;
  bool shank = false;  ///< P1 of G43.4, G43.5
  /// Do the coordinates turn with the tables?
  bool turnsWithTable() const { return on_table || tip != TipControl::kOff; }
  /// What belongs to the length code goes with it.
  void endLength() {
    along_tool = shank = false;
    tip = TipControl::kOff;
  }
  bool any() const { return rotations > 0 || tilted || on_table || follows(); }
  /// Do the coordinates depend on where the rotary axes are?
  bool follows() const { return turnsWithTable() || along_tool || dynamic_zero > 0; }
};

/// Everything that a block may change and that stays. A value that owns no memory: blocks work on a copy. A
/// chapter with modal words of its own adds one struct as a member.
struct IsoState {
  std::array<std::int32_t, kGroupCount> active{};  ///< code10 of each group
  WorkSystemId work_system = 1;
  double feed = 0.0;           ///< F as programmed
  double spindle_rpm = 0.0;    ///< S
  int spindle_direction = 0;   ///< +1 M3, -1 M4, 0
  double surface_speed = 0.0;  ///< S of G96: m/min or ft/min
  double speed_limit = 0.0;    ///< G92 S, 1/min; 0: none
  int surface_axis = 0;        ///< whose position is the radius of G96
  int tool = 0, next_tool = -1;
  int tool_row = 0, next_row = 0;  ///< of these in the tool management table; 0: none
  int h = 0, d = 0;
  double h_value = 0.0;                 ///< mm, read when H was executed
  std::array<double, 2> h_turning{};    ///< turning lengths X, Y of the same row, mm
  double d_radius = 0.0;                ///< mm, read when D was executed
  std::array<double, 3> comp_vector{};  ///< unit, X, Y, Z: where G141 moves points by d_radius
  int d_tip = 0;                        ///< code of the tip of the same row, 0 to 9
  AxisPoint length;                     ///< length offset in force, machine axes, mm
  CycleWords cycle;
  RigidTap rigid_tap = RigidTap::kOff;
  LastWords last;
  AutomaticBits automatic;
  AxisModal axes;
  Transforms transforms;
  FiveAxisState five;
  HeldWay held;

  /// The plane by its axes.
  WorkPlane workPlane() const { return WorkPlane(axes.plane_u, axes.plane_v, axes.plane_w); }
  void takePlane(const IsoState& other) {
    active[kGroupPlane] = other.active[kGroupPlane];
    axes.setPlane(other.axes.plane_u, other.axes.plane_v, other.axes.plane_w);
  }
  /// The axes of the plane are those of its code.
  void takeMainPlane() {
    const PlaneFrame frame(plane());
    axes.setPlane(frame.u(), frame.v(), frame.w());
  }
  /// The main plane: letters of centres, direction of drilling.
  Plane plane() const {
    const int g = active[kGroupPlane];
    return g == gcode::kPlaneZX ? Plane::kZX : g == gcode::kPlaneYZ ? Plane::kYZ : Plane::kXY;
  }
  bool incremental() const { return active[kGroupDistance] == gcode::kIncremental; }
  bool perTurn() const { return active[kGroupFeedMode] == gcode::kFeedPerTurn; }
  double unitScale() const { return active[kGroupUnits] == gcode::kInch ? 25.4 : 1.0; }
  bool inCycle() const { return active[kGroupCycle] != gcode::kCycleCancel; }
  /// Signed offset of cutter compensation: > 0 left of the path.
  double compOffset() const {
    const int g = active[kGroupRadiusComp];
    return g == gcode::kCompLeft ? d_radius : g == gcode::kCompRight ? -d_radius : 0.0;
  }
  bool compOn() const {
    const int g = active[kGroupRadiusComp];
    return g != gcode::kCompOff && g != gcode::kCompInSpace;
  }
};

}  // namespace proveout::nc
