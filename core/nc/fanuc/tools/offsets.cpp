// H and D of a block, axes of length offsets (iso-fanuc, sections 7 and 8).
#include "core/nc/fanuc/tools/offsets.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

/// The tool that the block works with.
int toolOf(const IsoContext& c, const BlockPlan& plan) {
  return plan.tool_change && plan.next.next_tool >= 0 ? plan.next.next_tool : c.state.tool;
}

bool fanucOffsetRow(IsoContext& c, const Word& w, int& row) {
  const auto most = c.parameters[CompParam::kToolOffsets];
  const double value = w.from_expression ? std::round(w.value) : w.value;
  if ((!w.is_integer && !w.from_expression) || !(value >= 0.0 && value <= most)) {
    return c.failWord("030",
                      fmt::format("illegal offset number {}{:g}: an integer from 0 to {:g} is expected",
                                  addressText(w.address), w.value, most),
                      w);
  }
  row = static_cast<int>(value);
  return true;
}

/// Told when a number without a value is used; `instead`: what is taken.
void tellMissing(IsoContext& c, const Word& w, int row, int tool, const std::string& instead) {
  const auto name = fmt::format("{}{}", addressText(w.address), row);
  c.warnOnce(fmt::format("{} tool {}", name, tool), "offset-missing",
             fmt::format("tool {1}: {0} has no value in the offset table, {2} is taken (--offset {0}=VALUE)",
                         name, tool, instead),
             w.columns);
}

void takeRadius(IsoContext& c, BlockPlan& plan, const Word& d) {
  IsoState& next = plan.next;
  const OffsetTables& table = c.registers.offsets;
  next.d_radius = table.effective(OffsetColumn::kRadius, next.d);
  next.d_tip = table.tip(next.d);
  if (next.d == 0 || table.given(OffsetColumn::kRadius, next.d)) return;
  const int tool = toolOf(c, plan);
  const auto own = c.settings.tool_radii.find(tool);
  const bool by_tool = c.parameters[FanucParam::kDefaultD] == 0.0 && own != c.settings.tool_radii.end();
  next.d_radius = by_tool ? own->second : 0.0;
  tellMissing(c, d, next.d, tool,
              by_tool ? fmt::format("the tool's own radius {:g} mm (d_default)", own->second) : "0");
}

}  // namespace

FanucMemory fanucOffsetMemory(const IsoContext& c) {
  return static_cast<FanucMemory>(static_cast<int>(c.parameters[FanucParam::kOffsetMemory]));
}

double fanucRadiusFactor(const IsoContext& c) {
  const bool haas = c.parameters[FanucParam::kFlavour] == kHaasFlavour;  // Setting 40
  const bool diameters = c.parameters.given(FanucParam::kDiameterOffsets)
                             ? c.parameters[FanucParam::kDiameterOffsets] != 0.0
                             : haas;
  return diameters ? 2.0 : 1.0;
}

void fanucJoinOffsets(IsoContext& c) {
  const FanucMemory memory = fanucOffsetMemory(c);
  if (memory == FanucMemory::kC) return;
  OffsetTables& table = c.registers.offsets;
  const auto copy = [&](OffsetColumn from, OffsetColumn to, int row) {
    if (!table.given(from, row) || table.given(to, row)) return;
    const OffsetValue value = table.value(from, row);
    table.set(to, row, false, value.geometry);
    table.set(to, row, true, value.wear);
  };
  const auto tell = [&](const auto& rows) {
    for (const auto& entry : rows) {
      const int row = entry.first;
      if (row < 1 || row > OffsetTables::kRows) continue;
      copy(OffsetColumn::kLength, OffsetColumn::kRadius, row);
      copy(OffsetColumn::kRadius, OffsetColumn::kLength, row);
      const double h = table.effective(OffsetColumn::kLength, row);
      const double d = table.effective(OffsetColumn::kRadius, row);
      if (h != d)
        c.warnOnce(
            fmt::format("row {}", row), "offset-memory",
            fmt::format("the job gives H{0} and D{0} different values, and this memory (offset_memory) "
                        "has one for both: each keeps its own here",
                        row));
    }
  };
  tell(c.settings.length_offsets);
  tell(c.settings.radius_offsets);
}

bool fanucOffsets(IsoContext& c, BlockPlan& plan) {
  if (!plan.any_group && (c.block.present & AddressSet("HD")).empty()) return true;
  IsoState& next = plan.next;
  const OffsetTables& table = c.registers.offsets;
  if (const Word* h = c.word('H')) {
    if (!fanucOffsetRow(c, *h, next.h)) return false;
    next.h_value = table.effective(OffsetColumn::kLength, next.h);
    if (next.h > 0 && !table.given(OffsetColumn::kLength, next.h))
      tellMissing(c, *h, next.h, toolOf(c, plan), "0");
  }
  if (const Word* d = c.word('D')) {
    if (!fanucOffsetRow(c, *d, next.d)) return false;
    takeRadius(c, plan, *d);
  }
  const GCode* length = plan.by_group[kGroupLengthComp];
  if (length != nullptr && length->code10 != gcode::kLengthOff && next.h == 0 && !c.block.present.has('H')) {
    c.warnOnce("G43 without H", "no-h",
               fmt::format("no H is programmed: {} takes a length of 0", gName(length->number10())));
  }
  return true;
}

bool fanucLengthAxes(IsoContext& c, const BlockPlan& plan, AxisSet& axes) {
  axes.reset();
  const double type = c.parameters[FanucParam::kLengthType];
  if (type == 0.0) {
    axes.set(2);
  } else if (type == 1.0) {
    axes.set(static_cast<std::size_t>(plan.next.workPlane().w));
  } else {
    for (const Word& w : c.block.words) {
      AxisWord word;
      if (axisWord(plan, w, word)) axes.set(static_cast<std::size_t>(word.axis));
    }
    const bool called = plan.by_group[kGroupLengthComp] != nullptr;
    if (called && axes.none())
      return c.fail("027", "no axes commanded in G43 or G44: the axis has to stand beside the code (type C)");
    for (int axis = 0; !called && axis < c.axes.count(); ++axis)
      axes.set(static_cast<std::size_t>(axis), c.state.length[axis] != 0.0);
  }
  bool named = false;
  for (const Word& w : c.block.words) {
    AxisWord word;
    named = named || (axisWord(plan, w, word) && axes[static_cast<std::size_t>(word.axis)]);
  }
  if (plan.by_group[kGroupLengthComp] != nullptr && !named) {
    c.warnOnce("length alone", "length-waits",
               fmt::format("{} without its axis: the offset acts with the axis's next motion; some controls "
                           "move the axis at once",
                           gName(plan.next.active[kGroupLengthComp])),
               {}, Severity::kNote);
  }
  return true;
}

void fanucCompensation(const IsoParameters& parameters, CutterCompPolicy& policy) {
  const double type = parameters[FanucParam::kCompStartUp];  // 0 A, 1 B, 2 C
  policy.start_ramp = policy.cancel_ramp = type == 1.0 ? CompRamp::kB : CompRamp::kA;
  policy.start_waits = type != 2.0;
  policy.cancel_waits = true;
  policy.interference_alarm = true;
  policy.most_idle = 1;
  policy.flush_square = policy.keeps_vector = true;
  policy.chord_check = policy.contour_check = false;
  policy.max_pass_through = 1'000'000;
  policy.arc_needs_room = true;
  policy.square_side_change = true;
}

}  // namespace proveout::nc
