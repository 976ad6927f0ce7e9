#include "core/nc/nct/nct_codes.h"

#include <algorithm>
#include <array>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {
namespace {

constexpr CodeClass kSim = CodeClass::kSim;
constexpr CodeClass kTime = CodeClass::kTime;
constexpr CodeClass kState = CodeClass::kState;
constexpr CodeClass kHost = CodeClass::kHost;
constexpr CodeClass kReject = CodeClass::kReject;

constexpr AddressSet kAxes = "XYZUVW";
constexpr AddressSet kArcWords = "XYZUVWIJKRL";
constexpr AddressSet kCycleWordSet = "XYZUVWIJKRQEPL";

/// A modal code that only sets its group.
constexpr GCode modal(int code10, std::int8_t group, CodeClass cls, std::string_view ids,
                      std::string_view meaning, AddressSet words = {}, bool flushes = false) {
  return {static_cast<std::int16_t>(code10), group, cls, true, false, flushes, words, nullptr, ids, meaning};
}
/// A code that governs its block.
constexpr GCode action(int code10, std::int8_t group, CodeClass cls, AddressSet words, PlanFunction plan,
                       bool flushes, std::string_view ids, std::string_view meaning) {
  return {static_cast<std::int16_t>(code10), group, cls, true, false, flushes, words, plan, ids, meaning};
}
/// A code of the control that this version refuses.
constexpr GCode refused(int code10, std::int8_t group, CodeClass cls, std::string_view ids,
                        std::string_view meaning, bool skippable = false, AddressSet words = {}) {
  return {
      static_cast<std::int16_t>(code10), group, cls, false, skippable, false, words, nullptr, ids, meaning};
}
constexpr GCode cycle(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kGroupCycle, kSim, kCycleWordSet, &NctControl::planCycle, false, ids, meaning);
}

