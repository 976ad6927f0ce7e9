// The tool table: G43 G43.1 G43.2 G49, G10 L0 L1 L10 L11.
#include <fmt/core.h>

#include "core/geometry/degrees.h"
#include "core/nc/linuxcnc/frames/frames.h"

namespace proveout::nc {
namespace {

bool lcnGiven(const IsoContext& c, int tool) {
  const OffsetTables& table = c.registers.offsets;
  for (const auto column : {OffsetColumn::kLength, OffsetColumn::kRadius, OffsetColumn::kX, OffsetColumn::kY})
    if (table.given(column, tool)) return true;
  return c.settings.gauge_lengths.contains(tool);
}

bool lcnAnyTool(const IsoContext& c) {
  for (int row = 1; row <= OffsetTables::kRows; ++row)
    if (lcnGiven(c, row)) return true;
  return false;
}

/// Tool number of H, D or P. False: reported.
bool lcnToolWord(IsoContext& c, const Word& w, int& tool) {
  std::int64_t number = 0;
  if (!lcnInteger(c, w, number)) return false;
  if (number < 0) return lcnFail(c, "tool", fmt::format("Negative {} word used", addressText(w.address)), &w);
  if (number > OffsetTables::kRows || !linuxCncHasTool(c, static_cast<int>(number)))
    return lcnFail(c, "tool", fmt::format("Requested tool {} not found in the tool table", number), &w);
  tool = static_cast<int>(number);
  return true;
}

void lcnAddWords(const IsoContext& c, const BlockPlan& plan, bool add, AxisPoint& length) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const double value = axisValue(c, plan, word, w);
    length[word.axis] = add ? length[word.axis] + value : value;
  }
}

bool performLcnToolData(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const LinuxCncToolData& data = own.tool_data;
  OffsetTables& table = c.registers.offsets;
  if (data.row == 0) {
    table = OffsetTables(c.settings);
    return performLinuxCncSteps(c, plan);
  }
  const auto set = [&](OffsetColumn column, const std::optional<double>& value) {
    if (!value) return;
    table.set(column, data.row, true, 0.0);
    table.set(column, data.row, false, *value);
  };
  set(OffsetColumn::kX, data.offset[0]);
  set(OffsetColumn::kY, data.offset[1]);
  set(OffsetColumn::kLength, data.offset[2]);
  set(OffsetColumn::kRadius, data.radius);
  if (data.tip) table.setTip(data.row, *data.tip);
  if (data.front) own.angles[data.row][0] = *data.front;
  if (data.back) own.angles[data.row][1] = *data.back;
  return performLinuxCncSteps(c, plan);
}

/// Where the tool stands in a system without its own length.
AxisPoint lcnPlaceIn(const IsoContext& c, const BlockPlan& plan, WorkSystemId system) {
  const CoordinateChain chain = c.registers.frames.chain(ProgramMap(), system, AxisPoint());
  (void)plan;
  return chain.programOf(c.machine);
}

}  // namespace

bool linuxCncHasTool(IsoContext& c, int tool) {
  if (tool == 0 || lcnGiven(c, tool)) return true;
  if (lcnAnyTool(c)) return false;
  c.warnOnce("tool table", "offset-missing",
             "the job has no tool table (tool_table, --offset): offsets and diameters of all tools are 0");
  return true;
}

AxisPoint linuxCncToolOffset(const IsoContext& c, int tool) {
  if (tool <= 0 || tool > OffsetTables::kRows) return {};
  const OffsetTables& table = c.registers.offsets;
  AxisPoint offset(table.effective(OffsetColumn::kX, tool), table.effective(OffsetColumn::kY, tool),
                   table.effective(OffsetColumn::kLength, tool));
  const auto gauge = c.settings.gauge_lengths.find(tool);
  if (!table.given(OffsetColumn::kLength, tool) && gauge != c.settings.gauge_lengths.end())
    offset[2] = gauge->second;
  return offset;
}

int linuxCncToolOf(const IsoContext& c, const BlockPlan& plan) {
  return plan.tool_change && plan.next.next_tool >= 0 ? plan.next.next_tool : c.state.tool;
}

