// Cutter compensation as a stage of the motion pipe.
#pragma once

#include <cstdint>
#include <deque>

#include "core/nc/motion_pipe.h"
#include "core/nc/services/cutter_comp.h"

namespace proveout::nc {

struct NctContext;

/// Linked from the block that switches compensation on until nothing of it waits any more.
class CompStage final : public PathStage {
 public:
  explicit CompStage(NctContext& context) : PathStage(StageSlot::kComp), c_(context) {}

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w).
  void engage(const Vec3& start);

  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;
  void rebase(const AxisPoint& work, const WorkPlane& plane) override;
  void clear() override;

 private:
  bool drain(const CompStatus& status);
  bool sendPiece(const CompPiece& piece, PathItem& item);
  void report(Severity severity, const char* code, const std::string& message, std::uint64_t tag);

  NctContext& c_;
  CutterComp filter_;
  CompOutput out_;
  std::deque<PathItem> waiting_;  ///< by tag
  std::uint64_t next_tag_ = 1;
};

}  // namespace proveout::nc
