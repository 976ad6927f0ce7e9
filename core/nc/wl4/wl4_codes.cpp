#include "core/nc/wl4/wl4_codes.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace proveout::nc {

namespace {

using enum Wl4Group;

// clang-format off: one row a line
constexpr auto kGCodes = std::to_array<Wl4GCode>({
    {0, kMotion, "SIM", "wl4-5.1.1-G0", "rapid, all axes together"},
    {1, kMotion, "SIM", "wl4-5.1.2-G1", "linear interpolation"},
    {2, kMotion, "SIM", "wl4-5.1.3-G2 wl4-5.1.3-full wl4-5.1.3-R", "arc, helix, clockwise"},
    {3, kMotion, "SIM", "wl4-5.1.3-G3", "arc, helix, counter-clockwise"},
    {4, kDeed, "TIME", "wl4-5.4-G4", "dwell E seconds"},
    {9, kFlag, "TIME", "wl4-5.5-G9", "exact stop at the end of the block"},
    {12, kMotion, "SIM", "wl4-5.1.4-G12", "quarter circle, clockwise"},
    {13, kMotion, "SIM", "wl4-5.1.4-G13", "quarter circle, counter-clockwise"},
    {17, kPlane, "SIM", "wl4-5.7-G17", "plane XY"},
    {18, kPlane, "SIM", "wl4-5.7-G18", "plane XZ"},
    {19, kPlane, "SIM", "wl4-5.7-G19", "plane YZ"},
    {31, kDeed, "SIM", "wl4-11.1-G31", "thread in several passes"},
    {32, kMotion, "SIM", "wl4-5.1.5-G32", "thread"},
    {33, kMotion, "SIM", "wl4-5.1.6-G33", "thread there and back"},
    {36, kDeed, "SIM", "wl4-5.2-G36", "to the machine zero"},
    {38, kFlag, "SIM", "wl4-5.3-G38", "measuring move"},
    {40, kRadius, "SIM", "wl4-6.2-G40", "compensation off"},
    {41, kRadius, "SIM", "wl4-6.2-G41", "compensation, tool left of the contour"},
    {42, kRadius, "SIM", "wl4-6.2-G42", "compensation, tool right of the contour"},
    {43, kLength, "SIM", "wl4-6.3-G43", "length offset added"},
    {44, kLength, "SIM", "wl4-6.3-G44", "length offset subtracted"},
    {49, kLength, "SIM", "wl4-6.3-G49", "length offsets off"},
    {50, kFlag, "SIM", "wl4-5.11-G50", "mirroring off"},
    {51, kFlag, "SIM", "wl4-5.11-G51 wl4-5.12-G51S", "mirroring; limit of the spindle's speed"},
    {53, kSystem, "SIM", "wl4-5.10-G53", "machine system"},
    {54, kSystem, "SIM", "wl4-5.10-G54", "workpiece system 1"},
    {55, kSystem, "SIM", "wl4-5.10-G55", "workpiece system 2"},
    {56, kSystem, "SIM", "wl4-5.10-G56", "workpiece system 3"},
    {57, kSystem, "SIM", "wl4-5.10-G57", "workpiece system 4"},
    {58, kSystem, "SIM", "wl4-5.10-G58", "workpiece system 5"},
    {59, kSystem, "SIM", "wl4-5.10-G59", "workpiece system 6"},
    {60, kStop, "TIME", "wl4-5.6-G60", "exact stop, modal"},
    {63, kStop, "TIME", "wl4-5.6-G63", "exact stop, modal, feed at 100 %"},
    {64, kStop, "TIME", "wl4-5.6-G64", "continuous path"},
    {70, kDeed, "SIM", "wl4-11.2-G70", "one pass along Z"},
    {71, kDeed, "SIM", "wl4-11.3-G71", "one pass along X"},
    {72, kDeed, "SIM", "wl4-11.4-G72", "deep groove"},
    {73, kDeed, "SIM", "wl4-11.5-G73", "deep hole"},
    {74, kDeed, "SIM", "wl4-11.6-G74", "grooves in the face"},
    {75, kDeed, "SIM", "wl4-11.7-G75", "grooves on the cylinder"},
    {76, kDeed, "SIM", "wl4-11.8.1-G76 wl4-11.8.2-G76 wl4-11.8.3-G76", "contour, passes along it"},
    {77, kDeed, "SIM", "wl4-11.9.1-G77 wl4-11.9.2-G77 wl4-11.9.3-G77 wl4-11.10-G77",
     "roughing along Z; contour"},
    {78, kDeed, "SIM", "wl4-11.11.1-G78 wl4-11.11.2-G78 wl4-11.11.3-G78 wl4-11.12-G78",
     "roughing along X; contour"},
    {79, kDeed, "REJECT", "wl4-11-G79", "no cycle: an error of the program %1"},
    {80, kCycle, "SIM", "wl4-10.2-G80", "fixed cycle off"},
    {81, kCycle, "SIM", "wl4-10.3.1-G81", "fixed cycle: the program %81 after each motion"},
    {82, kCycle, "SIM", "wl4-10.3.2-G82", "fixed cycle %82"},
    {83, kCycle, "SIM", "wl4-10.3.3-G83", "fixed cycle %83"},
    {84, kCycle, "SIM", "wl4-10.3.4-G84", "fixed cycle %84"},
    {85, kCycle, "SIM", "wl4-10.3.5-G85", "fixed cycle %85"},
    {86, kCycle, "SIM", "wl4-10.3.6-G86", "fixed cycle %86"},
    {87, kCycle, "SIM", "wl4-10.3.7-G87", "fixed cycle %87"},
    {88, kCycle, "SIM", "wl4-10.3.8-G88", "fixed cycle %88"},
    {89, kCycle, "SIM", "wl4-10.3.9-G89", "fixed cycle %89"},
    {90, kDistance, "SIM", "wl4-5.8-G90", "absolute"},
    {91, kDistance, "SIM", "wl4-5.8-G91", "incremental"},
    {92, kDeed, "SIM", "wl4-5.9-G92", "coordinate system set by the position"},
    {94, kFeed, "TIME", "wl4-5.13-G94", "feed mm/min"},
    {95, kFeed, "TIME", "wl4-5.13-G95", "feed mm/rev"},
    {96, kSpeed, "TIME", "wl4-5.14-G96", "constant cutting speed m/min"},
    {97, kSpeed, "TIME", "wl4-5.14-G97", "speed 1/min"},
});

struct FeatureRow {
  std::string_view code, cls, ids, meaning;
};
constexpr auto kFeatures = std::to_array<FeatureRow>({
    {"M0", "HOST", "wl4-7.4-M0", "stop"},
    {"M1", "HOST", "wl4-7.4-M1", "stop with confirmation"},
    {"M2", "STATE", "wl4-7.4-M2", "end of the program"},
    {"M3", "STATE", "wl4-7.4-M3", "spindle clockwise"},
    {"M4", "STATE", "wl4-7.4-M4", "spindle counter-clockwise"},
    {"M5", "STATE", "wl4-7.4-M5", "spindle stop"},
    {"M6", "SIM", "wl4-7.4-M6 wl4-7.3-TM6", "tool change"},
    {"M7", "HOST", "wl4-7.4-M7", "coolant"},
    {"M8", "HOST", "wl4-7.4-M8", "coolant"},
    {"M9", "HOST", "wl4-7.4-M9", "coolant off"},
    {"M10-M29", "HOST", "wl4-7.4-M10", "of the machine"},
    {"M19", "STATE", "wl4-7.4-M19", "spindle orientation"},
    {"M30", "STATE", "wl4-7.4-M30", "end of data"},
    {"M31-M98", "HOST", "wl4-7.4-M31", "of the machine"},
    {"M40-M48", "STATE", "wl4-7.4-M40", "gears"},
    {"M99", "SIM", "wl4-7.4-M99", "end of a subprogram"},
    {"B", "SIM", "wl4-8.1-B", "chamfer"},
    {"L", "SIM", "wl4-4.2-L wl4-10.1-L wl4-10.1-nest", "call of a subprogram"},
    {"#", "SIM", "wl4-4.2-var wl4-9.1-loc wl4-9.1-glob wl4-9.1-ind", "variables"},
    {"IF", "SIM", "wl4-9.4.2-IF wl4-9.4.2-IFp", "conditional words"},
    {"N", "SIM", "wl4-9.4.1-lbl wl4-9.4.1-jmp", "labels and jumps"},
    {"%1", "SIM", "wl4-11.13-pgm wl4-11-open", "program of the open cycles"},
});
// clang-format on

}  // namespace

