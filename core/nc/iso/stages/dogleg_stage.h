// Rapids on which each axis goes at its own rate, as a stage of the motion pipe.
#pragma once

#include <functional>

#include "core/nc/control/control_settings.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Linked where axes do not wait for each other: a rapid has a corner wherever an axis has arrived. Machine
/// space; rates are those of the settings, mm/min and deg/min.
class DoglegStage final : public PathStage {
 public:
  /// All must outlive the stage.
  DoglegStage(const PathEmitter& emitter, const ControlSettings& settings, const AxisTable& axes)
      : PathStage(StageSlot::kRapids), emitter_(emitter), settings_(settings), axes_(axes) {}

  /// `told`: what to do at the first rapid that has a corner.
  void configure(std::function<void()> told) { told_ = std::move(told); }
  bool push(PathItem& item) override;

 private:
  const PathEmitter& emitter_;
  const ControlSettings& settings_;
  const AxisTable& axes_;
  std::function<void()> told_;
};

}  // namespace proveout::nc
