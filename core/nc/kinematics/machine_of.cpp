#include "core/nc/kinematics/machine_of.h"

#include <utility>

namespace proveout::nc {

MachineModel machineOf(const ControlSettings& settings, const AxisTable& axes, const Vec3& origin) {
  if (settings.machine) return *settings.machine;
  MachineModel model;
  int slide = kOnBed, table = kOnBed;  // the last of each
  for (int k = 0; k < axes.count(); ++k) {
    const AxisInfo& info = axes.at(k);
    MachineAxis& axis = model.axes.emplace_back();
    axis.name = info.name;
    axis.kind = info.kind;
    if (info.mount) {
      axis.side = AxisSide::kPart;
      axis.on = std::exchange(table, k);
      axis.direction = info.mount->direction.normalized();
      axis.point = info.mount->center.value_or(origin);
      axis.left = true;
    } else if (k < kMainAxes || info.parallel_to >= 0) {
      axis.direction = Vec3::Unit(k < kMainAxes ? k : info.parallel_to);
      // The further ones carry X, Y and Z, so that sums are made in one order.
      axis.on = k < kMainAxes ? k - 1 : std::exchange(slide, k);
    } else {
      axis.side = AxisSide::kNothing;
    }
  }
  model.axes[0].on = slide;
  model.spindle.on = kMainAxes - 1;
  return model;
}

}  // namespace proveout::nc