const Wl4GCode* wl4GCode(int code) {
  const auto at = std::lower_bound(kGCodes.begin(), kGCodes.end(), code,
                                   [](const Wl4GCode& g, int c) { return g.code < c; });
  return at != kGCodes.end() && at->code == code ? &*at : nullptr;
}

Wl4Phase wl4Phase(int m) {
  constexpr std::array kEnd = {0, 1, 2, 5, 9, 19, 30, 99};
  return std::find(kEnd.begin(), kEnd.end(), m) != kEnd.end() ? Wl4Phase::kEnd : Wl4Phase::kStart;
}

std::vector<CoverageRow> wl4Coverage() {
  const auto status = [](std::string_view cls) {
    return cls == "SIM"     ? "simulated"
           : cls == "TIME"  ? "timed"
           : cls == "STATE" ? "tracked"
           : cls == "HOST"  ? "noted"
                            : "refused";
  };
  std::vector<CoverageRow> rows;
  for (const Wl4GCode& g : kGCodes) {
    rows.push_back({fmt::format("G{}", g.code), static_cast<int>(g.group), std::string(g.cls), status(g.cls),
                    std::string(g.ids), std::string(g.meaning)});
  }
  for (const FeatureRow& f : kFeatures) {
    rows.push_back({std::string(f.code), -1, std::string(f.cls), status(f.cls), std::string(f.ids),
                    std::string(f.meaning)});
  }
  return rows;
}

}  // namespace proveout::nc
