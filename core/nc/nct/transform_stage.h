// From the programmed space to work space, as a stage of the motion pipe.
#pragma once

#include "core/nc/motion_pipe.h"

namespace proveout::nc {

struct NctContext;

/// Takes what the program wrote through mirroring, scaling, rotation and the local shift. Under reflection
/// arcs turn the other way and cutter compensation changes its side; its radius stays.
class TransformStage final : public PathStage {
 public:
  explicit TransformStage(NctContext& context) : PathStage(StageSlot::kTransform), c_(context) {}
  bool push(PathItem& item) override;

 private:
  void transform(PathItem& item) const;
  bool transformArc(PathItem& item);
  bool rebuildArc(PathItem& item, double radius, const Vec3& center);

  NctContext& c_;
};

}  // namespace proveout::nc