// Sorted by code10: findGCode() searches by halves once, when its index is made.
constexpr auto kGCodes = std::to_array<GCode>({
    action(0, kGroupMotion, kSim, kAxes, &NctControl::planRapid, false, "nct-4.1-G0 nct-6.1-rapid",
           "rapid positioning"),
    action(10, kGroupMotion, kSim, kAxes, &NctControl::planLine, false, "nct-4.2-G1", "linear interpolation"),
    action(20, kGroupMotion, kSim, kArcWords, &NctControl::planArc, false,
           "nct-4.3-G2 nct-4.3-R nct-4.3-IJK nct-4.3-full nct-4.3-vararc nct-4.3-Rsmall nct-4.3.1-spiral "
           "nct-4.3.2-helix nct-4.3.3-cone",
           "circle, helix, spiral, cone, clockwise"),
    action(30, kGroupMotion, kSim, kArcWords, &NctControl::planArc, false, "nct-4.3-G3",
           "circle, helix, spiral, cone, counter-clockwise"),
    action(40, kOneShot, kTime, "P", &NctControl::planDwell, false, "nct-3-G4 nct-8-G4", "dwell"),
    refused(51, kOneShot, kState, "nct-4.7-G5.1Q0 nct-4.7-G5.1Q1 nct-4.7-G5.1Q2 nct-4.7.1-G5.1Q3",
            "smooth interpolation", true, "QXYZUVWABC"),
    refused(71, kOneShot, kSim, "nct-4.6-G7.1", "cylindrical interpolation"),
    modal(90, kOneShot, kTime, "nct-3-G9 nct-6.3.1-G9 nct-4.1.1-G9G61", "exact stop in this block"),
    action(100, kOneShot, kSim, "LPXYZUVWIJKR", &NctControl::planOffsets, false,
           "nct-3-G10 nct-10.2.4-G10L2 nct-10.2.5-G10L20 nct-15.2-G10-L10 nct-15.2-G10-L11 nct-15.2-G10-L12 "
           "nct-15.2-G10-L13 nct-15.2-G90-G91-I",
           "data input: L2, L20 work offsets, L10 to L13 tool offsets"),
    refused(109, kOneShot, kSim, "nct-5.3.1-G10.9", "radius or diameter programming"),
    refused(110, kOneShot, kState, "nct-3-G11 nct-12.4-G11", "end of data input"),
    refused(121, kGroupPolarInterpolation, kSim, "nct-4.5-G12.1", "polar interpolation"),
    modal(131, kGroupPolarInterpolation, kSim, "nct-4.5-G13.1", "polar interpolation off"),
    modal(150, kGroupPolarData, kSim, "nct-5.4-G15", "polar data off"),
    refused(160, kGroupPolarData, kSim, "nct-5.4-G16", "polar data"),
    modal(170, kGroupPlane, kSim, "nct-3-G17 nct-10.4-G17", "plane XY"),
    modal(180, kGroupPlane, kSim, "nct-3-G18 nct-10.4-G18", "plane ZX"),
    modal(190, kGroupPlane, kSim, "nct-3-G19 nct-10.4-G19", "plane YZ"),
    modal(200, kGroupUnits, kSim, "nct-5.2-G20", "inch data"),
    modal(210, kGroupUnits, kSim, "nct-5.2-G21", "metric data"),
    refused(220, 4, kSim, "nct-3-G22", "programmed working-area limit"),
    modal(230, 4, kSim, "nct-3-G23", "programmed working-area limit off"),
    action(280, kOneShot, kSim, kAxes, &NctControl::planReference, true, "nct-3-G28 nct-9.1-G28",
           "to the reference point by way of an intermediate point"),
    action(300, kOneShot, kSim, "XYZUVWP", &NctControl::planReference, true, "nct-3-G30 nct-9.2-G30",
           "to reference point 1 to 4 by way of an intermediate point"),
    refused(310, kOneShot, kSim, "nct-3-G31", "skip measuring move"),
    refused(330, kGroupMotion, kSim, "nct-4.4-G33", "thread of constant lead"),
    refused(370, kOneShot, kHost, "nct-3-G37", "tool length measurement"),
    refused(380, kOneShot, kSim, "nct-15.5.5-G38", "keep the compensation vector"),
    refused(390, kOneShot, kSim, "nct-15.5.6-G39", "corner arc"),
    modal(400, kGroupRadiusComp, kSim,
          "nct-3-G40 nct-15.5-G40 nct-15.5.3-G40 nct-15.5.3-IJK nct-15.5.3-noaxis", "cutter compensation off",
          "IJK"),
    modal(410, kGroupRadiusComp, kSim,
          "nct-3-G41 nct-15.5-G41 nct-15.5.1-G41 nct-15.5.1-noaxis nct-15.5.1-IJK nct-15.5.2-inner "
          "nct-15.5.2-obtuse "
          "nct-15.5.2-acute",
          "cutter compensation left", "IJK"),
    modal(420, kGroupRadiusComp, kSim, "nct-3-G42 nct-15.5-G42 nct-15.5.4-change",
          "cutter compensation right", "IJK"),
    modal(430, kGroupLengthComp, kSim, "nct-3-G43 nct-15.3-G43 nct-15.3-INC", "length compensation +", {},
          true),
    refused(431, kGroupLengthComp, kSim, "nct-3-G43.1", "length compensation along the tool axis"),
    refused(434, kGroupLengthComp, kSim, "nct-3-G43.4", "tool centre point control 1"),
    refused(435, kGroupLengthComp, kSim, "nct-3-G43.5", "tool centre point control 2"),
    refused(437, kGroupLengthComp, kSim, "nct-15.4-G43.7", "turning offsets"),
    refused(438, kGroupLengthComp, kSim, "nct-3-G43.8", "cutting point control 1"),
    refused(439, kGroupLengthComp, kSim, "nct-3-G43.9", "cutting point control 2"),
    modal(440, kGroupLengthComp, kSim, "nct-3-G44 nct-15.3-G44", "length compensation -", {}, true),
    modal(490, kGroupLengthComp, kSim, "nct-3-G49 nct-15.3-G49", "length compensation off", {}, true),
    modal(500, kGroupScaling, kSim, "nct-16.2-G50", "scaling off"),
    modal(501, kGroupMirror, kSim, "nct-16.3-G50.1", "mirroring off", "XYZ"),
    refused(510, kGroupScaling, kSim, "nct-16.2-G51-P nct-16.2-G51-IJK", "scaling"),
    refused(511, kGroupMirror, kSim, "nct-16.3-G51.1", "mirroring"),
    action(520, kOneShot, kSim, kAxes, &NctControl::planLocalShift, true, "nct-3-G52 nct-10.3-G52",
           "local coordinate system"),
    action(530, kOneShot, kSim, kAxes, &NctControl::planMachineMove, true,
           "nct-3-G53 nct-10.1.1-G53 nct-10.1.1-G53-sync", "rapid to a machine position"),
    refused(531, kOneShot, kSim, "nct-3-G53.1", "turn rotary axes to the tool direction"),
    refused(536, kOneShot, kSim, "nct-3-G53.6", "turn rotary axes, tool centre held"),
    modal(540, kGroupWorkSystem, kSim, "nct-3-G54 nct-10.2.1-G54", "work system 1", {}, true),
    modal(541, kGroupWorkSystem, kSim, "nct-3-G54.1 nct-10.2.2-G54.1", "extended work systems P1 to P99", "P",
          true),
    refused(542, kGroupWorkSystem, kSim, "nct-3-G54.2", "dynamic zero offset"),
    modal(550, kGroupWorkSystem, kSim, "nct-3-G55 nct-10.2.1-G55", "work system 2", {}, true),
    modal(560, kGroupWorkSystem, kSim, "nct-3-G56 nct-10.2.1-G56", "work system 3", {}, true),
    modal(570, kGroupWorkSystem, kSim, "nct-3-G57 nct-10.2.1-G57", "work system 4", {}, true),
    modal(580, kGroupWorkSystem, kSim, "nct-3-G58 nct-10.2.1-G58", "work system 5", {}, true),
    modal(590, kGroupWorkSystem, kSim, "nct-3-G59 nct-10.2.1-G59", "work system 6", {}, true),
    modal(610, kGroupCutting, kTime, "nct-3-G61 nct-6.3.2-G61", "exact stop mode"),
    modal(620, kGroupCutting, kTime, "nct-3-G62 nct-6.3.5-G62", "feed reduction at inside corners"),
    modal(630, kGroupCutting, kTime, "nct-3-G63 nct-6.3.4-G63", "overrides off"),
    modal(640, kGroupCutting, kTime, "nct-3-G64 nct-6.3.3-G64", "continuous cutting"),
    refused(650, kOneShot, kSim, "nct-3-G65", "macro call"),
    refused(660, kGroupMacro, kSim, "nct-3-G66", "modal macro call after each move"),
    refused(661, kGroupMacro, kSim, "nct-3-G66.1", "modal macro call from each block"),
    modal(670, kGroupMacro, kSim, "nct-3-G67", "modal macro call off"),
    refused(680, kGroupRotation, kSim, "nct-16.1-G68", "rotation in the plane"),
    refused(681, kGroupTilt, kSim, "nct-3-G68.1", "three-dimensional transformation"),
    refused(682, kGroupTilt, kSim, "nct-3-G68.2", "inclined plane"),
    modal(690, kGroupRotation, kSim, "nct-16.1-G69", "rotation off"),
    modal(691, kGroupTilt, kSim, "nct-3-G69.1", "three-dimensional transformation off"),
    refused(707, kOneShot, kSim, "nct-3-G70.7", "turning: finishing cycle"),
    refused(717, kOneShot, kSim, "nct-3-G71.7", "turning: roughing cycle"),
    refused(727, kOneShot, kSim, "nct-3-G72.7", "turning: face roughing cycle"),
    cycle(730, "nct-3-G73 nct-18.1.1-G73", "high-speed peck drilling"),
    refused(737, kOneShot, kSim, "nct-3-G73.7", "turning: pattern repeating cycle"),
    cycle(740, "nct-3-G74 nct-18.1.2-G74", "left tapping, floating holder"),
    refused(747, kOneShot, kSim, "nct-3-G74.7", "turning: face grooving cycle"),
    refused(757, kOneShot, kSim, "nct-3-G75.7", "turning: grooving cycle"),
    cycle(760, "nct-3-G76 nct-18.1.3-G76", "fine boring, oriented retract"),
    refused(767, kOneShot, kSim, "nct-3-G76.7", "turning: threading cycle"),
    refused(777, kGroupMotion, kSim, "nct-3-G77.7", "turning: longitudinal cycle"),
    refused(787, kGroupMotion, kSim, "nct-3-G78.7", "turning: simple threading cycle"),
    refused(797, kGroupMotion, kSim, "nct-3-G79.7", "turning: face cycle"),
    modal(800, kGroupCycle, kSim, "nct-3-G80 nct-18.1.4-G80", "drilling cycle off"),
    refused(808, kGroupGear, kState, "nct-3-G80.8", "electronic gear off"),
    cycle(810, "nct-3-G81 nct-18.1.5-G81", "drilling, rapid out"),
    refused(818, kGroupGear, kReject, "nct-3-G81.8", "electronic gear"),
    cycle(820, "nct-3-G82 nct-18.1.6-G82", "drilling with dwell"),
    cycle(830, "nct-3-G83 nct-18.1.7-G83", "peck drilling"),
    cycle(840, "nct-3-G84 nct-18.1.8-G84", "right tapping, floating holder"),
    cycle(842, "nct-3-G84.2 nct-18.1.9-G84.2 nct-18.1.10-G84.2Q", "right rigid tapping"),
    cycle(843, "nct-3-G84.3 nct-18.1.9-G84.3 nct-18.1.10-G84.3Q", "left rigid tapping"),
    cycle(850, "nct-3-G85 nct-18.1.11-G85", "boring, feed out"),
    cycle(860, "nct-3-G86 nct-18.1.12-G86", "boring, spindle stop, rapid out"),
    cycle(870, "nct-3-G87 nct-18.1.13-G87A nct-18.1.13-G87B",
          "back boring, or boring with manual intervention"),
    cycle(880, "nct-3-G88 nct-18.1.14-G88", "boring with manual intervention"),
    cycle(890, "nct-3-G89 nct-18.1.15-G89", "boring with dwell, feed out"),
    modal(900, kGroupDistance, kSim, "nct-5.1-G90", "absolute data"),
    modal(910, kGroupDistance, kSim, "nct-5.1-G91", "incremental data"),
    action(920, kOneShot, kSim, kAxes, &NctControl::planSetPosition, true, "nct-3-G92 nct-10.2.6-G92",
           "coordinates of the present position"),
    modal(940, kGroupFeedMode, kTime, "nct-3-G94 nct-6.2.1-G94", "feed per minute"),
    modal(950, kGroupFeedMode, kTime, "nct-3-G95 nct-6.2.1-G95", "feed per turn"),
    refused(960, kGroupSurfaceSpeed, kTime, "nct-3-G96 nct-11.5.1-G96 nct-11.5.3-G96P",
            "constant surface speed"),
    modal(970, kGroupSurfaceSpeed, kTime, "nct-3-G97 nct-11.5.1-G97", "constant surface speed off"),
    modal(980, kGroupReturn, kSim, "nct-3-G98 nct-18-G98", "cycles return to the initial point"),
    modal(990, kGroupReturn, kSim, "nct-3-G99 nct-18-G99", "cycles return to point R"),
});

