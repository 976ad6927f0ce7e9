#include "core/nc/iso/tools/tools.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/stages/tool_change.h"

namespace proveout::nc {
namespace {

/// Spindle magazines are 10, 20, ...: that of the channel.
ToolPlace spindlePlace(const IsoContext& c) { return {10 * c.channel(), 1}; }
/// M62 T10012: magazine 1, pocket 12.
constexpr int kPocketsPerMagazine = 10000;

bool namesPlace(const BlockPlan& plan) {
  for (int i = 0; i < plan.m_count; ++i) {
    if (plan.m[static_cast<std::size_t>(i)]->of_place) return true;
  }
  return false;
}

/// The seconds that the tool in the spindle has cut since they were last counted.
void countTime(IsoContext& c) {
  const double now = c.clock.cutting_s();
  const double cut = now - c.registers.tool_time_s;
  c.registers.tool_time_s = now;
  const ToolRow* tool = std::as_const(c.registers.tools()).row(c.state.tool_row);
  if (tool == nullptr || !tool->has(ToolRow::kByTime)) return;
  if (c.registers.tools().use(c.state.tool_row, cut)) {
    c.warn("tool-life",
           fmt::format("tool {} (row {}) will soon be at the end of its life", tool->type, c.state.tool_row),
           {}, Severity::kNote);
  }
}

void countUse(IsoContext& c, int row) {
  const ToolRow* tool = std::as_const(c.registers.tools()).row(row);
  if (tool == nullptr || tool->has(ToolRow::kByTime)) return;
  if (c.registers.tools().use(row, 1.0)) {
    c.warn("tool-life", fmt::format("tool {} (row {}) will soon be at the end of its life", tool->type, row),
           {}, Severity::kNote);
  }
}

/// Takes the machine to where it changes tools; the program goes on from there.
bool goToToolChange(IsoContext& c) {
  if (!c.settings.tool_change.any()) return true;
  if (!c.pipe.flush(FlushReason::kBuffer)) return false;
  const auto way = toolChangeWay(c.settings, c.emitter.machine(), c.stages.zone.ceiling(2));
  if (way.empty()) return true;
  c.origins.clear(unsaidBehind(c.settings.tool_change));
  for (const AxisPoint& to : way) {
    if (!sendMachineRapid(c, c.axisMap().namesAt(to))) return false;
  }
  if (c.stages.virtual_plane.linked()) {
    c.settle(way.back());
  } else {
    // Beside cutter compensation the programmed point is not the machine's: axes that stayed keep it.
    AxisPoint programmed = c.machine;
    const ToolChangePlace& place = c.settings.tool_change;
    const auto of = [&](int axis) -> double& { return programmed[c.axisMap().nameOf(axis)]; };
    of(2) = way.back()[2];
    if (place.x) of(0) = *place.x;
    if (place.y) of(1) = *place.y;
    c.settle(programmed);
  }
  c.rebasePipe();
  return true;
}

bool countsAtT(const IsoContext& c) { return c.parameters.flag(ToolParam::kLifeAtT); }

}  // namespace

bool planTool(IsoContext& c, BlockPlan& plan, const Word& t) {
  std::int64_t number = 0;
  if (!integerWord(c, t, 0, 99999999, number)) return false;
  const auto type = static_cast<int>(number);
  IsoState& next = plan.next;
  const ToolTables& tools = c.registers.tools();
  if (namesPlace(plan)) {
    const ToolPlace place{type / kPocketsPerMagazine, type % kPocketsPerMagazine};
    const int row = tools.at(place);
    const ToolRow* tool = tools.row(row);
    if (tool == nullptr) {
      return c.alarm(SharedAlarm::kOutOfRange, t,
                     fmt::format("magazine {} has no tool in pocket {}", place.magazine, place.pocket));
    }
    next.next_row = row;
    next.next_tool = tool->type;
    return true;
  }
  next.next_tool = type;
  next.next_row = 0;
  if (!tools.managed() || type == 0) return true;
  countTime(c);
  const auto row = tools.select(type);
  if (!row) {
    return c.failWord("no-tool",
                      fmt::format("no tool of type {} may be used: it is not in the tool management table, "
                                  "or all are expired or broken",
                                  type),
                      t);
  }
  next.next_row = *row;
  return true;
}

bool offsetRowOfTool(IsoContext& c, const Word& w, std::int64_t& row) {
  const auto code = static_cast<std::int64_t>(c.parameters[ToolParam::kOffsetCode]);
  if (code == 0 || !w.is_integer || w.value != static_cast<double>(code)) return true;
  const ToolRow* tool = std::as_const(c.registers.tools()).row(c.state.tool_row);
  if (tool == nullptr) {
    return c.alarm(SharedAlarm::kOutOfRange, w,
                   "it stands for the offset of the tool in the spindle, which tool management "
                   "does not know");
  }
  row = w.address == 'H' ? tool->length_row : tool->radius_row;
  return true;
}

bool sendToolShape(IsoContext& c) {
  const double corner = c.registers.offsets.effective(OffsetColumn::kCorner, c.state.d);
  return sendEvent(c, event::ToolShape{c.state.tool, c.state.d, 2.0 * std::abs(c.state.d_radius), corner});
}

bool sendToolChange(IsoContext& c, int type, int row) {
  if (!goToToolChange(c)) return false;
  countTime(c);
  c.state.tool = type;
  c.state.tool_row = row;
  ToolTables& tools = c.registers.tools();
  // A row may have been deleted after T had called it.
  if (tools.managed()) tools.place(spindlePlace(c), tools.row(row) ? row : 0);
  if (!countsAtT(c)) countUse(c, row);
  recordToolChange(c);
  PathItem item = functionItem(c, PathItem::Kind::kToolChange, c.state);
  item.value = type;
  if (row > 0) {
    item.event = std::make_unique<EventKind>(event::ToolChange{type, row});
  }
  return c.pipe.push(item);
}

void countToolCall(IsoContext& c, const BlockPlan& plan) {
  if (plan.next.next_row > 0 && countsAtT(c)) countUse(c, plan.next.next_row);
}

void ToolBank::addTo(VariableStore& store) {
  store.addBank(8400, 8414, *this);
  store.addBank(8431, 8450, *this);
}

VariableStatus ToolBank::read(int number, Value& out) {
  constexpr int kFirstUser = 8431;
  if (number == 8400) {
    out = Value{static_cast<double>(magazine_)};
    return VariableStatus::kDone;
  }
  if (magazine_ == spindlePlace(c_).magazine) countTime(c_);
  const int row = c_.registers.tools().at({magazine_, 1});
  const ToolRow* tool = std::as_const(c_.registers.tools()).row(row);
  out = number == 8401 ? Value{tool ? static_cast<double>(row) : 0.0} : Value::none();
  if (tool == nullptr || number == 8401) return VariableStatus::kDone;
  const std::array<double, 13> columns{static_cast<double>(tool->type),
                                       tool->counter,
                                       tool->limit,
                                       tool->warning,
                                       static_cast<double>(tool->status),
                                       static_cast<double>(tool->user_bits),
                                       static_cast<double>(tool->info),
                                       static_cast<double>(tool->length_row),
                                       static_cast<double>(tool->radius_row),
                                       tool->speed,
                                       tool->feed,
                                       static_cast<double>(tool->geometry_row),
                                       static_cast<double>(tool->wear_row)};
  if (number >= 8402 && number <= 8414) {
    out = Value{columns[static_cast<std::size_t>(number - 8402)]};
  } else if (number - kFirstUser < static_cast<int>(c_.parameters[ToolParam::kUserColumns])) {
    out = Value{tool->user[static_cast<std::size_t>(number - kFirstUser)]};
  }
  return VariableStatus::kDone;
}

VariableStatus ToolBank::write(int number, const Value& value) {
  if (number != 8400) return VariableStatus::kReadOnly;
  const double magazine = value.vacant ? 0.0 : value.number;
  // Spindle magazines are 10, 20, ... 90, the waiting ones 11, 21, ... 91.
  const bool known = magazine >= 10 && magazine <= 91 && magazine == std::floor(magazine) &&
                     std::fmod(magazine, 10.0) <= 1.0;
  if (!known) return VariableStatus::kLimit;
  magazine_ = static_cast<int>(magazine);
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
