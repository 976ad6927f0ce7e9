// Plans of the codes that set registers: G10, G52, G92.
#include <fmt/core.h>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {

bool NctControl::planLocalShift(BlockPlan& plan) {
  plan.target = plan.start;
  if (!anyAxisWord()) return fail("nct-2004", "missing data: G52 needs axis words");
  plan.frames = frames_;
  for (const Word& w : block_.words) {
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    if (!secondary && (w.address < 'X' || w.address > 'Z')) continue;
    const int axis = w.address - (secondary ? 'U' : 'X');
    const double value = lengthOf(plan, w);
    if (secondary || w.incremental || plan.next.incremental()) {
      plan.frames->shift52[axis] += value;
    } else {
      plan.frames->shift52[axis] = value;
    }
  }
  plan.deed = BlockPlan::Deed::kFrames;
  return true;
}

bool NctControl::planSetPosition(BlockPlan& plan) {
  plan.target = plan.start;
  if (!anyAxisWord()) return fail("nct-2004", "missing data: G92 needs axis words");
  plan.frames = frames_;
  const Vec3 work = plan.chain.toWork(plan.start);
  for (const Word& w : block_.words) {
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    if (!secondary && (w.address < 'X' || w.address > 'Z')) continue;
    if (secondary || w.incremental) {
      return failWord("nct-2097",
                      fmt::format("illegal incremental movement on axis {}: G92 words are absolute",
                                  addressText(w.address)),
                      w);
    }
    const int axis = w.address - 'X';
    plan.frames->shift52[axis] = 0.0;
    plan.frames->shift92[axis] = work[axis] - lengthOf(plan, w);
  }
  plan.deed = BlockPlan::Deed::kFrames;
  return true;
}

bool NctControl::planOffsets(BlockPlan& plan) {
  plan.target = plan.start;
  const Word* l = ownWord(plan, 'L');
  std::int64_t kind = 0;
  if (l == nullptr) return fail("nct-2004", "missing data L: G10 needs L");
  if (!integerWord(*l, 0, 9999, kind)) return false;
  if (kind != 2 && kind != 20 && (kind < 10 || kind > 13)) {
    return failWord(
        "nct-2123",
        fmt::format("function not implemented: G10 L{} is not supported (L2, L10 to L13, L20 are)", kind),
        *l);
  }
  const Word* p = ownWord(plan, 'P');
  if (p == nullptr) return fail("nct-2004", "missing data P: G10 needs P");
  if (kind >= 10 && kind <= 13) return planToolOffset(plan, static_cast<int>(kind), *p);
  return planWorkOffset(plan, static_cast<int>(kind), *p);
}

bool NctControl::planToolOffset(BlockPlan& plan, int kind, const Word& p) {
  std::int64_t row = 0;
  if (!integerWord(p, 1, static_cast<std::int64_t>(parameters_[NctParam::kToolOffsets]), row)) return false;
  const Word* r = word('R');
  if (r == nullptr) return fail("nct-2004", "missing data R: the value of the offset");
  if (anyAxisWord() || !(block_.present & AddressSet("IJK")).empty()) {
    return fail("nct-2017", "illegal address: G10 L10 to L13 takes P and R");
  }
  const auto& table = kind < 12 ? length_table_ : radius_table_;
  const auto found = table.find(static_cast<int>(row));
  const OffsetValue old = found == table.end() ? OffsetValue{} : found->second;
  const bool add = r->incremental || plan.next.incremental();
  const double base = kind % 2 == 0 ? old.geometry : old.wear;
  plan.offset_row = static_cast<int>(row);
  plan.offset_table = kind;
  plan.offset_value = (add ? base : 0.0) + lengthOf(plan, *r);
  plan.deed = BlockPlan::Deed::kOffsets;
  return true;
}

bool NctControl::planWorkOffset(BlockPlan& plan, int kind, const Word& p) {
  std::int64_t row = 0;
  if (const Word* r = word('R')) return failWord("nct-2017", "illegal address R in G10 L2, L20", *r);
  if (!integerWord(p, kind == 2 ? 0 : 1, kind == 2 ? 6 : 99, row)) return false;
  plan.flush = true;  // the frame of the compensated path changes
  plan.frames = frames_;
  const WorkSystemId id = kind == 2 ? static_cast<int>(row) : kFirstExtended + static_cast<int>(row) - 1;
  WorkSystem& system = plan.frames->system(id);
  for (const Word& w : block_.words) {
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    if (w.address >= 'I' && w.address <= 'K') {
      if (id == 0) return failWord("nct-2017", "illegal address: the common offset has no rotation", w);
      const int about = 'K' - w.address;  // I turns about Z, J about Y, K about X
      system.angles_deg[about] = (plan.next.incremental() ? system.angles_deg[about] : 0.0) + w.value;
    } else if (secondary || (w.address >= 'X' && w.address <= 'Z')) {
      const int axis = w.address - (secondary ? 'U' : 'X');
      const bool add = secondary || w.incremental || plan.next.incremental();
      system.offset[axis] = (add ? system.offset[axis] : 0.0) + lengthOf(plan, w);
    }
  }
  plan.deed = BlockPlan::Deed::kFrames;
  return true;
}

}  // namespace proveout::nc
