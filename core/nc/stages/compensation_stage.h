// Cutter compensation as a stage of the motion pipe. What a control says about it, and what it does with the
// pieces, is in classes of its own.
#pragma once

#include <cstdint>
#include <deque>

#include "core/nc/services/cutter_comp.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Linked from the first motion with compensation until nothing of it waits any more.
class CompensationStage : public PathStage {
 public:
  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;
  void rebase(const AxisPoint& work, const WorkPlane& plane) override;
  void clear() override;

  /// The machine has moved without compensation: see CutterComp.
  void forgetVector() { filter_.forgetVector(); }

 protected:
  explicit CompensationStage(MotionPipe& pipe) : PathStage(StageSlot::kComp), pipe_(pipe) {}

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w).
  void begin(const CutterCompPolicy& policy, const Vec3& start);
  /// The item of that tag, or null where it has gone.
  const PathItem* waiting(std::uint64_t tag) const;
  /// Passes on what waits in front of an item that cannot be compensated; the tool then stands at the end of
  /// the block before it. False: something that waits has an error of its own, which was reported.
  bool sendBefore(const PathItem& refused);
  /// The last item that came.
  const PathItem& newest() const { return waiting_.back(); }

 private:
  /// Whether an item can be compensated; false: reported.
  virtual bool accepts(const PathItem&) { return true; }
  virtual void note(const CompNote&) {}
  /// Reports.
  virtual void failed(const CompStatus& status) = 0;
  /// Passes a piece of `item` on; `out` has its geometry.
  virtual bool send(const CompPiece& piece, const PathItem& item, PathItem& out) = 0;

  bool drain(const CompStatus& status);
  bool sendPiece(const CompPiece& piece, PathItem& item);

  MotionPipe& pipe_;
  CutterComp filter_;
  CompOutput out_;
  std::deque<PathItem> waiting_;  ///< by tag
  std::uint64_t next_tag_ = 1;
};

}  // namespace proveout::nc