bool planLcnLength(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupLengthComp];
  if (code == nullptr) return true;
  if (lcnCompOn(c, plan))
    return lcnFail(c, "comp", "Cannot change tool offset with cutter radius compensation on");
  IsoState& next = plan.next;
  const Word* h = c.word('H');
  int tool = linuxCncToolOf(c, plan);
  switch (code->code10) {
    case gcode::kLengthPlus:
      if (h != nullptr && !lcnToolWord(c, *h, tool)) return false;
      if (!linuxCncHasTool(c, tool))
        return lcnFail(c, "tool", fmt::format("Requested tool {} not found in the tool table", tool));
      next.length = linuxCncToolOffset(c, tool);
      next.h = tool;
      break;
    case lcn::kLengthByWords:
      lcnAddWords(c, plan, false, next.length);
      break;
    case lcn::kLengthAdded: {
      if (h == nullptr && !lcnAnyAxis(c))
        return lcnFail(c, "tool", "G43.2: No axes specified and H word missing");
      if (h == nullptr) {
        c.warnOnce("g43.2 axes", "version",
                   "G43.2 with axis words is of the documentation: the interpreter of 2.9 refuses it");
        lcnAddWords(c, plan, true, next.length);
        break;
      }
      if (!lcnToolWord(c, *h, tool)) return false;
      const AxisPoint more = linuxCncToolOffset(c, tool);
      for (int axis = 0; axis < kMaxAxes; ++axis) next.length[axis] += more[axis];
      break;
    }
    default:
      next.length = AxisPoint();
  }
  next.active[kGroupLengthComp] = code->code10;
  plan.claimed = plan.claimed | code->words;
  plan.frames_changed = plan.flush = true;
  return true;
}

bool planLcnData(IsoContext& c, BlockPlan& plan) {
  const Word* l = c.word('L');
  std::int64_t form = -1;
  if (l == nullptr) return lcnFail(c, "data", "L word missing with g10");
  if (!lcnInteger(c, *l, form)) return false;
  if (form == 2 || form == 20) return planLcnWorkOffset(c, plan, form == 20);
  LinuxCncToolData& data = linuxCncChannel(c).tool_data;
  data = LinuxCncToolData{};
  plan.perform = performLcnToolData;
  if (form == 0) return true;
  if (form != 1 && form != 10 && form != 11)
    return lcnFail(c, "data", "Line with G10 does not have L0, L1, L10, L11, L2, or L20", l);
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr) return lcnFail(c, "data", "P word missing with g10 l1, l10 or l11");
  if (!lcnToolWord(c, *p, data.row)) return false;
  if (data.row == 0) return lcnFail(c, "data", "tool 0 has no data", p);
  const bool by_place = form != 1;
  const WorkSystemId system = form == 11 ? linuxCncSystem(9) : plan.next.work_system;
  AxisPoint place = by_place ? lcnPlaceIn(c, plan, system) : AxisPoint();
  const double angle = by_place ? c.registers.frames.system(system).angles_deg.z() : 0.0;
  AxisSet named;
  AxisPoint difference;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    named.set(static_cast<std::size_t>(word.axis));
    const double value = axisValue(c, plan, word, w);
    difference[word.axis] = by_place ? place[word.axis] - value : value;
  }
  if (angle != 0.0 && (named[0] || named[1]))
    difference.xyz.head<2>() = Eigen::Rotation2Dd(degToRad(angle)) * difference.xyz.head<2>();
  for (int axis = 0; axis < kMainAxes; ++axis) {
    if (named[static_cast<std::size_t>(axis)]) data.offset[static_cast<std::size_t>(axis)] = difference[axis];
  }
  if (const Word* r = c.ownWord(plan, 'R')) data.radius = lengthOf(plan, *r);
  if (const Word* i = c.ownWord(plan, 'I')) data.front = i->value;
  if (const Word* j = c.ownWord(plan, 'J')) data.back = j->value;
  if (const Word* q = c.ownWord(plan, 'Q')) {
    std::int64_t tip = 0;
    if (!lcnInteger(c, *q, tip)) return false;
    if (tip < 0 || tip > 9) return lcnFail(c, "data", "Invalid tool orientation: Q is 0 to 9", q);
    data.tip = static_cast<int>(tip);
  }
  return true;
}

}  // namespace proveout::nc
