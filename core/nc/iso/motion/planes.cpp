// Planes: which axes G17, G18 and G19 mean (manual 10.4, 4.5, 4.6).
#include "core/nc/iso/motion/planes.h"

#include <fmt/core.h>

namespace proveout::nc {

bool planPlane(IsoContext& c, BlockPlan& plan) {
  const PlaneFrame frame(plan.next.plane());
  std::array<int, 2> axes{frame.u(), frame.v()};
  std::array<bool, 2> named{};
  int rotary = -1, rotary_words = 0;
  for (const Word& w : c.block.words) {
    if (w.axis < 0) continue;
    const AxisInfo& info = c.axes.at(w.axis);
    if (info.rotary()) {
      rotary = w.axis;
      ++rotary_words;
      continue;
    }
    const int main = w.axis < kMainAxes ? w.axis : info.parallel_to;
    for (std::size_t slot = 0; slot < 2; ++slot) {
      if (main != (slot == 0 ? frame.u() : frame.v())) continue;
      // Beside a main axis its parallel one only moves.
      const bool both_parallel = named[slot] && axes[slot] >= kMainAxes && w.axis >= kMainAxes;
      if (both_parallel)
        return c.alarm(SharedAlarm::kPlane, "", "two parallel axes for one axis of the plane", w.columns);
      if (!named[slot] || w.axis < kMainAxes) axes[slot] = w.axis;
      named[slot] = true;
    }
  }
  // A rotary axis takes the place of the linear axis that is not named.
  if (rotary_words == 1 && named[0] != named[1]) axes[named[0] ? 1 : 0] = rotary;
  plan.next.axes.setPlane(axes[0], axes[1], frame.w());
  return true;
}

bool planeOfLines(IsoContext& c, const BlockPlan& plan, SharedAlarm alarm, const char* what) {
  const AxisModal& modal = plan.next.axes;
  for (const int axis : {static_cast<int>(modal.plane_u), static_cast<int>(modal.plane_v)}) {
    if (axis < kMainAxes) continue;
    if (c.axes.at(axis).rotary() && (modal.mode == VirtualMode::kOff || axis != modal.rotary)) {
      return c.alarm(alarm, "",
                     fmt::format("the plane has the rotary axis {}, named beside G17, G18 or G19: {}",
                                 c.axes.at(axis).name, what));
    }
    if (!c.axes.at(axis).rotary() && plan.chain->turnsMain()) {
      return c.alarm(alarm, "", "a plane with a parallel axis cannot be rotated");
    }
  }
  return true;
}

}  // namespace proveout::nc
