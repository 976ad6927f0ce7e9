// Bodies of tools whose axis turns, as poses that stand close together.
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "removal/sweep/kinds/body_defaults.h"
#include "removal/sweep/kinds/pose_solid.h"
#include "removal/sweep/posed_sweep.h"

namespace proveout {

/// A convex part of a tool on a piece of a stretch of its way: poses that are so near to each other that what
/// its faces leave between them is below kPosesMm. Lengths in mm, workpiece frame.
///
/// A piece is so short that a column sees it in one interval: no point of it leaves the chord of its way, as
/// seen from the tool, by more than kPosesMm.
class PosePiece {
 public:
  /// Whether the kernels serve for all stretches: not where the tool lies too flat or a stretch has too many
  /// poses.
  static bool serves(const PosedSweep& sweep);
  /// Appends the pieces of a stretch. `solid`, of the sweep's profile, must outlive them. Requires `serves`.
  static void cut(const PosedSweep& sweep, const PosedStretch& stretch, const PoseSolid& solid,
                  std::deque<PosePiece>& out);
  /// Poses from `first` to `last` of those that part the stretch into `count`.
  PosePiece(const PosedSweep& sweep, const PosedStretch& stretch, const PoseSolid& solid, int first, int last,
            int count);

  PoseRun run() const { return {solid_, poses_.data(), static_cast<int>(poses_.size())}; }
  /// The poses at the ends; kept they would take more memory than all else.
  std::array<AxialView, 2> ends() const {
    return {axialView(poses_.front(), Vec3::Zero()), axialView(poses_.back(), Vec3::Zero())};
  }
  PoseSpan span(const std::array<AxialView, 2>& of_ends) const {
    return {solid_, of_ends.data(), 2, between_, bounds_.min.data(), bounds_.max.data()};
  }
  const Box3& bounds() const { return bounds_; }
  double middleShare() const { return share_; }

 private:
  /// Of one piece.
  static constexpr int kMostSteps = 16, kMostOnStretch = 4096;
  static int posesOn(const PosedSweep& sweep, const PosedStretch& stretch);

  Box3 bounds_;
  double between_;  ///< no point of the tool is ever farther from where it is at one of the ends, mm
  const PoseSolid* solid_;
  std::vector<PoseAt> poses_;
  double share_;  ///< of the motion, in its middle
};

struct PoseRunBody : BodyDefaults {
  PoseRunBody() = default;
  /// `of` must outlive the body.
  explicit PoseRunBody(const PosePiece& of) : piece(&of) {}

  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    columnKernels().poses(piece->run(), x, y, count, lo, hi);
  }
  void leafColumns(LeafColumns& leaf, unsigned quarters) const { columnsOfQuarters(*this, leaf, quarters); }
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    columnKernels().pose_reach(piece->span(piece->ends()), blocks, low, high);
  }
  unsigned hits(const LeafColumns& leaf, unsigned quarters, double) const {
    return columnKernels().pose_hits(piece->span(piece->ends()), leaf, quarters);
  }
  double highestReach() const { return piece->bounds().max.z() + kCullSlackMm; }
  double startAt(const BodyContext&, const Vec3&) const { return piece->middleShare(); }
  /// Convex but for what is between two poses.
  bool holdsEdges(double, const Vec2&, double) const { return true; }

  const PosePiece* piece = nullptr;
};

}  // namespace proveout
