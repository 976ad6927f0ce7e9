// Cutter compensation of LinuxCNC as a stage of the motion pipe.
#pragma once

#include <deque>

#include "core/nc/iso/model/alarm_reporter.h"
#include "core/nc/iso/stages/stage_recovery.h"
#include "core/nc/services/arc_corner_comp.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

class LinuxCncCompStage final : public PathStage {
 public:
  LinuxCncCompStage(MotionPipe& pipe, AlarmReporter& alarms, StageRecovery& recovery)
      : PathStage(StageSlot::kComp), pipe_(pipe), alarms_(alarms), recovery_(recovery) {}

  /// Compensation begins with the next item; the tool stands at `start`, (u, v, w) of work coordinates.
  void engage(const Vec3& start);
  /// Nothing has moved in the plane since compensation began.
  bool idle() const { return filter_.first(); }
  /// Compensation is over: what waits leaves. False: reported.
  bool end();

  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;
  void rebase(const AxisPoint& work, const WorkPlane& plane) override;
  void clear() override;

 private:
  bool drain(ArcCornerFault fault);
  bool sendPiece(const ArcCornerPiece& piece);

  MotionPipe& pipe_;
  AlarmReporter& alarms_;
  StageRecovery& recovery_;
  ArcCornerComp filter_;
  std::deque<PathItem> waiting_;  ///< by their tags
  std::vector<ArcCornerPiece> pieces_;
  std::uint64_t next_tag_ = 1;
};

/// From the nose's centre to the commanded point of a lathe tool, (z, x) in radii: orientation 0 to 9 of the
/// tool table.
Vec2 linuxCncTipShift(int orientation);

}  // namespace proveout::nc
