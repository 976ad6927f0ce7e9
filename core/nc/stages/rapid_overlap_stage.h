// Rapids that overlap on their way to the path: rounded corners as chords, each with its time.
#pragma once

#include <optional>

#include "core/nc/services/rapid_overlap.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Holds a rapid until the next one is known or the axes have to stand. At most two rapids run at once. What
/// the path tells of a rapid begins where the rapid starts: the end of the one before, where both run, is the
/// later one's. Linked while rapids overlap.
class RapidOverlapStage final : public PathStage {
 public:
  /// All must outlive the stage.
  RapidOverlapStage(const PathEmitter& emitter, const ControlSettings& settings, const AxisTable& axes)
      : PathStage(StageSlot::kRapids), emitter_(emitter), settings_(settings), axes_(axes) {}

  /// `share` (0 to 1) of its speed that a rapid is down to when the next one starts; `stands`: every rapid
  /// ends in a stand. Nothing may be waiting.
  void configure(const MotionLimits& limits, double share, bool stands);

  /// Time until the axes stand if nothing followed, of what the path does not have yet, s.
  double waiting_s() const { return item_ ? endOfRapids() - sent_ : 0.0; }

  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;
  void clear() override;

 private:
  double endOfRapids() const { return has_tail_ && tail_.end > leg_.end ? tail_.end : leg_.end; }
  bool start(PathItem& item);
  bool sendUntil(double time);
  bool finish();
  void forget();

  const PathEmitter& emitter_;
  const ControlSettings& settings_;
  const AxisTable& axes_;
  RapidAxes limits_;
  double share_ = 0.0;
  bool stands_ = false;

  std::optional<PathItem> item_;  ///< the rapid that runs; none: the axes stand
  RapidLeg leg_, tail_;           ///< it, and the one before
  bool has_tail_ = false;
  bool sending_ = false;
  double sent_ = 0.0;  ///< up to this time the path has it, s
};

}  // namespace proveout::nc
