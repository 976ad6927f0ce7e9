#include "core/nc/linuxcnc/program/lcn_kept.h"

#include "core/nc/linuxcnc/frames/frames.h"
#include "core/nc/linuxcnc/model/channel.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"

namespace proveout::nc {
namespace {

constexpr int kLcnProbe = 5061, kLcnProbeMet = 5070, kLcnHome28 = 5161, kLcnHome30 = 5181, kLcnShiftOn = 5210,
              kLcnShift = 5211, kLcnFrames = 5221, kLcnFrameStep = 20, kLcnLastFrame = 5390,
              kLcnToolOffset = 5401;
constexpr int kLcnLetters = 9;

/// Index of the axis of the k-th letter of XYZABCUVW, or -1.
int lcnAxisOfLetter(const IsoContext& c, int k) {
  return k < 3 ? k : c.axes.names().axisOfLetter("XYZABCUVW"[k]);
}

double lcnMachineUnit(const IsoContext& c) { return c.parameters[LinuxCncParam::kUnits] == 1.0 ? 25.4 : 1.0; }

/// mm of the parameter's unit for that axis.
double lcnUnitOf(const IsoContext& c, int axis, double unit) { return c.axes.at(axis).rotary() ? 1.0 : unit; }

double lcnOfPoint(const IsoContext& c, const AxisPoint& point, int k, double unit) {
  const int axis = lcnAxisOfLetter(c, k);
  return axis < 0 ? 0.0 : point[axis] / lcnUnitOf(c, axis, unit);
}

void putLcnPoint(const IsoContext& c, AxisPoint& point, int k, double value) {
  const int axis = lcnAxisOfLetter(c, k);
  if (axis >= 0) point[axis] = value * lcnUnitOf(c, axis, lcnMachineUnit(c));
}

bool isOf(int number, int first) { return number >= first && number < first + kLcnLetters; }

/// Of #5221 to #5390: frame 1 to 9 and what of it, 0 to 8 an axis, 9 its R. False: another number.
bool lcnFrameOf(int number, int& frame, int& what) {
  if (number < kLcnFrames || number > kLcnLastFrame) return false;
  frame = (number - kLcnFrames) / kLcnFrameStep + 1;
  what = (number - kLcnFrames) % kLcnFrameStep;
  return what <= kLcnLetters;
}

/// #5401 to #5413 of the tool in the spindle.
std::optional<double> lcnOfTool(const IsoContext& c, int number) {
  const int tool = c.state.tool;
  const bool known = tool >= 1 && tool <= OffsetTables::kRows;
  const double unit = lcnMachineUnit(c);
  if (isOf(number, kLcnToolOffset))
    return known ? lcnOfPoint(c, linuxCncToolOffset(c, tool), number - kLcnToolOffset, unit) : 0.0;
  if (number < 5410 || number > 5413) return {};
  if (!known) return 0.0;
  const OffsetTables& table = c.registers.offsets;
  if (number == 5410) return 2.0 * table.effective(OffsetColumn::kRadius, tool) / unit;
  if (number == 5413) return static_cast<double>(table.tip(tool));
  const auto& angles = linuxCncChannel(c).angles;
  const auto found = angles.find(tool);
  return found == angles.end() ? 0.0 : found->second[static_cast<std::size_t>(number - 5411)];
}

}  // namespace

std::optional<double> lcnKept(const IsoContext& c, int number) {
  const LinuxCncChannel& own = linuxCncChannel(c);
  const double unit = lcnMachineUnit(c);
  if (isOf(number, kLcnProbe)) return lcnOfPoint(c, own.probe_at, number - kLcnProbe, c.state.unitScale());
  if (number == kLcnProbeMet) return own.probe_met ? 1.0 : 0.0;
  if (isOf(number, kLcnHome28)) return lcnOfPoint(c, own.home28, number - kLcnHome28, unit);
  if (isOf(number, kLcnHome30)) return lcnOfPoint(c, own.home30, number - kLcnHome30, unit);
  if (number == kLcnShiftOn) return own.shift_on ? 1.0 : 0.0;
  if (isOf(number, kLcnShift)) return lcnOfPoint(c, own.shift, number - kLcnShift, unit);
  int frame = 0, what = 0;
  if (lcnFrameOf(number, frame, what)) {
    const WorkSystem system = c.registers.frames.system(linuxCncSystem(frame));
    return what == kLcnLetters ? system.angles_deg.z() : lcnOfPoint(c, system.offset, what, unit);
  }
  return lcnOfTool(c, number);
}

bool putLcnKept(IsoContext& c, int number, double value) {
  LinuxCncChannel& own = linuxCncChannel(c);
  if (isOf(number, kLcnHome28) || isOf(number, kLcnHome30)) {
    own.homes_known = true;
    const bool first = isOf(number, kLcnHome28);
    putLcnPoint(c, first ? own.home28 : own.home30, number - (first ? kLcnHome28 : kLcnHome30), value);
    return true;
  }
  if (isOf(number, kLcnProbe)) {
    const int axis = lcnAxisOfLetter(c, number - kLcnProbe);
    if (axis >= 0) own.probe_at[axis] = value * lcnUnitOf(c, axis, c.state.unitScale());
    return true;
  }
  if (number == kLcnProbeMet) {
    own.probe_met = value != 0.0;
    return true;
  }
  if (number == kLcnShiftOn) {
    own.shift_on = value != 0.0;
    return true;
  }
  if (isOf(number, kLcnShift)) {
    putLcnPoint(c, own.shift, number - kLcnShift, value);
    return true;
  }
  int frame = 0, what = 0;
  if (!lcnFrameOf(number, frame, what)) return false;
  WorkSystem& system = c.registers.frames.system(linuxCncSystem(frame));
  if (what == kLcnLetters) {
    system.angles_deg.z() = value;
  } else {
    putLcnPoint(c, system.offset, what, value);
  }
  return true;
}

}  // namespace proveout::nc
