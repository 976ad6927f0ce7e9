#include "core/nc/fanuc/lathe/lathe_hooks.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/nc/fanuc/block/plan.h"
#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_settings.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/fanuc/text/decimal.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/perform/unused_words.h"
#include "core/tool/tip.h"

namespace proveout::nc {
namespace {

/// The row behind the point of "offset_x.3"; 0: it is another setting.
int rowOfSetting(std::string_view key, std::string_view name) {
  if (!key.starts_with(name) || key.size() <= name.size() + 1 || key[name.size()] != '.') return 0;
  int row = 0;
  const char* const last = key.data() + key.size();
  const auto [end, error] = std::from_chars(key.data() + name.size() + 1, last, row);
  return error == std::errc() && end == last && row >= 1 && row <= OffsetTables::kRows ? row : 0;
}

void takeOffsets(IsoContext& c) {
  struct Setting {
    FanucParam name;
    OffsetColumn column;
    bool wear;
  };
  constexpr auto kSettings = std::to_array<Setting>({
      {FanucParam::kOffsetX, OffsetColumn::kX, false},
      {FanucParam::kOffsetZ, OffsetColumn::kLength, false},
      {FanucParam::kWearX, OffsetColumn::kX, true},
      {FanucParam::kWearZ, OffsetColumn::kLength, true},
      {FanucParam::kNoseRadius, OffsetColumn::kRadius, false},
  });
  for (const auto& [key, value] : c.settings.parameters) {
    for (const Setting& s : kSettings) {
      const int row = rowOfSetting(key, c.parameters.name(s.name));
      if (row > 0) c.registers.offsets.set(s.column, row, s.wear, value);
    }
    const int row = rowOfSetting(key, c.parameters.name(FanucParam::kTip));
    if (row > 0 && value >= 0.0 && value <= 9.0) c.registers.offsets.setTip(row, static_cast<int>(value));
  }
}

/// H is the incremental word of C. False: there is no such axis, reported.
bool takeStepsOfC(IsoContext& c) {
  if (!c.block.present.has('H')) return true;
  for (Word& w : c.block.words) {
    if (w.address != 'H') continue;
    const int axis = c.axes.find("C");
    if (axis < 0)
      return c.failWord(SharedAlarm::kIllegalAddress, "illegal address H: the machine has no axis C", w);
    w.address = 'C';
    w.axis = static_cast<std::int8_t>(axis);
    w.incremental = true;
  }
  c.block.present = {};
  for (const Word& w : c.block.words) c.block.present.add(w.address);
  return true;
}

/// U, V and W are steps in system A only; cycles, G04 and G10 have words of these letters in all of them.
bool checkSteps(IsoContext& c, const BlockPlan& plan) {
  constexpr std::int32_t kDwellCode = 40, kDataCode = 100;
  if (c.parameters[FanucParam::kGcodeSystem] == 0.0 || plan.governor == nullptr) return true;
  const std::int32_t code = plan.governor->code10;
  const bool own_words = code >= lathe_code::kFinish && code <= lathe_code::kPattern;
  if (own_words || code == kDwellCode || code == kDataCode) return true;
  for (const Word& w : c.block.words) {
    if (w.axis >= 0 || w.address < 'U' || w.address > 'W') continue;
    return c.failWord(SharedAlarm::kIllegalAddress,
                      fmt::format("illegal address {}: steps are programmed by G91 in this system of G codes",
                                  addressText(w.address)),
                      w);
  }
  return true;
}

/// Arcs of more than half a turn are written by their centre.
bool checkRadius(IsoContext& c, const BlockPlan& plan) {
  const int code = plan.governor->code10;
  if (code != gcode::kArcClockwise && code != gcode::kArcCounterClockwise) return true;
  const Word* r = c.block.find('R');
  return r == nullptr || r->value >= 0.0 ||
         c.failWord("023", "a negative radius cannot be used on a lathe: write I and K", *r);
}

/// The nose that compensation counts with, where it was not in the tables.
void tellNose(IsoContext& c, const BlockPlan& plan) {
  if (plan.by_group[kGroupRadiusComp] == nullptr || !plan.next.compOn()) return;
  const int row = plan.next.d;
  if (row == 0 || c.registers.offsets.given(OffsetColumn::kRadius, row)) return;
  const bool known = plan.next.d_radius != 0.0;
  if (!c.firstTime(fmt::format("nose {}", row))) return;
  c.warn("offset-missing",
         known ? fmt::format("offset {0} has no nose radius: that of the tool is taken, {1:g} mm, tip {2} "
                             "(nose_radius.{0} and tip.{0} of the control say others)",
                             row, plan.next.d_radius, plan.next.d_tip)
               : fmt::format("offset {0} has no nose radius: 0 is taken (nose_radius.{0}, tip.{0})", row),
         {}, known ? Severity::kNote : Severity::kWarning);
}

/// Nose radius and tip of the tool itself, for rows that have none.
void takeNoseOfTool(const IsoContext& c, int tool, IsoState& next) {
  const auto mount = c.settings.inserts.find(tool);
  if (mount == c.settings.inserts.end()) return;
  const Vec2& center = mount->second.nose_center;  // (x, z) from the touch-off point
  const double radius = center.cwiseAbs().maxCoeff();
  if (!(radius > 0.0)) return;
  next.d_radius = radius;
  const auto sign = [&](double v) { return v > 1e-9 ? -1.0 : v < -1e-9 ? 1.0 : 0.0; };
  const Vec2 direction(sign(center.x()), sign(center.y()));
  for (int tip = 1; tip <= 8; ++tip) {
    if (tipDirection(tip) == direction) next.d_tip = tip;
  }
}

}  // namespace

std::unique_ptr<MakerData> makeLatheData(IsoContext& c) {
  takeOffsets(c);
  return std::make_unique<LatheData>();
}

void latheAtPowerOn(const IsoContext& c, IsoState& state) {
  fanucPowerOn(c, state);
  state.axes.diameter.set(0);
  if (!c.parameters.given(MotionParam::kDefaultG95)) state.active[kGroupFeedMode] = gcode::kFeedPerTurn;
  state.surface_axis = 0;
}

bool takeLatheWords(IsoContext& c) { return takeStepsOfC(c) && takeFanucWords(c); }

void latheBegin(IsoContext& c) {
  fanucBegin(c);
  checkLiveCodes(c);
}

namespace {

/// The block of T takes the wear offset of axes along that have no word in it.
bool performWear(IsoContext& c, BlockPlan& plan) {
  for (int axis = 0; axis < kMainAxes; ++axis) plan.motion.target[axis] += latheData(c).wear_way[axis];
  return performMove(c, plan);
}

/// The same of a block without motion.
bool performWearAlone(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  return performWear(c, plan);
}

/// `wear_moves`: what T changes of the wear offset moves the tool in this block, or waits for the next
/// motion.
bool planWear(IsoContext& c, BlockPlan& plan) {
  HeldWay& held = plan.next.held;
  if (!plan.tool_called || !(held.axes & held.in_steps).any()) return true;
  noteSetting(
      c, FanucParam::kWearMoves,
      "the wear offset moves the tool with the axis's next motion (\"next\"), on some with the block of "
      "T (\"t_block\", 5002#6 LWM)");
  const bool moves = plan.perform == performMove && !plan.motion.is_arc;
  if (!c.parameters.flag(FanucParam::kWearMoves) || (plan.perform != nullptr && !moves)) return true;
  Vec3& way = latheData(c).wear_way;
  way = Vec3::Zero();
  for (int axis = 0; axis < kMainAxes; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    if (!held.axes[k] || !held.in_steps[k]) continue;
    way[axis] = held.way[axis];
    held.axes.reset(k);
    held.in_steps.reset(k);
    held.of_length.reset(k);
  }
  plan.perform = moves ? performWear : performWearAlone;
  if (moves) return true;
  plan.motion.rapid = plan.next.active[kGroupMotion] == gcode::kRapid;
  for (int axis = 0; axis < kMainAxes; ++axis) plan.motion.target[axis] = plan.start[axis] + way[axis];
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

}  // namespace

bool planLatheBlock(IsoContext& c, BlockPlan& plan) {
  if (!planFanuc(c, plan) || !checkSteps(c, plan)) return false;
  tellLiveTool(c, plan);
  if (!planWear(c, plan)) return false;
  if (!checkRadius(c, plan)) return false;
  tellNose(c, plan);
  const Word* d = c.block.find('D');
  if (d != nullptr && !plan.governor->words.has('D'))
    tellUnused(c, *d, gName(plan.governor->number10()), "T names the offsets of a lathe");
  for (int i = 0; i < plan.m_count; ++i) {
    const int m = plan.m_value[static_cast<std::size_t>(i)];
    if (m == 23 || m == 24) latheData(c).run_out = m == 23;
  }
  return true;
}

bool planLatheTool(IsoContext& c, BlockPlan& plan, const Word& t) {
  std::int64_t number = 0;
  const int base = c.parameters[FanucParam::kLatheT] == 0.0 ? 100 : 10;  // digits of the offset
  if (!integerWord(c, t, 0, 9999, number)) return false;
  const auto tool = static_cast<int>(number / base), offset = static_cast<int>(number % base);
  IsoState& next = plan.next;
  if (tool > 0) {
    next.next_tool = tool;
    next.next_row = 0;
    plan.tool_change = tool != c.state.tool;
  }
  plan.flush = plan.frames_changed = true;
  const OffsetTables& table = c.registers.offsets;
  const int in_hand = tool > 0 ? tool : c.state.tool;
  const bool by_tool = c.parameters.flag(FanucParam::kGeometryBy);
  // A spindle of which no tool is known has no row.
  const int geometry = std::clamp(offset == 0 ? 0 : by_tool ? in_hand : offset, 0, OffsetTables::kRows);
  next.h = next.d = offset;
  const double half = next.axes.diameter[0] ? 0.5 : 1.0;
  const auto geometryOf = [&](OffsetColumn column) { return table.value(column, geometry).geometry; };
  const auto wearOf = [&](OffsetColumn column) { return table.value(column, offset).wear; };
  const AxisPoint shift(half * geometryOf(OffsetColumn::kX), geometryOf(OffsetColumn::kY),
                        geometryOf(OffsetColumn::kLength));
  const AxisPoint wear(half * wearOf(OffsetColumn::kX), wearOf(OffsetColumn::kY),
                       wearOf(OffsetColumn::kLength));
  for (int axis = 0; axis < kMainAxes; ++axis) {
    plan.length_shift[axis] = shift[axis] - latheData(c).geometry[axis];
    next.length[axis] = shift[axis] + wear[axis];
  }
  latheData(c).geometry = shift;
  next.h_value = next.length[2];
  next.d_radius = geometryOf(OffsetColumn::kRadius) + wearOf(OffsetColumn::kRadius);
  next.d_tip = table.tip(geometry);
  if (offset > 0 && !table.given(OffsetColumn::kRadius, geometry)) takeNoseOfTool(c, in_hand, next);
  return true;
}

}  // namespace proveout::nc
