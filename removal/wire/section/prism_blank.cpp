#include "removal/wire/section/prism_blank.h"

namespace proveout {

Result<PrismBlank> prismOf(const StockShape& shape) {
  PrismBlank blank;
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    blank.loops.push_back(rectangleLoop(box->min.head<2>(), box->max.head<2>()));
    blank.z_low = box->min.z();
    blank.z_high = box->max.z();
    return blank;
  }
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (cylinder == nullptr || cylinder->axis != 2)
    return inputError("start holes are for boxes, and cylinders and tubes along Z");
  blank.loops.push_back(circleLoop(cylinder->base.head<2>(), cylinder->radius, false));
  if (cylinder->inner_radius > 0.0)
    blank.loops.push_back(circleLoop(cylinder->base.head<2>(), cylinder->inner_radius, true));
  blank.z_low = cylinder->base.z();
  blank.z_high = cylinder->base.z() + cylinder->length;
  return blank;
}

}  // namespace proveout
