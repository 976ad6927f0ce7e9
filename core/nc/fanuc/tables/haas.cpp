// Codes of Haas: they stand beside those of Fanuc-like controls, or in their place.
#include "core/nc/fanuc/haas/haas.h"

#include <array>

#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

/// G110 to G129.
constexpr std::array<GCode, 20> haasFrames() {
  std::array<GCode, 20> frames{};
  int code10 = 1100;
  for (GCode& frame : frames) {
    frame = modal(code10, kGroupWorkSystem, kSim, "haas-18-G110", "additional work system", {}, true);
    code10 += 10;
  }
  return frames;
}
constexpr GCode haasCycle(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kGroupCycle, kSim, "XYZUVWIJKRQPLa", planFanucCycle, false, ids, meaning);
}
constexpr GCode holes(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kOneShot, kSim, "XYZUVWIJKRQPL", planHaasHoles, false, ids, meaning);
}

constexpr auto kHaasFrames = haasFrames();

constexpr auto kHaasTableG = std::to_array<GCode>({
    action(280, kOneShot, kSim, kAxes, planHaasReference, true, "fan-5-G28 haas-18-G28",
           "to reference point 1 by way of an intermediate point; without axes all of them"),
    action(520, kOneShot, kSim, kAxes, planHaasLocalFrame, true, "fan-6-G52 haas-18-G52",
           "local coordinate system"),
    action(1030, kOneShot, kHost, "P", planNoted, false, "haas-18-G103", "limit of the look-ahead"),
    modal(1540, kGroupWorkSystem, kSim, "haas-18-G154", "additional work systems", "P", true),
    action(1870, kOneShot, kTime, "PE", planNoted, false, "haas-18-G187", "smoothness"),
});

