// Cutter compensation of the WL4 control as a stage of the motion pipe.
#pragma once

#include <string>

#include "core/nc/compensation_stage.h"

namespace proveout::nc {

/// Where the stage reports.
class Wl4CompReport {
 public:
  virtual ~Wl4CompReport() = default;
  virtual void compError(const char* code, const std::string& message, const SourceRef& at) = 0;
};

/// Corners outside get an arc, motions that are too short for the tool are cut short without an error (digest
/// wl4, 5.3).
class Wl4CompStage final : public CompensationStage {
 public:
  Wl4CompStage(MotionPipe& pipe, Wl4CompReport& report) : CompensationStage(pipe), report_(report) {}

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w). Corners whose points
  /// are nearer to each other than `arc_threshold` (mm) get no arc.
  void engage(const Vec3& start, double arc_threshold);
  /// From the nose centre to the point that the path is told of, machine frame.
  void setTip(const Vec3& tip) { tip_ = tip; }

 private:
  bool accepts(const PathItem& item) override;
  void failed(const CompStatus& status) override;
  bool send(const CompPiece& piece, const PathItem& item, PathItem& out) override;
  bool sendRapidArc(const CompPiece& piece, const Vec3& tip, PathItem& item);

  Wl4CompReport& report_;
  Vec3 tip_ = Vec3::Zero();
};

}  // namespace proveout::nc
