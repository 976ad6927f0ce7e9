// Plans of the codes that set coordinate systems: G10 L2 and L20, G52, G92.
#include <fmt/core.h>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {

namespace {

/// The words of the block set what they name; G92 in a turned system all of the shift.
void recordSetters(IsoContext& c, const BlockPlan& plan, const FrameChange& change) {
  WorkFrames& frames = c.registers.frames;
  const bool turned =
      plan.governor->code10 == gcode::kSetPosition && !programMap(plan.next.transforms, c.axes).identity;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (change.id > 0 && w.address >= 'I' && w.address <= 'K') {
      auto& by = frames.system(change.id).angles_by;
      by[static_cast<std::size_t>('K' - w.address)] = numberOf(c, w, OriginKind::kData);
    } else if (axisWord(plan, w, word) && word.axis < kMainAxes) {
      auto& by = change.id >= 0 ? frames.system(change.id).offset_by : frames.shift_by;
      const std::uint32_t number = numberOf(c, w, OriginKind::kData);
      by[static_cast<std::size_t>(word.axis)] = number;
      if (turned) by.fill(number);
    }
  }
  recordFrames(c, plan.next);
}

bool performFrames(IsoContext& c, BlockPlan& plan) {
  const FrameChange& change = std::get<FrameChange>(plan.payload);
  WorkFrames& frames = c.registers.frames;
  frames.shift52 = change.shift52;
  frames.shift92 = change.shift92;
  if (change.id >= 0) frames.system(change.id) = change.system;
  recordSetters(c, plan, change);
  c.chain = c.chainOf(plan.next);
  c.position = c.chain.programOf(c.machine);
  return true;
}

FrameChange& frameChange(const IsoContext& c, BlockPlan& plan) {
  plan.perform = performFrames;
  plan.rebases = true;
  FrameChange& change = plan.payload.emplace<FrameChange>();
  change.shift52 = c.registers.frames.shift52;
  change.shift92 = c.registers.frames.shift92;
  return change;
}

}  // namespace

bool planLocalShift(IsoContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord()) return c.alarm(SharedAlarm::kMissingData, "", "G52 needs axis words");
  FrameChange& change = frameChange(c, plan);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const double value = axisValue(c, plan, word, w);
    const bool adds = word.step && !c.dialect.rules.local_shift_absolute;
    change.shift52[word.axis] = adds ? change.shift52[word.axis] + value : value;
  }
  return true;
}

bool planSetPosition(IsoContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord() && c.word('S')) {  // only the limit of G96
    plan.motion.target = plan.start;
    return true;
  }
  const std::string name = gName(plan.governor->number10());
  if (!c.anyAxisWord()) return c.alarm(SharedAlarm::kMissingData, "", name + " needs axis words or S");
  FrameChange& change = frameChange(c, plan);
  const AxisPoint work = plan.chain->workOf(plan.start);
  AxisPoint position = plan.start;
  AxisSet given;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (given[static_cast<std::size_t>(word.axis)])
      return c.alarm(SharedAlarm::kIllegalAddress, w, "the axis is given twice in this block");
    given.set(static_cast<std::size_t>(word.axis));
    if (word.own_step && !c.dialect.rules.set_position_steps)
      return c.alarm(SharedAlarm::kIncremental, w, "G92 words are absolute");
    const double value = (word.own_step ? plan.start[word.axis] : 0.0) + axisValue(c, plan, word, w);
    change.shift52[word.axis] = 0.0;
    change.shift92[word.axis] = work[word.axis] - value;
    position[word.axis] = value;
    if (word.axis < kMainAxes) plan.next.held.axes.reset(static_cast<std::size_t>(word.axis));
  }
  const ProgramMap map = programMap(plan.next.transforms, c.axes);
  if (map.identity) return true;
  // A rotation mixes the axes: all of them are shifted so that the position becomes what is written.
  const AxisPoint image = map.image(position);
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    change.shift92[axis] = work[axis] - image[axis] - change.shift52[axis];
  }
  return true;
}

bool planShiftsOff(IsoContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord())
    return c.alarm(SharedAlarm::kMissingData, "", "G92.1 needs the axes whose shifts end, as in G92.1 X0");
  FrameChange& change = frameChange(c, plan);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word)) change.shift52[word.axis] = change.shift92[word.axis] = 0.0;
  }
  return true;
}

bool planWorkOffset(IsoContext& c, BlockPlan& plan) {
  const bool basic = c.word('L')->value == 2.0;
  const Word* p = c.ownWord(plan, 'P');
  std::int64_t row = 0;
  if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "G10 needs P");
  for (const Address a : {'R', 'Q'}) {
    if (const Word* w = c.word(a)) return c.alarm(SharedAlarm::kIllegalAddress, *w, "in G10 L2, L20");
  }
  if (!integerWord(c, *p, basic ? 0 : 1, basic ? 6 : c.dialect.rules.extended_systems, row)) return false;
  plan.flush = true;  // the frame of the compensated path changes
  FrameChange& change = frameChange(c, plan);
  const WorkSystemId id = basic ? static_cast<int>(row) : kFirstExtended + static_cast<int>(row) - 1;
  change.id = id;
  change.system = c.registers.frames.system(id);
  WorkSystem& system = change.system;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (w.address >= 'I' && w.address <= 'K') {
      c.asked.add(w.address);
      if (id == 0)
        return c.failWord(
            SharedAlarm::kIllegalAddress,
            fmt::format("illegal address {}: the common offset has no rotation", addressText(w.address)), w);
      const int about = 'K' - w.address;  // I turns about Z, J about Y, K about X
      system.angles_deg[about] = (plan.next.incremental() ? system.angles_deg[about] : 0.0) + w.value;
    } else if (axisWord(plan, w, word)) {
      system.offset[word.axis] = (word.step ? system.offset[word.axis] : 0.0) + axisValue(c, plan, word, w);
    }
  }
  return true;
}

}  // namespace proveout::nc
