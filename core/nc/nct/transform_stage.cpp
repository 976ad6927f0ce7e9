#include "core/nc/nct/transform_stage.h"

namespace proveout::nc {

bool TransformStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kProgram) {
    if (item.kind == PathItem::Kind::kArc) {
      Vec3 center;
      center[item.plane.u] = item.center.x();
      center[item.plane.v] = item.center.y();
      center[item.plane.w] = item.center.z();
      item.center = item.plane.of(chain_.toWork(center));
    }
    chain_.moveToWork(item.to);
    item.space = PathItem::Space::kWork;
  }
  return pass(item);
}

}  // namespace proveout::nc