constexpr int kSpindleCodes = 1, kFlowCodes = 2, kCoolantCodes = 3, kGearCodes = 4;

constexpr auto kMCodes = std::to_array<MCode>({
    {0, MPhase::kStop, kFlowCodes, kHost, {}, "nct-13.1-M0", "programmed stop"},
    {1, MPhase::kStop, kFlowCodes, kHost, {}, "nct-13.1-M1", "optional stop"},
    {2, MPhase::kEnd, kFlowCodes, kState, {}, "nct-13.1-M2", "end of program"},
    {3, MPhase::kBefore, kSpindleCodes, kState, {}, "nct-11.2-M3", "spindle clockwise"},
    {4, MPhase::kBefore, kSpindleCodes, kState, {}, "nct-11.2-M4", "spindle counter-clockwise"},
    {5, MPhase::kAfter, kSpindleCodes, kState, {}, "nct-11.2-M5", "spindle stop"},
    {6, MPhase::kAfter, 0, kSim, {}, "nct-12.2-M6 nct-12.1-T", "tool change"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "nct-13.1-M8", "coolant on"},
    {9, MPhase::kAfter, kCoolantCodes, kState, {}, "nct-13.1-M9", "coolant off"},
    {11, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 1"},
    {12, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 2"},
    {13, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 3"},
    {14, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 4"},
    {15, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 5"},
    {16, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 6"},
    {17, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 7"},
    {18, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 8"},
    {19, MPhase::kAfter, kSpindleCodes, kState, {}, "nct-11.7.1-M19", "spindle orientation"},
    {30, MPhase::kEnd, kFlowCodes, kState, {}, "nct-13.1-M30", "end of program"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PL", "nct-14.4.2-M98P nct-14.4.2-M98file nct-14.4.2-nesting",
     "subprogram call"},
    {99, MPhase::kCall, kFlowCodes, kSim, "PL",
     "nct-14.4.3-M99 nct-14.4.3-M99P nct-14.4.3-M99L nct-14.4.4-main",
     "return from a subprogram, jump in the main program"},
});

constexpr auto kFeatures = std::to_array<FeatureRow>({
    {"word", kState, "nct-1.1-word nct-1.1-block nct-3-zero nct-5.5-decimals",
     "address and number, decimal point optional"},
    {"N", kState, "nct-1.1-N nct-14.1-N", "block number, jump label"},
    {"O", kState, "nct-1.1-O nct-14.4.1-O", "program number at the head of the text"},
    {"/n", kSim, "nct-1.1-skip nct-14.2-skip", "optional block skip 1 to 9"},
    {"( )", kState, "nct-14.3-comment", "comment, over several lines"},
    {"X Y Z", kSim, "nct-1.1-XYZUVW nct-2.1-names", "main axes"},
    {"I operator", kSim, "nct-5.1-I", "one word incremental: XI10"},
    {"U V W", kSim, "nct-5.1-UVW", "incremental X, Y, Z"},
    {"F", kTime, "nct-1.1-F nct-4.2-F nct-6.2-F", "feed"},
    {"S", kState, "nct-1.1-S nct-11.1-S", "spindle speed"},
    {"T", kSim, "nct-1.1-T nct-12.1-T", "tool number"},
    {"H", kSim, "nct-1.1-HD nct-15.1-H nct-15.1-row0 nct-15.3-H-modal",
     "length offset row, read when programmed"},
    {"D", kSim, "nct-15.1-D nct-15.5-D0 nct-15.5-negR nct-15.5.2-newD",
     "radius offset row, read when programmed"},
    {"groups", kState, "nct-3-group nct-3-poweron nct-3-N1300 nct-1.3-modal",
     "modal groups and their power-on codes"},
    {"work offsets", kSim, "nct-10.2.1-common nct-10.2.3-rotation nct-1.3-WCS",
     "common offset, basic rotation"},
    {"length axes", kSim, "nct-15.3-ZAX nct-15.3-PLN nct-15.3-AXES nct-15.3-N1300",
     "axes of length compensation"},
    {"offset table", kSim, "nct-15.1-table-mill nct-15.1-N1400", "length and radius, geometry and wear"},
    {"arc settings", kSim, "nct-4.3-N1339 nct-4.3-CCA nct-4.3.2-HEF",
     "radius tolerance, absolute centre, helix feed"},
    {"comp corners", kSim,
     "nct-15.5-alpha nct-15.5.2-zero nct-15.5.2-spiral nct-15.5.2-N1405 nct-15.5.1-zeromove "
     "nct-15.5.1-nextzero",
     "corner classes of cutter compensation"},
    {"comp functions", kSim, "nct-15.5.2-passthrough nct-15.5.2-flush nct-15.5.2-skip",
     "functions, flushing codes and skip blocks inside cutter compensation"},
    {"comp side", kSim, "nct-15.5.4-LL nct-15.5.4-LA nct-15.5.4-AX nct-15.5.4-full nct-15.5.4-err",
     "change of side"},
    {"comp check", kSim, "nct-15.5.7-IEN nct-15.5.7-AAL nct-15.5.7-N1404", "interference check"},
    {"comp limits", kReject, "nct-15.5-plane nct-15.5.1-arc", "plane change and start in an arc are errors"},
    {"cycle words", kSim,
     "nct-18-ops nct-18-axis nct-18-init nct-18-hole nct-18-bottom nct-18-R nct-18-IJK nct-18-Q nct-18-E "
     "nct-18-L",
     "words and operations of drilling cycles"},
    {"cycle times", kTime, "nct-18-P nct-18-F nct-18-I nct-18.1.9-EOE", "dwell, feed and feed out of cycles"},
    {"cycle blocks", kSim,
     "nct-18.2-trigger nct-18.2-G04 nct-18.2-M nct-18.2-G43 nct-18.1.9-TSC nct-18.1.10-PTC",
     "which blocks of the cycle mode drill"},
    {"2012", kReject, "nct-4.3-2012", "circle radius difference error"},
    {"2015", kReject, "nct-4.3-2015", "circle definition error"},
    {"2043", kReject, "nct-15.5.3-2043", "G40 in circular interpolation"},
    {"2047", kReject, "nct-15.5.2-2047", "no intersection in cutter compensation"},
    {"2049", kReject, "nct-15.5.7-2049", "interference in cutter compensation"},
    {"2053", kReject, "nct-18-2053", "no bottom point or R point"},
    {"2090", kReject, "nct-15.5.2-2090", "cutter compensation: buffer full"},
    {",C", kSim, "nct-1.1-commaC nct-17.1-C", "chamfer between two blocks", false},
    {",R", kSim, "nct-1.1-commaR nct-17.1-R", "rounding between two blocks", false},
    {",A", kSim, "nct-1.1-commaA nct-17.2-A", "direction angle of a line", false},
    {"A B C", kSim, "nct-1.1-ABC", "rotary axes", false},
    {"#", kState, "nct-23.1.1-ref", "macro variables and expressions", false},
    {"name=", kSim, "nct-2.2-extname", "axis and spindle names of more than one character", false},
    {"M other", kHost, "nct-13.1-Mother", "functions of the machine builder"},
});

constexpr int kIndexSize = 1000;

/// code10 -> index into kGCodes, or -1.
constexpr std::array<std::int16_t, kIndexSize> makeIndex() {
  std::array<std::int16_t, kIndexSize> index{};
  index.fill(-1);
  for (std::size_t i = 0; i < kGCodes.size(); ++i) {
    index[static_cast<std::size_t>(kGCodes[i].code10)] = static_cast<std::int16_t>(i);
  }
  return index;
}
constexpr auto kIndex = makeIndex();

}  // namespace

std::string_view codeClassName(CodeClass cls) {
  switch (cls) {
    case CodeClass::kSim:
      return "SIM";
    case CodeClass::kTime:
      return "TIME";
    case CodeClass::kState:
      return "STATE";
    case CodeClass::kHost:
      return "HOST";
    case CodeClass::kReject:
      return "REJECT";
  }
  return "REJECT";
}

std::span<const GCode> nctGCodes() { return kGCodes; }
std::span<const MCode> nctMCodes() { return kMCodes; }
std::span<const FeatureRow> nctFeatures() { return kFeatures; }

const GCode* findGCode(int code10) {
  if (code10 < 0 || code10 >= kIndexSize) return nullptr;
  const int at = kIndex[static_cast<std::size_t>(code10)];
  return at < 0 ? nullptr : &kGCodes[static_cast<std::size_t>(at)];
}

const MCode* findMCode(int code) {
  const auto at =
      std::find_if(kMCodes.begin(), kMCodes.end(), [&](const MCode& m) { return m.code == code; });
  return at == kMCodes.end() ? nullptr : &*at;
}

}  // namespace proveout::nc
