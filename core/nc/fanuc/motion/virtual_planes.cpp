// Polar and cylindrical interpolation: which axes they take is a matter of the machine (5460, 5461, 1022), so
// that G17 to G19 need not name them.
#include <algorithm>

#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

/// The rotary axis of polar interpolation: C, else the only one; -1: there is none.
int polarAxis(const IsoContext& c) {
  int found = -1, count = 0;
  for (int axis = kMainAxes; axis < c.axes.count(); ++axis) {
    if (!c.axes.at(axis).rotary()) continue;
    if (c.axes.at(axis).name == "C") return axis;
    found = axis;
    ++count;
  }
  return count == 1 ? found : -1;
}

bool planeHasRotary(const IsoContext& c, const AxisModal& modal) {
  return c.axes.at(modal.plane_u).rotary() != c.axes.at(modal.plane_v).rotary();
}

/// The plane from before the mode is there again behind it.
void restorePlane(IsoContext& c, BlockPlan& plan) {
  const FanucData& data = fanucData(c);
  if (plan.next.axes.mode != VirtualMode::kOff || !data.plane_before) return;
  const auto& [u, v, w] = *data.plane_before;
  plan.next.axes.setPlane(u, v, w);
}

void keepPlane(IsoContext& c) {
  const AxisModal& modal = c.state.axes;
  if (modal.mode == VirtualMode::kOff)
    fanucData(c).plane_before = {modal.plane_u, modal.plane_v, modal.plane_w};
}

}  // namespace

bool planFanucPolarOn(IsoContext& c, BlockPlan& plan) {
  AxisModal& modal = plan.next.axes;
  const int rotary = polarAxis(c);
  if (c.block.words.size() != 1)
    return c.fail("145",
                  "illegal conditions in polar coordinate interpolation: G12.1 stands alone in its block");
  if (modal.mode == VirtualMode::kOff && !planeHasRotary(c, modal) && rotary >= 0)
    modal.setPlane(0, rotary, 2);
  if (!planPolarOn(c, plan)) return false;
  keepPlane(c);
  return true;
}

bool planFanucPolarOff(IsoContext& c, BlockPlan& plan) {
  const bool was_on = plan.next.axes.mode == VirtualMode::kPolar;
  if (!planPolarOff(c, plan)) return false;
  if (was_on) restorePlane(c, plan);
  return true;
}

bool planFanucCylinder(IsoContext& c, BlockPlan& plan) {
  AxisModal& modal = plan.next.axes;
  if (c.block.words.size() != 2 || !c.anyAxisWord())
    return c.fail(
        "175", "illegal G07.1 axis: a rotary axis with the radius of the cylinder stands beside it, alone");
  const bool was_on = modal.mode == VirtualMode::kCylinder;
  const auto word = std::find_if(c.block.words.begin(), c.block.words.end(), [&](const Word& w) {
    return w.axis >= kMainAxes && c.axes.at(w.axis).rotary();
  });
  if (word == c.block.words.end())
    return c.fail("175", "illegal G07.1 axis: it takes a rotary axis with the radius of the cylinder");
  if (!was_on && !planeHasRotary(c, modal)) {
    const std::string& name = c.axes.at(word->axis).name;
    const int along = name == "A" ? 0 : name == "B" ? 1 : 2;  // the cylinder's axis
    const int radial = along == 2 ? 0 : 2;
    if (modal.plane_u == along) {
      modal.setPlane(along, word->axis, radial);
    } else {
      modal.setPlane(word->axis, along, radial);
    }
  }
  if (!planCylinder(c, plan)) return false;
  if (was_on) {
    restorePlane(c, plan);
  } else if (modal.mode == VirtualMode::kCylinder) {
    keepPlane(c);
  } else {
    const AxisModal& before = c.state.axes;
    modal.setPlane(before.plane_u, before.plane_v, before.plane_w);  // it stays off
  }
  return true;
}

}  // namespace proveout::nc
