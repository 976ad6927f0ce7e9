#include "core/nc/nct/transform_stage.h"

namespace proveout::nc {

bool TransformStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kProgram) {
    if (item.kind == PathItem::Kind::kArc) {
      item.center = item.plane.of(chain_.workOf(item.plane.point(item.center)));
    }
    chain_.moveToWork(item.to);
    item.space = PathItem::Space::kWork;
  }
  return pass(item);
}

}  // namespace proveout::nc
