// G10.9: words of an axis as radius or as diameter (manual 5.3).
#include <fmt/core.h>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {

AxisSet diameterAxes(const IsoContext& c) {
  AxisSet set;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const AxisInfo& info = c.axes.at(axis);
    if (!info.rotary() && c.parameters.flag(AxisParam::kDiameter, info.number)) {
      set.set(static_cast<std::size_t>(axis));
    }
  }
  return set;
}

bool planDiameter(IsoContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord())
    return c.alarm(SharedAlarm::kMissingData, "", "G10.9 needs axis words: 0 radius, 1 diameter");
  if (!ownBlock(c, "G10.9")) return false;
  for (const Word& w : c.block.words) {
    if (w.address == 'G') continue;
    if (w.axis < 0) return c.alarm(SharedAlarm::kAxis, w, "G10.9 takes axes by their own name");
    const AxisInfo& info = c.axes.at(w.axis);
    if (info.rotary()) return c.alarm(SharedAlarm::kAxis, w, "a rotary axis has no diameter");
    if (w.incremental) return c.alarm(SharedAlarm::kIncremental, w, "0 is radius, 1 is diameter");
    if (w.value != 0.0 && w.value != 1.0)
      return c.alarm(SharedAlarm::kOutOfRange, w, "0 is radius, 1 is diameter");
    if (!c.parameters.flag(AxisParam::kDiameterByCode, info.number)) {
      return c.failWord("diameter",
                        fmt::format("{}: G10.9 may not switch axis {}",
                                    c.parameters.nameWith(AxisParam::kDiameterByCode, 0), info.name),
                        w);
    }
    plan.next.axes.diameter.set(static_cast<std::size_t>(w.axis), w.value == 1.0);
  }
  plan.motion.target = plan.start;
  return true;
}

}  // namespace proveout::nc