constexpr auto kHaasTableM = std::to_array<MCode>({
    {31, MPhase::kBefore, 0, kHost, {}, "haas-18-M", "chip conveyor forward"},
    {33, MPhase::kAfter, 0, kHost, {}, "haas-18-M", "chip conveyor stop"},
    {97, MPhase::kCall, kFlowCodes, kSim, "PL", "haas-18-M97", "call of a part of the program"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PL", "fan-11-M98 haas-18-M98L", "subprogram call"},
});

constexpr auto kHaasMillG = std::to_array<GCode>({
    action(0, kGroupMotion, kSim, "XYZUVWIJKa", planHaasMove, false, "fan-3-G00", "rapid positioning"),
    action(10, kGroupMotion, kSim, "XYZUVWIJKacr", planHaasMove, false, "fan-3-G01", "linear interpolation"),
    action(20, kGroupMotion, kSim, "XYZUVWIJKRQLcr", planHaasArc, false, "fan-3-G02 haas-18-G02",
           "circle, helix, clockwise"),
    action(30, kGroupMotion, kSim, "XYZUVWIJKRQLcr", planHaasArc, false, "fan-3-G03 haas-18-G02",
           "circle, helix, counter-clockwise"),
    action(120, kOneShot, kSim, "ZIKQLDF", planHaasRoundPocket, true, "haas-18-G12",
           "round pocket, clockwise"),
    action(130, kOneShot, kSim, "ZIKQLDF", planHaasRoundPocket, true, "haas-18-G13",
           "round pocket, counter-clockwise"),
    refused(350, kOneShot, kReject, "haas-18-G136", "tool measuring"),
    refused(360, kOneShot, kReject, "haas-18-G136", "work measuring"),
    refused(370, kOneShot, kReject, "haas-18-G136", "tool measuring"),
    action(470, kOneShot, kSim, "XYZPRIJEF", planHaasEngraving, true, "haas-18-G47", "engraving"),
    holes(700, "haas-18-G70", "holes on a circle"),
    holes(710, "haas-18-G71", "holes on an arc"),
    holes(720, "haas-18-G72", "holes on a line"),
    haasCycle(730, "fan-10-G73 haas-18-G73", "high-speed peck drilling"),
    haasCycle(740, "fan-10-G74 haas-18-G84", "left tapping"),
    haasCycle(770, "haas-18-G77", "back boring"),
    haasCycle(830, "fan-10-G83 haas-18-G73", "peck drilling"),
    haasCycle(840, "fan-10-G84 haas-18-G84", "right tapping"),
    action(1000, kOneShot, kSim, kAxes, planHaasMirrorOff, true, "haas-18-G100", "mirroring off"),
    action(1010, kOneShot, kSim, kAxes, planHaasMirror, true, "haas-18-G101", "mirroring"),
    writtenAs(1070, action(71, kOneShot, kSim, kAxes, planFanucCylinder, false, "fan-3-G07.1 haas-18-G107",
                           "cylindrical interpolation")),
    refused(1360, kOneShot, kReject, "haas-18-G136", "measuring of a work offset"),
    action(1410, kGroupRadiusComp, kSim, "XYZIJK", planHaasSpaceComp, true, "haas-18-G141",
           "compensation along a vector"),
    writtenAs(1430, modal(gcode::kLengthAlongTool, kGroupLengthComp, kSim, "haas-18-G143",
                          "length compensation along the tool", {}, true)),
    action(1500, kOneShot, kSim, "XYZPRQIJKDF", planHaasOutlinePocket, true, "haas-18-G150",
           "pocket of any outline"),
    writtenAs(2340, modal(gcode::kTipByAngles, kGroupLengthComp, kSim, "haas-18-G143",
                          "tool centre point control", {}, true)),
    action(2540, kOneShot, kSim, {}, planHaasDynamicOffset, true, "haas-18-G143", "dynamic work offset"),
    action(2550, kOneShot, kSim, {}, planHaasDynamicOffset, true, "haas-18-G143", "dynamic work offset off"),
});

constexpr auto kHaasMillM = std::to_array<MCode>({
    {36, MPhase::kBefore, 0, kHost, {}, "haas-18-M", "pallet ready"},
    {46, MPhase::kBefore, 0, kHost, {}, "haas-18-M", "pallet loaded"},
    {83, MPhase::kBefore, 0, kHost, {}, "haas-18-M", "air on"},
    {84, MPhase::kAfter, 0, kHost, {}, "haas-18-M", "air off"},
    {88, MPhase::kBefore, 0, kHost, {}, "haas-18-M", "coolant through the spindle"},
    {89, MPhase::kAfter, 0, kHost, {}, "haas-18-M", "coolant through the spindle off"},
    {96, MPhase::kBefore, 0, kReject, "PQ", "haas-18-M96", "jump on an input", refuseHaasInput},
    {109, MPhase::kBefore, 0, kReject, "P", "haas-18-M96", "question to the person", refuseHaasInput},
});

constexpr auto kHaasMillFeatures = std::to_array<FeatureRow>({
    {"integers", kSim, "haas-18-dec", "words without a point: Setting 162 is `decimal`"},
    {"groups", kReject, "haas-18-group", "two G codes of a group in a block"},
    {"G4 P", kTime, "haas-18-G04", "a point means seconds"},
    {"G53", kSim, "haas-18-G53", "machine coordinates, under G91 too"},
    {"G92", kSim, "haas-18-G92", "clears G52 of the named axes"},
    {"cycles", kSim, "haas-18-L haas-18-Ropt", "L repeats, R may be left out"},
    {"variables", kSim, "haas-18-offsets haas-18-vars haas-18-macro", "offsets, tool data, macro forms"},
});

}  // namespace

CodeTable haasTable() { return {kHaasTableG, kHaasTableM, {}}; }
CodeTable haasFramesTable() { return {kHaasFrames, {}, {}}; }
CodeTable haasMillTable() { return {kHaasMillG, kHaasMillM, kHaasMillFeatures}; }

}  // namespace proveout::nc
