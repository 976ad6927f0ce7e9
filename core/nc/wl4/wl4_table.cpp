// The rows of the WL4 control: every code with what plans and performs it.
#include <algorithm>
#include <array>

#include "core/nc/wl4/cycles/wl4_cycles.h"
#include "core/nc/wl4/cycles/wl4_thread.h"
#include "core/nc/wl4/wl4_axis_words.h"
#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_functions.h"
#include "core/nc/wl4/wl4_motion.h"

namespace proveout::nc {

namespace {

using enum Wl4Group;
using Plan = Wl4BlockPlan;
using Text = std::string_view;
using Kind = std::optional<OriginKind>;

// What rows of a kind have in common.

constexpr Wl4GCode motion(int code, Wl4Step perform, AddressSet words, bool Plan::*flag, Text cls, Text ids,
                          Text meaning) {
  return {code, kMotion, &Wl4State::motion,       flag, planPositions, perform,
          {},   words,   OriginKind::kMotionCode, cls,  ids,           meaning};
}
constexpr Wl4GCode deed(int code, Wl4Step plan, Wl4Step perform, AddressSet words, bool Plan::*flag,
                        Kind kind, Text cls, Text ids, Text meaning) {
  return {code, kDeed, nullptr, flag, plan, perform, {}, words, kind, cls, ids, meaning};
}
/// An open cycle: the program %1.
constexpr Wl4GCode cycle(int code, bool Plan::*flag, Text cls, Text ids, Text meaning) {
  return {code, kDeed, nullptr, flag, planPositions, nullptr, "1", {}, {}, cls, ids, meaning};
}
/// A cycle over a contour; with a `program` it is an open cycle where the block names no contour.
constexpr Wl4GCode contour(int code, Text program, Text cls, Text ids, Text meaning) {
  return {code, kDeed, nullptr, &Plan::contour, planContourCycle, performContourCycle, program, {},
          {},   cls,   ids,     meaning};
}
constexpr Wl4GCode flag(int code, bool Plan::*flag, Kind kind, Text cls, Text ids, Text meaning) {
  return {code, kFlag, nullptr, flag, nullptr, nullptr, {}, {}, kind, cls, ids, meaning};
}
/// The program runs behind each motion while the code is in force.
constexpr Wl4GCode fixed(int code, Text program, Text cls, Text ids, Text meaning) {
  return {code,    kCycle, &Wl4State::cycle,   nullptr, nullptr, nullptr,
          program, {},     OriginKind::kCycle, cls,     ids,     meaning};
}

struct Mode {
  int Wl4State::*value;
  Kind kind;
};
constexpr Mode modeOf(Wl4Group group) {
  switch (group) {
    case kPlane:
      return {&Wl4State::plane, OriginKind::kPlane};
    case kRadius:
      return {&Wl4State::radius, OriginKind::kCompensation};
    case kLength:
      return {&Wl4State::length, OriginKind::kLengthCode};
    case kSystem:
      return {&Wl4State::system, OriginKind::kWorkOffset};
    case kStop:
      return {&Wl4State::stop, {}};
    case kDistance:
      return {&Wl4State::distance, OriginKind::kDistance};
    case kFeed:
      return {&Wl4State::feed_mode, OriginKind::kFeedMode};
    case kSpeed:
      return {&Wl4State::speed_mode, OriginKind::kSpindleMode};
    default:
      return {nullptr, {}};
  }
}
/// A mode that the plan and the motions look at.
constexpr Wl4GCode mode(int code, Wl4Group group, Text cls, Text ids, Text meaning) {
  const Mode m = modeOf(group);
  return {code, group, m.value, nullptr, nullptr, nullptr, {}, {}, m.kind, cls, ids, meaning};
}

// clang-format off: one row a line
constexpr auto kGCodes = std::to_array<Wl4GCode>({
    motion(0, performRapid, {}, nullptr, "SIM", "wl4-5.1.1-G0", "rapid, all axes together"),
    motion(1, performLine, {}, nullptr, "SIM", "wl4-5.1.2-G1", "linear interpolation"),
    motion(2, performArc, "IJKR", nullptr, "SIM", "wl4-5.1.3-G2 wl4-5.1.3-full wl4-5.1.3-R",
           "arc, helix, clockwise"),
    motion(3, performArc, "IJKR", nullptr, "SIM", "wl4-5.1.3-G3", "arc, helix, counter-clockwise"),
    deed(4, planDwell, performDwell, "E", nullptr, {}, "TIME", "wl4-5.4-G4", "dwell E seconds"),
    flag(9, &Plan::exact_stop, {}, "TIME", "wl4-5.5-G9", "exact stop at the end of the block"),
    motion(12, performQuarter, {}, nullptr, "SIM", "wl4-5.1.4-G12", "quarter circle, clockwise"),
    motion(13, performQuarter, {}, nullptr, "SIM", "wl4-5.1.4-G13", "quarter circle, counter-clockwise"),
    mode(17, kPlane, "SIM", "wl4-5.7-G17", "plane XY"),
    mode(18, kPlane, "SIM", "wl4-5.7-G18", "plane XZ"),
    mode(19, kPlane, "SIM", "wl4-5.7-G19", "plane YZ"),
    cycle(31, &Plan::thread, "SIM", "wl4-11.1-G31", "thread in several passes"),
    motion(32, performThread, {}, &Plan::thread, "SIM", "wl4-5.1.5-G32", "thread"),
    motion(33, performThreadAndBack, {}, &Plan::thread, "SIM", "wl4-5.1.6-G33", "thread there and back"),
    deed(36, planReference, performReference, {}, nullptr, {}, "SIM", "wl4-5.2-G36", "to the machine zero"),
    flag(38, &Plan::measures, {}, "SIM", "wl4-5.3-G38", "measuring move"),
    mode(40, kRadius, "SIM", "wl4-6.2-G40", "compensation off"),
    mode(41, kRadius, "SIM", "wl4-6.2-G41", "compensation, tool left of the contour"),
    mode(42, kRadius, "SIM", "wl4-6.2-G42", "compensation, tool right of the contour"),
    mode(43, kLength, "SIM", "wl4-6.3-G43", "length offset added"),
    mode(44, kLength, "SIM", "wl4-6.3-G44", "length offset subtracted"),
    mode(49, kLength, "SIM", "wl4-6.3-G49", "length offsets off"),
    flag(50, &Plan::mirror_off, OriginKind::kMirror, "SIM", "wl4-5.11-G50", "mirroring off"),
    flag(51, &Plan::mirror, OriginKind::kMirror, "SIM", "wl4-5.11-G51 wl4-5.12-G51S",
         "mirroring; limit of the spindle's speed"),
    mode(53, kSystem, "SIM", "wl4-5.10-G53", "machine system"),
    mode(54, kSystem, "SIM", "wl4-5.10-G54", "workpiece system 1"),
    mode(55, kSystem, "SIM", "wl4-5.10-G55", "workpiece system 2"),
    mode(56, kSystem, "SIM", "wl4-5.10-G56", "workpiece system 3"),
    mode(57, kSystem, "SIM", "wl4-5.10-G57", "workpiece system 4"),
    mode(58, kSystem, "SIM", "wl4-5.10-G58", "workpiece system 5"),
    mode(59, kSystem, "SIM", "wl4-5.10-G59", "workpiece system 6"),
    mode(60, kStop, "TIME", "wl4-5.6-G60", "exact stop, modal"),
    mode(63, kStop, "TIME", "wl4-5.6-G63", "exact stop, modal, feed at 100 %"),
    mode(64, kStop, "TIME", "wl4-5.6-G64", "continuous path"),
    cycle(70, nullptr, "SIM", "wl4-11.2-G70", "one pass along Z"),
    cycle(71, nullptr, "SIM", "wl4-11.3-G71", "one pass along X"),
    cycle(72, nullptr, "SIM", "wl4-11.4-G72", "deep groove"),
    cycle(73, nullptr, "SIM", "wl4-11.5-G73", "deep hole"),
    cycle(74, nullptr, "SIM", "wl4-11.6-G74", "grooves in the face"),
    cycle(75, nullptr, "SIM", "wl4-11.7-G75", "grooves on the cylinder"),
    contour(76, "", "SIM", "wl4-11.8.1-G76 wl4-11.8.2-G76 wl4-11.8.3-G76", "contour, passes along it"),
    contour(77, "1", "SIM", "wl4-11.9.1-G77 wl4-11.9.2-G77 wl4-11.9.3-G77 wl4-11.10-G77",
            "roughing along Z; contour"),
    contour(78, "1", "SIM", "wl4-11.11.1-G78 wl4-11.11.2-G78 wl4-11.11.3-G78 wl4-11.12-G78",
            "roughing along X; contour"),
    cycle(79, nullptr, "REJECT", "wl4-11-G79", "no cycle: an error of the program %1"),
    fixed(80, "", "SIM", "wl4-10.2-G80", "fixed cycle off"),
    fixed(81, "81", "SIM", "wl4-10.3.1-G81", "fixed cycle: the program %81 after each motion"),
    fixed(82, "82", "SIM", "wl4-10.3.2-G82", "fixed cycle %82"),
    fixed(83, "83", "SIM", "wl4-10.3.3-G83", "fixed cycle %83"),
    fixed(84, "84", "SIM", "wl4-10.3.4-G84", "fixed cycle %84"),
    fixed(85, "85", "SIM", "wl4-10.3.5-G85", "fixed cycle %85"),
    fixed(86, "86", "SIM", "wl4-10.3.6-G86", "fixed cycle %86"),
    fixed(87, "87", "SIM", "wl4-10.3.7-G87", "fixed cycle %87"),
    fixed(88, "88", "SIM", "wl4-10.3.8-G88", "fixed cycle %88"),
    fixed(89, "89", "SIM", "wl4-10.3.9-G89", "fixed cycle %89"),
    mode(90, kDistance, "SIM", "wl4-5.8-G90", "absolute"),
    mode(91, kDistance, "SIM", "wl4-5.8-G91", "incremental"),
    deed(92, planSystem, nullptr, {}, &Plan::sets_system, OriginKind::kWorkOffset, "SIM", "wl4-5.9-G92",
         "coordinate system set by the position"),
    mode(94, kFeed, "TIME", "wl4-5.13-G94", "feed mm/min"),
    mode(95, kFeed, "TIME", "wl4-5.13-G95", "feed mm/rev"),
    mode(96, kSpeed, "TIME", "wl4-5.14-G96", "constant cutting speed m/min"),
    mode(97, kSpeed, "TIME", "wl4-5.14-G97", "speed 1/min"),
});
// clang-format on

constexpr auto kStart = Wl4Phase::kStart, kEnd = Wl4Phase::kEnd;

constexpr Wl4MCode function(int first, int last, Wl4Phase phase, Wl4Function perform, Text cls, Text ids,
                            Text meaning) {
  return {first, last, phase, perform, Wl4Flow::kOn, {}, {}, cls, ids, meaning};
}
constexpr Wl4MCode spindle(int m, Wl4Phase phase, AddressSet words, Text cls, Text ids, Text meaning) {
  return {m, m, phase, performSpindle, Wl4Flow::kOn, words, OriginKind::kSpindleDirection, cls, ids, meaning};
}
/// The run loop does it.
constexpr Wl4MCode flow(int m, Wl4Flow flow, Text cls, Text ids, Text meaning) {
  return {m, m, kEnd, nullptr, flow, {}, {}, cls, ids, meaning};
}

// clang-format off: one row a line
constexpr auto kMCodes = std::to_array<Wl4MCode>({
    function(0, 0, kEnd, performStop, "HOST", "wl4-7.4-M0", "stop"),
    function(1, 1, kEnd, performOptionalStop, "HOST", "wl4-7.4-M1", "stop with confirmation"),
    flow(2, Wl4Flow::kEnd, "STATE", "wl4-7.4-M2", "end of the program"),
    spindle(3, kStart, {}, "STATE", "wl4-7.4-M3", "spindle clockwise"),
    spindle(4, kStart, {}, "STATE", "wl4-7.4-M4", "spindle counter-clockwise"),
    spindle(5, kEnd, {}, "STATE", "wl4-7.4-M5", "spindle stop"),
    function(6, 6, kStart, performToolChange, "SIM", "wl4-7.4-M6 wl4-7.3-TM6", "tool change"),
    function(7, 7, kStart, performCoolant, "HOST", "wl4-7.4-M7", "coolant"),
    function(8, 8, kStart, performCoolant, "HOST", "wl4-7.4-M8", "coolant"),
    function(9, 9, kEnd, performCoolant, "HOST", "wl4-7.4-M9", "coolant off"),
    function(10, 29, kStart, performOther, "HOST", "wl4-7.4-M10", "of the machine"),
    spindle(19, kEnd, "P", "STATE", "wl4-7.4-M19", "spindle orientation"),
    flow(30, Wl4Flow::kEnd, "STATE", "wl4-7.4-M30", "end of data"),
    function(31, 98, kStart, performOther, "HOST", "wl4-7.4-M31", "of the machine"),
    function(40, 48, kStart, performGear, "STATE", "wl4-7.4-M40", "gears"),
    flow(99, Wl4Flow::kReturn, "SIM", "wl4-7.4-M99", "end of a subprogram"),
});

constexpr auto kFeatures = std::to_array<Wl4Feature>({
    {"B", "SIM", "wl4-8.1-B", "chamfer"},
    {"L", "SIM", "wl4-4.2-L wl4-10.1-L wl4-10.1-nest", "call of a subprogram"},
    {"#", "SIM", "wl4-4.2-var wl4-9.1-loc wl4-9.1-glob wl4-9.1-ind", "variables"},
    {"IF", "SIM", "wl4-9.4.2-IF wl4-9.4.2-IFp", "conditional words"},
    {"N", "SIM", "wl4-9.4.1-lbl wl4-9.4.1-jmp", "labels and jumps"},
    {"%1", "SIM", "wl4-11.13-pgm wl4-11-open", "program of the open cycles"},
});
// clang-format on

constexpr std::size_t kNumbers = 100;  ///< G0 to G99, M0 to M99

/// By number, the row's place and one; 0: there is none.
constexpr auto kPlaceOfG = [] {
  std::array<std::uint8_t, kNumbers> places{};
  for (std::size_t k = 0; k < kGCodes.size(); ++k)
    places[static_cast<std::size_t>(kGCodes[k].code)] = static_cast<std::uint8_t>(k + 1);
  return places;
}();
constexpr auto kPlaceOfM = [] {
  std::array<std::uint8_t, kNumbers> places{};
  for (std::size_t k = 0; k < kMCodes.size(); ++k) {
    for (int m = kMCodes[k].first; m <= kMCodes[k].last; ++m)
      places[static_cast<std::size_t>(m)] = static_cast<std::uint8_t>(k + 1);
  }
  return places;
}();
static_assert(std::find(kPlaceOfM.begin(), kPlaceOfM.end(), 0) == kPlaceOfM.end(), "an M number has no row");

}  // namespace

std::span<const Wl4GCode> wl4GCodes() { return kGCodes; }
std::span<const Wl4MCode> wl4MCodes() { return kMCodes; }
std::span<const Wl4Feature> wl4Features() { return kFeatures; }

const Wl4GCode* wl4GCode(int code) {
  const auto n = static_cast<std::size_t>(code);
  return n < kNumbers && kPlaceOfG[n] != 0 ? &kGCodes[kPlaceOfG[n] - std::size_t{1}] : nullptr;
}

const Wl4MCode& wl4MCode(int m) { return kMCodes[kPlaceOfM[static_cast<std::size_t>(m)] - std::size_t{1}]; }

}  // namespace proveout::nc
