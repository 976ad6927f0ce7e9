#include "core/nc/iso/program/reset.h"

#include <algorithm>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/spindle/spindle.h"

namespace proveout::nc {
namespace {

void setCodes(const IsoContext& c, IsoState& s) {
  const auto flag = [&](MotionParam p) { return c.parameters.flag(p); };
  s.active.fill(0);
  s.active[kGroupMotion] = flag(MotionParam::kDefaultG1) ? gcode::kLine : gcode::kRapid;
  s.active[kGroupPlane] = flag(MotionParam::kDefaultG18)   ? gcode::kPlaneZX
                          : flag(MotionParam::kDefaultG19) ? gcode::kPlaneYZ
                                                           : gcode::kPlaneXY;
  s.active[kGroupDistance] = flag(MotionParam::kDefaultG91) ? gcode::kIncremental : gcode::kAbsolute;
  s.active[kGroupZones] = gcode::kZoneOff;
  s.active[kGroupFeedMode] = flag(MotionParam::kDefaultG95) ? gcode::kFeedPerTurn : gcode::kFeedPerMinute;
  s.active[kGroupUnits] = flag(MotionParam::kDefaultG20) ? gcode::kInch : gcode::kMetric;
  s.active[kGroupRadiusComp] = gcode::kCompOff;
  s.active[kGroupLengthComp] = flag(MotionParam::kDefaultG43)   ? gcode::kLengthPlus
                               : flag(MotionParam::kDefaultG44) ? gcode::kLengthMinus
                                                                : gcode::kLengthOff;
  s.active[kGroupCycle] = gcode::kCycleCancel;
  s.active[kGroupReturn] = gcode::kReturnToInitial;
  s.active[kGroupScaling] = gcode::kScalingOff;
  s.active[kGroupMacro] = gcode::kMacroCancel;
  s.active[kGroupSurfaceSpeed] = gcode::kSurfaceSpeedOff;
  s.active[kGroupWorkSystem] = gcode::kWorkSystem1;
  s.active[kGroupCutting] = gcode::kContinuousCutting;
  s.active[kGroupRotation] = gcode::kRotationOff;
  s.active[kGroupPolarData] = gcode::kPolarDataOff;
  s.active[kGroupTilt] = gcode::kTiltOff;
  s.active[kGroupPolarInterpolation] = gcode::kPolarOff;
  s.active[kGroupMirror] = gcode::kMirrorOff;
  s.active[kGroupGear] = gcode::kGearOff;
}

/// Whether a group keeps its code at the end of a program.
bool keeps(const IsoContext& c, std::size_t group) {
  // G90 and G91, G20 and G21, G15 and G13.1 are set whatever the tables say.
  const bool always = group == kGroupDistance || group == kGroupUnits || group == kGroupPolarData ||
                      group == kGroupPolarInterpolation;
  return !always && c.parameters.flag(ProgramParam::kKeepModal) &&
         c.parameters.flag(ProgramParam::kKeep1 + static_cast<int>(group - 1));
}

/// A group gets its code of power-on, and what belongs to the code goes.
void resetGroup(const IsoState& fresh, std::size_t group, IsoState& s) {
  s.active[group] = fresh.active[group];
  Transforms& t = s.transforms;
  if (group == kGroupPlane) s.takePlane(fresh);
  if (group == kGroupLengthComp) s.length = fresh.length;
  if (group == kGroupLengthComp) s.five.endLength();
  if (group == kGroupTilt) s.five.tilt = FrameStep();
  if (group == kGroupTilt) s.five.rotations = s.five.tilted = s.five.on_table = false;
  if (group == kGroupWorkSystem) s.five.dynamic_zero = 0;
  if (group == kGroupCycle) s.cycle = fresh.cycle;
  if (group == kGroupWorkSystem) s.work_system = fresh.work_system;
  if (group == kGroupScaling) t.scales = t.scales_further = false;
  if (group == kGroupRotation) t.rotates = false;
  if (group == kGroupMirror) t.mirrored.reset();
  t.rotation_inside = t.rotation_inside && t.rotates && t.scales;
}

}  // namespace

IsoState powerOnState(const IsoContext& c) {
  IsoState s;
  setCodes(c, s);
  s.feed = c.parameters[s.perTurn() ? MotionParam::kDefaultFeedPerTurn : MotionParam::kDefaultFeedPerMinute];
  s.surface_speed = c.parameters[SpindleParam::kSurfaceSpeed];
  s.surface_axis = std::max(0, c.axes.byNumber(static_cast<int>(c.parameters[SpindleParam::kSurfaceAxis])));
  s.takeMainPlane();
  s.axes.diameter = diameterAxes(c);
  s.tool = c.settings.tool;
  if (c.dialect.power_on != nullptr) c.dialect.power_on(c, s);
  return s;
}

void powerOn(IsoContext& c) {
  c.modals.clear();
  c.interrupt = InterruptMacro();
  const int first = static_cast<int>(c.parameters[MacroParam::kProtectFirst]);
  const int last = static_cast<int>(c.parameters[MacroParam::kProtectLast]);
  c.variables.protect(first == 0 ? 1 : first, first == 0 ? 0 : last);
  c.state = powerOnState(c);
  resetSpindles(c);
  c.map = ProgramMap();
  c.chain = c.chainOf(c.state);
  c.machine = c.standing();
  c.position = c.chain.programOf(c.machine);
  DataInForce data;
  data.tool = c.state.tool;
  c.origins.setData(data);
  recordFrames(c, c.state);
}

void resetAtEnd(IsoContext& c) {
  const IsoState fresh = powerOnState(c);
  IsoState& s = c.state;
  if (c.dialect.end_state != nullptr) {
    c.dialect.end_state(c, fresh);
    c.pipe.clear();
    c.map = programMap(s.transforms, c.axes);
    c.chain = c.chainOf(s);
    c.settle(c.standing());
    return;
  }
  for (std::size_t group = 1; group < kGroupCount; ++group) {
    if (keeps(c, group)) continue;
    if (group == kGroupMacro) c.modals.clear();
    resetGroup(fresh, group, s);
  }
  s.axes.mode = VirtualMode::kOff;
  s.axes.smoothing = 0;
  s.axes.threading = false;
  s.axes.polar = PolarData();
  s.held = HeldWay();
  s.transforms.nested = {};
  s.axes.diameter = fresh.axes.diameter;
  s.automatic = AutomaticBits();
  s.rigid_tap = RigidTap::kOff;
  c.interrupt = InterruptMacro();
  if (c.dialect.end_shifts != nullptr) {
    c.dialect.end_shifts(c);
  } else {
    c.registers.frames.shift52 = c.registers.frames.shift92 = AxisPoint();
  }
  if (s.active[kGroupZones] == gcode::kZoneOff && c.registers.program_zone) {
    c.registers.program_zone.reset();
    c.stages.zone.configure();
  }
  if (c.stages.virtual_plane.linked()) c.stages.virtual_plane.end();
  c.pipe.clear();
  c.map = programMap(s.transforms, c.axes);
  c.chain = c.chainOf(s);
  c.machine = c.standing();
  c.position = c.chain.programOf(c.machine);
}

}  // namespace proveout::nc
