// Rapids of the FlexNC control: each axis at its own speed, so that the way is two lines (digest
// flexnc, 3.1).
#pragma once

#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Ends the motion of both axes where the first one arrives. Straight ways go through.
class FlexRapidStage final : public PathStage {
 public:
  /// Both must outlive the stage.
  FlexRapidStage(const PathEmitter& emitter, const ControlSettings& settings)
      : PathStage(StageSlot::kRapids), emitter_(emitter), settings_(settings) {}
  bool push(PathItem& item) override;

 private:
  const PathEmitter& emitter_;
  const ControlSettings& settings_;
};

}  // namespace proveout::nc
