#include "core/nc/fanuc/block/plan.h"

#include <fmt/core.h>

#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/tools/offsets.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {
namespace {

constexpr std::int32_t kNurbsCode = 62, kSpaceArc = 24, kSpaceArcCcw = 34;

/// A curve of several blocks must not be left half-way.
bool checkOpenCurve(IsoContext& c, const BlockPlan& plan) {
  const CurveInput& curve = fanucData(c).curve;
  if (!curve.open()) return true;
  const int code = plan.governor != nullptr ? plan.governor->code10 : -1;
  if (curve.order > 0 && code != kNurbsCode)
    return c.fail("5117",
                  "NURBS: the list of knots is not complete: as many as points and the order together");
  const bool arc = code == kSpaceArc || code == kSpaceArcCcw;
  if (curve.arc && !arc && plan.perform != nullptr)
    return c.fail("5432", "the arc in space has its middle, but no block for its end");
  return true;
}

void noteDefault(IsoContext& c, const BlockPlan& plan, IsoGroup group, std::string_view key, bool given) {
  FanucData& data = fanucData(c);
  if (data.programmed[group] || data.noted[group]) return;
  data.noted.set(group);
  noteSettingOf(c, key, given,
                fmt::format("the program moves and has not told {} before: {} holds from power-on",
                            group == kGroupUnits         ? "G20 or G21"
                            : key == "power_on_distance" ? "G90 or G91"
                            : key == "power_on_motion"   ? "G00 or G01"
                                                         : "its plane",
                            gName(plan.next.active[group])));
}

/// Codes of power-on that the block's motion depends on.
void noteDefaults(IsoContext& c, const BlockPlan& plan) {
  FanucData& data = fanucData(c);
  for (std::size_t g = 1; plan.any_group && g < kGroupCount; ++g) {
    if (plan.by_group[g] != nullptr) data.programmed.set(g);
  }
  if (data.all_told || plan.perform == nullptr || plan.motion.named.none()) return;
  const auto given = [&](auto p) { return c.parameters.given(p); };
  const bool by_setting = isHaas(c) && !given(MotionParam::kDefaultG20);
  noteDefault(c, plan, kGroupUnits, by_setting ? "setting_9" : "power_on_units",
              by_setting ? given(FanucParam::kSetting9) : given(MotionParam::kDefaultG20));
  if (!isLathe(c)) noteDefault(c, plan, kGroupDistance, "power_on_distance", given(MotionParam::kDefaultG91));
  const bool modal = plan.governor != nullptr && plan.governor->group == kGroupMotion;
  if (modal) noteDefault(c, plan, kGroupMotion, "power_on_motion", given(MotionParam::kDefaultG1));
  const bool plane = plan.motion.is_arc || plan.next.compOn();
  if (plane) noteDefault(c, plan, kGroupPlane, "power_on_plane", given(FanucParam::kPowerOnPlane));
  const auto known = data.programmed | data.noted;
  data.all_told = known[kGroupUnits] && known[kGroupDistance] && known[kGroupMotion] && known[kGroupPlane];
}

void noteUnits(IsoContext& c, const BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupUnits];
  if (code == nullptr || code->code10 == c.state.active[kGroupUnits]) return;
  if (!fanucData(c).programmed[kGroupUnits] || !c.firstTime("units change")) return;
  c.warn(
      "units",
      fmt::format("{} changes the unit: numbers of the program count in it from here on, offsets and frames "
                  "keep their size (parameter 5006#0)",
                  gName(code->code10)),
      {}, Severity::kNote);
}

void noteFixture(IsoContext& c, const BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupWorkSystem];
  if (code == nullptr || code->code10 != gcode::kDynamicZero || plan.next.five.dynamic_zero == 0) return;
  c.warnOnce(
      "G54.2", "fixture-offset",
      "the row of G54.2 (G10 L21) is the zero itself here, in machine coordinates, in place of G54; some "
      "controls add it to the work frame in force",
      {}, Severity::kNote);
}

