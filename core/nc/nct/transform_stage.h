// From the programmed space to work space, as a stage of the motion pipe.
#pragma once

#include "core/nc/motion_pipe.h"

namespace proveout::nc {

class TransformStage final : public PathStage {
 public:
  explicit TransformStage(const CoordinateChain& chain) : PathStage(StageSlot::kTransform), chain_(chain) {}
  bool push(PathItem& item) override;

 private:
  const CoordinateChain& chain_;
};

}  // namespace proveout::nc
