// Codes of lathes in the systems A, B and C (sections 15 and 16), beside those that mills have too.
#include <array>
#include <vector>

#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr AddressSet kSingleWords = "XYZUVWRIKQ";

/// The single cycles by their numbers in a system.
constexpr GCode turning(int number10) {
  return writtenAs(number10, action(lathe_code::kTurning, kGroupMotion, kSim, kSingleWords, planSingleCycle,
                                    false, "fan-16-G90", "turning cycle"));
}
constexpr GCode threading(int number10) {
  return writtenAs(number10, action(lathe_code::kThreading, kGroupMotion, kSim, "XYZUVWRIKQcr",
                                    planThreadingCycle, false, "fan-16-G92", "threading cycle"));
}
constexpr GCode facing(int number10) {
  return writtenAs(number10, action(lathe_code::kFacing, kGroupMotion, kSim, kSingleWords, planSingleCycle,
                                    false, "fan-16-G94", "facing cycle"));
}
constexpr GCode thread(int number10) {
  return writtenAs(number10, action(gcode::kThread, kGroupMotion, kSim, "XYZUVWQcr", planLatheThread, false,
                                    "fan-16-G32", "thread"));
}

constexpr GCode preset(int number10) {
  return writtenAs(number10, action(921, kOneShot, kSim, kAxes, planLathePreset, true, "fan-15-G50",
                                    "shifts of the work frames off"));
}

constexpr GCode finish(int number10) {
  return writtenAs(number10, action(lathe_code::kFinish, kOneShot, kSim, "PQUW", planFinishing, true,
                                    "fan-16-G70", "finish of a contour"));
}
constexpr GCode roughTurning(int number10) {
  return writtenAs(number10,
                   action(lathe_code::kRoughTurning, kOneShot, kSim, "PQUWRDIK", planRoughing, true,
                          "fan-16-G71 fan-16-G71II fan-16-G71one haas-18-latheG71", "roughing along Z"));
}
constexpr GCode roughFacing(int number10) {
  return writtenAs(number10, action(lathe_code::kRoughFacing, kOneShot, kSim, "PQUWRDIK", planRoughing, true,
                                    "fan-16-G72 haas-18-latheG72", "roughing along X"));
}
constexpr GCode pattern(int number10) {
  return writtenAs(number10, action(lathe_code::kPattern, kOneShot, kSim, "PQUWRDIK", planPattern, true,
                                    "fan-16-G73 haas-18-latheG73", "passes along a contour"));
}
constexpr GCode facePeck(int number10) {
  return writtenAs(number10, action(lathe_code::kFacePeck, kOneShot, kSim, "XYZUVWPQRIKD", planPecking, true,
                                    "fan-16-G74 haas-18-latheG74", "pecks along Z"));
}
constexpr GCode groove(int number10) {
  return writtenAs(number10, action(lathe_code::kGroove, kOneShot, kSim, "XYZUVWPQRIKD", planPecking, true,
                                    "fan-16-G75 haas-18-latheG74", "pecks along X"));
}
constexpr GCode threadCycle(int number10) {
  return writtenAs(number10,
                   action(lathe_code::kThreadCycle, kOneShot, kSim, "XYZUVWPQRIKDA", planThreadCycle, true,
                          "fan-16-G76 fan-16-G76one haas-18-latheG76", "thread in passes"));
}
/// The cycles of contours, which have neighbouring numbers in each system.
constexpr std::array<GCode, 7> contourCycles(int first10) {
  return {finish(first10),          roughTurning(first10 + 10), roughFacing(first10 + 20),
          pattern(first10 + 30),    facePeck(first10 + 40),     groove(first10 + 50),
          threadCycle(first10 + 60)};
}
constexpr auto kContourCyclesAB = contourCycles(700);
constexpr auto kContourCyclesC = contourCycles(720);

constexpr GCode drilling(int code10, int number10, std::string_view ids, std::string_view meaning) {
  return writtenAs(number10,
                   action(code10, kGroupCycle, kSim, "XYZUVWRQPK", planLatheDrilling, false, ids, meaning));
}