/// A length offset that G28, G30 or G53 has ended is there again with the next motion of the axis.
void noteLength(IsoContext& c, const BlockPlan& plan) {
  FanucData& data = fanucData(c);
  if (data.no_length.none()) return;
  if (plan.by_group[kGroupLengthComp] != nullptr || c.block.present.has('H')) {
    data.no_length.reset();
    return;
  }
  if (plan.perform == nullptr || std::holds_alternative<MachineMove>(plan.payload) ||
      (data.no_length & plan.motion.named).none())
    return;
  data.no_length &= ~plan.motion.named;
  if (!c.firstTime("length ended")) return;
  c.warn("length-ended",
         "G28, G30 or G53 has ended the length offset of this axis, and no G43 has come since: here it acts "
         "again with this motion; other machines need a new G43 (parameter 5001#6)",
         {}, Severity::kNote);
}

}  // namespace

std::unique_ptr<MakerData> makeFanucData(IsoContext&) { return std::make_unique<FanucData>(); }

bool planFanuc(IsoContext& c, BlockPlan& plan) {
  if (!planBlock(c, plan)) return false;
  const FanucData& data = fanucData(c);
  const bool quiet = data.all_told && !data.curve.open() && data.no_length.none();
  if (quiet && !plan.any_group) return true;  // a block of the words that hold
  if (!checkOpenCurve(c, plan)) return false;
  noteUnits(c, plan);
  noteDefaults(c, plan);
  noteFixture(c, plan);
  noteLength(c, plan);
  return true;
}

void fanucPowerOn(const IsoContext& c, IsoState& state) {
  const bool inch = isHaas(c) && c.parameters.flag(FanucParam::kSetting9);
  if (inch && !c.parameters.given(MotionParam::kDefaultG20)) state.active[kGroupUnits] = gcode::kInch;
  const int given = static_cast<int>(c.parameters[FanucParam::kPowerOnPlane]);
  const int plane = given != 0 ? given : isLathe(c) ? 18 : 17;
  state.active[kGroupPlane] = 10 * plane;
  state.takeMainPlane();
}

namespace {

/// Settings of Haas in a job of another flavour.
void tellSettingsOfHaas(IsoContext& c) {
  for (const FanucParam setting : {FanucParam::kSetting9, FanucParam::kLocalShift}) {
    if (isHaas(c) || !c.parameters.given(setting)) continue;
    c.warn("setting", fmt::format("{} is a setting of Haas: it does nothing without flavour = \"haas\"",
                                  c.parameters.name(setting)));
  }
}

}  // namespace

void fanucBegin(IsoContext& c) {
  tellSettingsOfHaas(c);
  fanucJoinOffsets(c);
  if (c.parameters.flag(FanucParam::kRapid)) return;
  c.stages.dogleg.configure([&c] {
    noteSetting(c, FanucParam::kRapid,
                "on a rapid each axis goes at its own rate, so the way has corners (\"dogleg\", parameter "
                "1401#1 LRP = 0); with \"linear\" it is straight");
  });
  c.pipe.link(c.stages.dogleg);
}

void fanucEndShifts(IsoContext& c) {
  WorkFrames& frames = c.registers.frames;
  if (!c.parameters.flag(FanucParam::kKeepG52)) frames.shift52 = AxisPoint();
  if (!c.parameters.flag(FanucParam::kKeepG92)) frames.shift92 = AxisPoint();
  fanucData(c) = FanucData();
}

bool fanucUnknownM(IsoContext& c, const Word& word, int number) {
  if (c.parameters.flag(FanucParam::kStrictM)) {
    return c.failWord(
        "m-function",
        fmt::format("M{} is a function of the machine builder, and strict_m allows none", number), word);
  }
  if (c.firstTime(fmt::format("M{}", number))) {
    c.warn("m-function",
           fmt::format("M{} is a function of the machine builder: it has no effect in the simulation (told "
                       "once)",
                       number),
           word.columns, Severity::kNote);
  }
  return true;
}

}  // namespace proveout::nc
