// Plans of the codes that set registers: G10, G52, G92.
#include <fmt/core.h>

#include "core/nc/nct/nct_perform.h"
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/nct_words.h"

namespace proveout::nc {

namespace {

/// New values of the shifts and of one work system.
struct FrameChange {
  AxisPoint shift52, shift92;
  WorkSystemId id = -1;  ///< -1: no work system changes
  WorkSystem system;
};

bool performFrames(NctContext& c, BlockPlan& plan) {
  const FrameChange& change = plan.payload.as<FrameChange>();
  WorkFrames& frames = c.registers.frames;
  frames.shift52 = change.shift52;
  frames.shift92 = change.shift92;
  if (change.id >= 0) frames.system(change.id) = change.system;
  c.chain = frames.chain(plan.next.work_system, plan.next.length);
  c.position = c.chain.programOf(c.machine);
  return true;
}

FrameChange& frameChange(const NctContext& c, BlockPlan& plan) {
  plan.perform = performFrames;
  plan.rebases = true;
  FrameChange& change = plan.payload.emplace<FrameChange>();
  change.shift52 = c.registers.frames.shift52;
  change.shift92 = c.registers.frames.shift92;
  return change;
}

/// A new value of one row of the tool offset tables.
struct OffsetChange {
  int row = 0;
  int table = 0;  ///< L of G10: 10, 11, 12, 13
  double value = 0.0;
};

bool performOffset(NctContext& c, BlockPlan& plan) {
  const OffsetChange& change = plan.payload.as<OffsetChange>();
  auto& table = change.table < 12 ? c.registers.length_offsets : c.registers.radius_offsets;
  OffsetValue& row = table[change.row];
  (change.table % 2 == 0 ? row.geometry : row.wear) = change.value;
  return true;
}

bool planToolOffset(NctContext& c, BlockPlan& plan, int kind, const Word& p);
bool planWorkOffset(NctContext& c, BlockPlan& plan, int kind, const Word& p);

}  // namespace

bool planLocalShift(NctContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord()) return c.alarm(2004, "", "G52 needs axis words");
  FrameChange& change = frameChange(c, plan);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const double value = axisValue(c, plan, word, w);
    change.shift52[word.axis] = word.step ? change.shift52[word.axis] + value : value;
  }
  return true;
}

bool planSetPosition(NctContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord()) return c.alarm(2004, "", "G92 needs axis words");
  FrameChange& change = frameChange(c, plan);
  const AxisPoint work = plan.chain->workOf(plan.start);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.own_step) return c.alarm(2097, w, "G92 words are absolute");
    change.shift52[word.axis] = 0.0;
    change.shift92[word.axis] = work[word.axis] - axisValue(c, plan, word, w);
  }
  return true;
}

bool planOffsets(NctContext& c, BlockPlan& plan) {
  const Word* l = c.ownWord(plan, 'L');
  std::int64_t kind = 0;
  if (l == nullptr) return c.alarm(2004, "L", "G10 needs L");
  if (!integerWord(c, *l, 0, 9999, kind)) return false;
  if (kind != 2 && kind != 20 && (kind < 10 || kind > 13)) {
    return c.failWord(
        "nct-2123",
        fmt::format("function not implemented: G10 L{} is not supported (L2, L10 to L13, L20 are)", kind),
        *l);
  }
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr) return c.alarm(2004, "P", "G10 needs P");
  if (kind >= 10 && kind <= 13) return planToolOffset(c, plan, static_cast<int>(kind), *p);
  return planWorkOffset(c, plan, static_cast<int>(kind), *p);
}

namespace {

bool planToolOffset(NctContext& c, BlockPlan& plan, int kind, const Word& p) {
  std::int64_t row = 0;
  if (!integerWord(c, p, 1, static_cast<std::int64_t>(c.parameters[CompParam::kToolOffsets]), row))
    return false;
  const Word* r = c.word('R');
  if (r == nullptr) return c.alarm(2004, "R", "the value of the offset");
  if (c.anyAxisWord() || !(c.block.present & AddressSet("IJK")).empty()) {
    return c.fail("nct-2017", "illegal address: G10 L10 to L13 takes P and R");
  }
  const auto& table = kind < 12 ? c.registers.length_offsets : c.registers.radius_offsets;
  const auto found = table.find(static_cast<int>(row));
  const OffsetValue old = found == table.end() ? OffsetValue{} : found->second;
  const bool add = r->incremental || plan.next.incremental();
  const double base = kind % 2 == 0 ? old.geometry : old.wear;
  plan.payload.emplace<OffsetChange>() = {static_cast<int>(row), kind,
                                          (add ? base : 0.0) + lengthOf(plan, *r)};
  plan.perform = performOffset;
  return true;
}

bool planWorkOffset(NctContext& c, BlockPlan& plan, int kind, const Word& p) {
  std::int64_t row = 0;
  if (const Word* r = c.word('R')) return c.failWord("nct-2017", "illegal address R in G10 L2, L20", *r);
  if (!integerWord(c, p, kind == 2 ? 0 : 1, kind == 2 ? 6 : 99, row)) return false;
  plan.flush = true;  // the frame of the compensated path changes
  FrameChange& change = frameChange(c, plan);
  const WorkSystemId id = kind == 2 ? static_cast<int>(row) : kFirstExtended + static_cast<int>(row) - 1;
  change.id = id;
  change.system = c.registers.frames.system(id);
  WorkSystem& system = change.system;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (w.address >= 'I' && w.address <= 'K') {
      if (id == 0) return c.failWord("nct-2017", "illegal address: the common offset has no rotation", w);
      const int about = 'K' - w.address;  // I turns about Z, J about Y, K about X
      system.angles_deg[about] = (plan.next.incremental() ? system.angles_deg[about] : 0.0) + w.value;
    } else if (axisWord(plan, w, word)) {
      system.offset[word.axis] = (word.step ? system.offset[word.axis] : 0.0) + axisValue(c, plan, word, w);
    }
  }
  return true;
}

}  // namespace

}  // namespace proveout::nc
