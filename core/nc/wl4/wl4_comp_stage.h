// Cutter compensation of the WL4 control as a stage of the motion pipe.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "core/nc/motion_pipe.h"
#include "core/nc/services/cutter_comp.h"

namespace proveout::nc {

/// Where the stage reports.
class Wl4CompReport {
 public:
  virtual ~Wl4CompReport() = default;
  /// False unless it is a warning.
  virtual bool compError(const char* code, const std::string& message, const SourceRef& at, bool warning) = 0;
};

/// Linked from the first motion with compensation until nothing of it waits any more. Corners outside get an
/// arc, motions that are too short for the tool are cut short without an error (digest wl4, 5.3).
class Wl4CompStage final : public PathStage {
 public:
  Wl4CompStage(MotionPipe& pipe, Wl4CompReport& report)
      : PathStage(StageSlot::kComp), pipe_(pipe), report_(report) {}

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w). Corners whose points
  /// are nearer to each other than `arc_threshold` (mm) get no arc.
  void engage(const Vec3& start, double arc_threshold);
  /// From the nose centre to the point that the path is told of, machine frame.
  void setTip(const Vec3& tip) { tip_ = tip; }

  bool push(PathItem& item) override;
  bool flush(FlushReason reason) override;
  void rebase(const AxisPoint& work, const WorkPlane& plane) override;
  void clear() override;

 private:
  bool drain(const CompStatus& status);
  bool sendPiece(const CompPiece& piece, PathItem& item);
  bool sendRapidArc(const CompPiece& piece, const Vec3& tip, PathItem& item);
  SourceRef sourceOf(std::uint64_t tag) const;

  MotionPipe& pipe_;
  Wl4CompReport& report_;
  CutterComp filter_;
  CompOutput out_;
  Vec3 tip_ = Vec3::Zero();
  std::deque<PathItem> waiting_;  ///< by tag
  std::uint64_t next_tag_ = 1;
};

}  // namespace proveout::nc
