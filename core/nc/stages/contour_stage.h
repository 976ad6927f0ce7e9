// Contours whose corners are calculated: two stages of the motion pipe.
#pragma once

#include <cstddef>
#include <deque>
#include <string_view>

#include "core/nc/services/contour/contour_corner.h"
#include "core/nc/services/plane_curves.h"
#include "core/nc/stages/motion_pipe.h"
#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// Where the stages report what is wrong with a contour.
class ContourReport {
 public:
  virtual ~ContourReport() = default;
  /// An error at a block that has gone by. Always false.
  virtual bool contourError(SharedAlarm alarm, std::string_view subject, std::string_view detail,
                            const PathItem& at) = 0;
};

/// A motion block and the functions behind it, kept back until the next motion is known.
class HoldingStage : public PathStage {
 public:
  HoldingStage(StageSlot slot, MotionPipe& pipe, ContourReport& report)
      : PathStage(slot), pipe_(pipe), report_(report) {}
  void clear() override;

 protected:
  /// Functions that wait at most: a block behind so many does not belong to the contour.
  static constexpr std::size_t kMaxWaiting = 100;

  void hold(PathItem& item);
  bool passFunctions();

  MotionPipe& pipe_;
  ContourReport& report_;
  bool holds_ = false;
  PathItem held_;
  std::deque<PathItem> functions_;
};

/// Over-determined blocks (nct manual 17.3): the corner with the block before is where both curves meet.
/// Works in program space; to be linked while cutter compensation is on, or by a line with Meet::kOpen.
class CrossingStage final : public HoldingStage {
 public:
  CrossingStage(MotionPipe& pipe, ContourReport& report) : HoldingStage(StageSlot::kContour, pipe, report) {}
  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;

 private:
  bool release();
  bool cross(PathItem& item);
};

/// Chamfers and roundings (nct manual 17.1). Works in work space; linked while a block that has one is on its
/// way.
class CornerStage final : public HoldingStage {
 public:
  CornerStage(MotionPipe& pipe, ContourReport& report) : HoldingStage(StageSlot::kCorner, pipe, report) {}
  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;
  void clear() override;

  /// A block with a join is about to be pushed.
  void announce();
  /// What the stages behind have been sent ends here, (u, v, w); `otherwise` if nothing is kept back.
  Vec3 sentUntil(const Vec3& otherwise) const;

 private:
  bool join(PathItem& item);
  bool sendJoined(PathItem& item, const CornerJoin& join);

  int announced_ = 0;  ///< blocks with a join that the stages before still hold
};

}  // namespace proveout::nc
