#include "core/nc/linuxcnc/flavours/flavours.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/nc/linuxcnc/flavours/grbl.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"

namespace proveout::nc {
namespace {

/// What grblHAL has beside the G codes of GRBL 1.1, tenfold.
constexpr auto kGrblHalG = std::to_array<int>({50,  51,  70,  80,  330, 430, 432, 730, 760, 810, 820, 830,
                                               850, 860, 890, 950, 960, 970, 980, 990, 591, 592, 593});
constexpr auto kGrblHalM =
    std::to_array<int>({48, 49, 50, 51, 53, 60, 61, 62, 63, 64, 65, 66, 67, 68, 70, 71, 72, 73, 98, 99});
/// Codes that only Mach3 has.
constexpr auto kMach3G = std::to_array<int>({120, 130, 150, 160, 310, 500, 510, 680, 690});
/// PathPilot's own.
constexpr auto kPathPilotG = std::to_array<int>({370, 470});

template <std::size_t N>
bool among(const std::array<int, N>& codes, int code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

constexpr auto kGrblErrors = std::to_array<std::pair<std::string_view, int>>({
    {"unknown-code", 20},
    {"group-clash", 21},
    {"feed", 22},
    {"integer", 23},
    {"axis-words", 26},
    {"data", 29},
    {"machine-move", 30},
    {"unused-word", 36},
    {"arc-radius", 33},
    {"arc-reach", 34},
    {"arc-end", 33},
    {"arc-zero", 33},
    {"arc-form", 35},
    {"arc-plane", 35},
    {"dwell", 28},
    {"probe", 33},
    {"comp", 20},
    {"duplicate-word", 25},
});

}  // namespace

LinuxCncFlavour givenFlavour(const IsoContext& c) {
  return static_cast<LinuxCncFlavour>(static_cast<int>(c.parameters[LinuxCncParam::kFlavour]));
}

void beginLinuxCnc(IsoContext& c) { linuxCncChannel(c).flavour = givenFlavour(c); }

int grblError(std::string_view name) {
  for (const auto& [known, number] : kGrblErrors)
    if (known == name) return number;
  return 0;
}

bool flavourTakesG(IsoContext& c, const Word& w, int code10) {
  const LinuxCncFlavour flavour = linuxCncFlavour(c);
  if (isGrbl(c)) {
    if (grblHasG(code10) || (flavour == LinuxCncFlavour::kGrblHal && among(kGrblHalG, code10))) return true;
    return lcnFail(c, "unknown-code", fmt::format("{} is not a code of this control", gName(code10)), &w);
  }
  const bool own = flavour == LinuxCncFlavour::kMach3 ? !among(kPathPilotG, code10)
                   : flavour == LinuxCncFlavour::kPathPilot
                       ? !among(kMach3G, code10)
                       : !among(kMach3G, code10) && !among(kPathPilotG, code10);
  if (own) return true;
  return c.alarm(SharedAlarm::kNotImplemented, fmt::format("{} is not a code of this control", gName(code10)),
                 {}, w.columns);
}

bool flavourTakesM(IsoContext& c, const Word& w) {
  const int m = mNumber(w);
  if (m == 47 && linuxCncFlavour(c) != LinuxCncFlavour::kMach3)
    return c.alarm(SharedAlarm::kNotImplemented, "M47 is not a code of this control", {}, w.columns);
  if (!isGrbl(c)) return true;
  const bool hal = linuxCncFlavour(c) == LinuxCncFlavour::kGrblHal;
  if (!grblHasM(m) && !(hal && among(kGrblHalM, m)))
    return lcnFail(c, "unknown-code", fmt::format("M{} is not a code of this control", m), &w);
  if (m == mcode::kToolChange && !hal)
    c.warnOnce("grbl m6", "tool-change",
               "M6: GRBL itself knows none; the sender or the person at the machine changes the tool",
               w.columns);
  return true;
}

bool flavourTakesWords(IsoContext& c, const BlockPlan& plan) {
  const LinuxCncFlavour flavour = linuxCncFlavour(c);
  if (flavour == LinuxCncFlavour::kLinuxCnc) return true;
  const Word* e = c.block.find('E');
  if (e != nullptr && isGrbl(c))
    return lcnFail(c, "extruder", "E word: it feeds the filament of a printer, and this is no printer", e);
  const int motion = plan.governor->code10;
  if (motion == gcode::kArcClockwise || motion == gcode::kArcCounterClockwise) {
    const WorkPlane plane = plan.next.workPlane();
    if (flavour == LinuxCncFlavour::kGrblHal && c.block.findAxis(plane.u) == nullptr &&
        c.block.findAxis(plane.v) == nullptr)
      return lcnFail(c, "axis-words",
                     "No axis words in the plane of the arc: a full circle needs its end too");
  }
  return true;
}

bool grblRadii(IsoContext& c, double r1, double r2) {
  const double difference = std::abs(r1 - r2);
  constexpr double kAlways = 0.005, kNever = 0.5, kShare = 0.001;  // mm
  if (difference <= kAlways || (difference <= kNever && difference <= kShare * r1)) return true;
  return lcnFail(c, "arc-radius",
                 fmt::format("Invalid target: the radii of the arc are {:.6g} and {:.6g} mm", r1, r2));
}

}  // namespace proveout::nc
