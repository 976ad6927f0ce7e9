// Makers of rows for the code tables of a control.
#pragma once

#include <array>
#include <utility>

#include "core/nc/iso/model/code_names.h"
#include "core/nc/iso/model/codes.h"

namespace proveout::nc::rows {

constexpr CodeClass kSim = CodeClass::kSim;
constexpr CodeClass kTime = CodeClass::kTime;
constexpr CodeClass kState = CodeClass::kState;
constexpr CodeClass kHost = CodeClass::kHost;
constexpr CodeClass kReject = CodeClass::kReject;

constexpr AddressSet kAxes = "XYZUVW";

/// What a code is for motions.
constexpr KindSet kindsOf(int code10, std::int8_t group) {
  using enum OriginKind;
  if (group == kOneShot) {
    if (code10 == gcode::kLocalShift || code10 == gcode::kSetPosition) return kShift;
    if (code10 == gcode::kCylinder) return kVirtualPlane;
    return code10 == gcode::kDiameter ? KindSet(kDiameter) : KindSet();
  }
  constexpr std::array<std::pair<IsoGroup, OriginKind>, 16> kGroups{
      {{kGroupMotion, kMotionCode},
       {kGroupPlane, kPlane},
       {kGroupDistance, kDistance},
       {kGroupFeedMode, kFeedMode},
       {kGroupUnits, kUnits},
       {kGroupRadiusComp, kCompensation},
       {kGroupLengthComp, kLengthCode},
       {kGroupCycle, kCycle},
       {kGroupReturn, kCycleReturn},
       {kGroupScaling, kScaling},
       {kGroupSurfaceSpeed, kSpindleMode},
       {kGroupWorkSystem, kWorkOffset},
       {kGroupRotation, kRotation},
       {kGroupPolarData, kPolar},
       {kGroupPolarInterpolation, kVirtualPlane},
       {kGroupMirror, kMirror}}};
  for (const auto& [of_group, kind] : kGroups) {
    if (of_group == group && code10 != gcode::kCycleCancel) return kind;  // G80 ends the words of a cycle
  }
  return {};
}

/// A modal code that only sets its group.
constexpr GCode modal(int code10, std::int8_t group, CodeClass cls, std::string_view ids,
                      std::string_view meaning, AddressSet words = {}, bool flushes = false) {
  return {code10, group, cls, true, false, flushes, words, kindsOf(code10, group), nullptr, ids, meaning};
}
/// A code that governs its block.
constexpr GCode action(int code10, std::int8_t group, CodeClass cls, AddressSet words, PlanFunction plan,
                       bool flushes, std::string_view ids, std::string_view meaning) {
  return {code10, group, cls, true, false, flushes, words, kindsOf(code10, group), plan, ids, meaning};
}
/// The row for programs that write another number, tenfold, for the code of the shared rules.
constexpr GCode writtenAs(int number10, GCode code) {
  code.written = number10;
  return code;
}
/// A code of the control that this version refuses.
constexpr GCode refused(int code10, std::int8_t group, CodeClass cls, std::string_view ids,
                        std::string_view meaning, bool skippable = false, AddressSet words = {}) {
  return {code10, group, cls, false, skippable, false, words, {}, nullptr, ids, meaning};
}

}  // namespace proveout::nc::rows
