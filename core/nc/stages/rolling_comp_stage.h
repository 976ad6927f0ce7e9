// Compensation of tool and nose radii that rolls around outside corners, as a stage of the motion pipe.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/nc/stages/compensation_stage.h"

namespace proveout::nc {

/// What cannot be compensated.
enum class CompFault : std::uint8_t {
  kSwitch,          ///< on or off where the control cannot
  kNoPath,          ///< the compensated paths do not meet, or data out of range
  kNegativeRadius,  ///< an arc that is smaller than the tool
  kTooShort         ///< a motion that the tool runs along backwards
};

/// Where the stage reports: errors end the run, warnings do not.
class RollingCompReport {
 public:
  virtual ~RollingCompReport() = default;
  virtual void compError(CompFault fault, const std::string& message, const SourceRef& at) = 0;
  virtual void compWarning(CompFault /*fault*/, const std::string& /*message*/, const SourceRef& /*at*/) {}
};

/// What differs from control to control.
struct RollingCompStyle {
  double arc_threshold = 0.0;         ///< mm; corners whose points are nearer to each other get no arc
  double arc_least_turn_rad = 0.0;    ///< nor do those that turn by less
  bool around_at_ends = false;        ///< the ways in and out go around outside corners too
  bool switches_in_arcs = false;      ///< it may begin and end in an arc, which becomes a spiral
  bool negative_radius_runs = false;  ///< arcs smaller than the tool are a warning and run
};

/// Corners outside get an arc, motions that are too short for the tool run without an error (digest wl4, 5.3;
/// digest flexnc, 3.7). Behind an error of a block the tool stands at the end of the one before it.
class RollingCompStage final : public CompensationStage {
 public:
  RollingCompStage(MotionPipe& pipe, RollingCompReport& report) : CompensationStage(pipe), report_(report) {}

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w).
  void engage(const Vec3& start, const RollingCompStyle& style);
  /// From the nose centre to the point that the path is told of, machine frame; of the items that come from
  /// here on.
  void setTip(const Vec3& tip) {
    if (tips_.back() != tip) tips_.push_back(tip);
  }
  bool push(PathItem& item) override;

 private:
  bool accepts(const PathItem& item) override;
  void failed(const CompStatus& status) override;
  bool send(const CompPiece& piece, const PathItem& item, PathItem& out) override;
  bool sendRapidArc(const CompPiece& piece, const Vec3& tip, PathItem& item);

  RollingCompReport& report_;
  RollingCompStyle style_;
  std::vector<Vec3> tips_{Vec3::Zero()};  ///< items have the index of theirs as their record
};

}  // namespace proveout::nc