constexpr auto kLatheTableG = std::to_array<GCode>({
    action(10, kGroupMotion, kSim, "XYZUVWRIKCacr", planLatheLine, false,
           "fan-3-G01 fan-3-chamfer fan-3-corner", "linear interpolation, with chamfers and corners"),
    action(100, kOneShot, kSim, "LPXYZUVWIJKRCQ", planLatheData, false, "fan-6-G10lathe", "data input"),
    writtenAs(340, action(lathe_code::kVaryingThread, kGroupMotion, kSim, "XYZUVWQKcr", planLatheThread,
                          false, "fan-16-G34", "thread of varying lead")),
    refused(360, kOneShot, kReject, "fan-16-G36", "tool measuring along X", false, "XZUWP"),
    refused(370, kOneShot, kReject, "fan-16-G37", "tool measuring along Z", false, "XZUWP"),
    refused(680, kGroupRotation, kReject, "fan-9-doubleturret", "mirror image of double turrets"),
    refused(690, kGroupRotation, kReject, "fan-9-doubleturret", "mirror image of double turrets off"),
    writtenAs(681, action(680, kGroupRotation, kSim, "XYZUVWR", planFanucRotation, false, "fan-9-G68.1",
                          "rotation in the plane")),
    writtenAs(691, modal(690, kGroupRotation, kSim, "fan-9-G68.1", "rotation off")),
    modal(800, kGroupCycle, kSim, "fan-16-G83", "drilling cycle off"),
    drilling(830, 830, "fan-16-G83", "face drilling"),
    drilling(840, 840, "fan-16-G84", "face tapping"),
    drilling(850, 850, "fan-16-G85", "face boring"),
    drilling(830, 870, "fan-16-G87", "side drilling"),
    drilling(840, 880, "fan-16-G88", "side tapping"),
    drilling(850, 890, "fan-16-G89", "side boring"),
});

constexpr auto kLatheTableA = std::to_array<GCode>({
    thread(320),
    writtenAs(500, action(gcode::kSetPosition, kOneShot, kSim, kAxes, planSetPosition, true,
                          "fan-15-G50 fan-15-G50S", "coordinates of the present position, speed limit")),
    preset(503),
    turning(900),
    threading(920),
    facing(940),
    writtenAs(980, modal(gcode::kFeedPerMinute, kGroupFeedMode, kTime, "fan-15-G98", "feed per minute")),
    writtenAs(990, modal(gcode::kFeedPerTurn, kGroupFeedMode, kTime, "fan-15-G98", "feed per turn")),
});
/// Codes of mills whose numbers mean nothing in system A, or are scaling; offsets are those of T.
constexpr auto kNotInA = std::to_array<std::int32_t>({330, 500, 510, 910, 921, 950,  //
                                                      430, 440, 450, 460, 470, 480, 490});

constexpr auto kLatheTableB = std::to_array<GCode>({
    turning(770),
    threading(780),
    facing(790),
});
constexpr auto kLatheTableBC = std::to_array<GCode>({
    thread(330),
    preset(921),
    modal(980, kGroupReturn, kSim, "fan-15-systems", "cycles return to the start level"),
    modal(990, kGroupReturn, kSim, "fan-15-systems", "cycles return to level R"),
});
constexpr auto kNotInBAndC = std::to_array<std::int32_t>({500, 510, 430, 440, 450, 460, 470, 480, 490});

constexpr auto kLatheTableC = std::to_array<GCode>({
    turning(200),
    threading(210),
    facing(240),
    writtenAs(700, modal(gcode::kInch, kGroupUnits, kSim, "fan-15-systems", "inch data")),
    writtenAs(710, modal(gcode::kMetric, kGroupUnits, kSim, "fan-15-systems", "metric data")),
});

constexpr auto kHaasLatheTableG = std::to_array<GCode>({
    action(40, kOneShot, kTime, "PXU", planFanucDwell, false, "fan-4-G04 haas-18-G04", "dwell"),
});

constexpr auto kLatheTableM = std::to_array<MCode>({
    {23, MPhase::kBefore, 0, kState, {}, "haas-18-latheG76", "threads end in a run-out"},
    {24, MPhase::kBefore, 0, kState, {}, "haas-18-latheG76", "threads end sharp"},
});

constexpr auto kLatheFeatures = std::to_array<FeatureRow>({
    {"live tools", kState, "fan-15-live",
     "M codes of [control.fanuc.live]: speed, S and feeds of a tool that turns"},
    {"T at G28 G53", kSim, "fan-5-latheoffset", "tool offset off in the block of a machine move only"},
    {"I K C R", kSim, "fan-3-chamfer fan-3-corner", "chamfers and corners of G01 without a comma"},
});

}  // namespace

CodeTable fanucLatheTable() { return {kLatheTableG, kLatheTableM, kLatheFeatures}; }
CodeTable haasLatheTable() { return {kHaasLatheTableG, {}, {}}; }
std::vector<CodeTable> fanucLatheSystemTables(GCodeSystem system) {
  switch (system) {
    case GCodeSystem::kA:
      return {{kLatheTableA, {}, {}}, {kContourCyclesAB, {}, {}}};
    case GCodeSystem::kB:
      return {{kLatheTableB, {}, {}}, {kLatheTableBC, {}, {}}, {kContourCyclesAB, {}, {}}};
    case GCodeSystem::kC:
      break;
  }
  return {{kLatheTableC, {}, {}}, {kLatheTableBC, {}, {}}, {kContourCyclesC, {}, {}}};
}
std::span<const std::int32_t> notInSystem(GCodeSystem system) {
  return system == GCodeSystem::kA ? std::span<const std::int32_t>(kNotInA)
                                   : std::span<const std::int32_t>(kNotInBAndC);
}

}  // namespace proveout::nc
