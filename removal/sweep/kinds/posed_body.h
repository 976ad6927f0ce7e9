// Bodies of tools whose axis turns: stretches of their way.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "removal/sweep/kinds/pose_solid.h"
#include "removal/sweep/kinds/scalar_body.h"
#include "removal/sweep/posed_sweep.h"

namespace proveout {

/// A part of a tool on one stretch of a way on which its axis turns. Lengths in mm, workpiece frame.
///
/// At one pose a vertical line meets the convex solid in one interval, and on a time in which it always meets
/// it in one interval, too. From a point inside an end of that is found by climbing: to the end of the
/// interval at the pose that holds the point, to the pose that holds that end deepest, and so on, until none
/// does; near the end a step leaves the square of what was left. Gaps are crossed by the distance. The bodies
/// of all numbers ask for the same columns: each thread keeps the last ones.
class PosedPiece {
 public:
  /// More intervals than this of one column a stretch does not leave.
  static constexpr int kMostSpans = 3;

  /// `sweep` and `solid`, of its profile, must outlive this.
  PosedPiece(const PosedSweep& sweep, std::size_t stretch, const PoseSolid& solid);

  /// Of the line at (x, y) the interval with this number, counted from below.
  ColumnSpan column(double x, double y, int number) const;
  using Spans = std::array<ColumnSpan, kMostSpans>;
  Spans columnSpans(double x, double y) const;
  const Box3& bounds() const { return bounds_; }
  PoseSpan span() const {
    return {solid_,   views_.data(),      static_cast<int>(views_.size()),
            between_, bounds_.min.data(), bounds_.max.data()};
  }
  double middleShare() const { return stretch().shareAt(0.0); }

 private:
  const PosedStretch& stretch() const { return sweep_->stretches()[number_]; }
  ColumnSpan spanAt(double x, double y, double t) const;
  ColumnSpan spanAround(double x, double y, double t, double share) const;
  ColumnSpan searched(double x, double y) const;
  PosedPlace nearest(const Vec3& p, double enough, const PosedPlace& start) const;
  double climb(double x, double y, double z, double direction, PosedPlace at) const;

  Box3 bounds_;
  double between_ = 0.0;          ///< no point of the tool is ever farther from it in one of the views, mm
  std::vector<AxialView> views_;  ///< poses
  const PoseSolid* solid_;
  const PosedSweep* sweep_;
  std::size_t number_;
  std::uint64_t id_;
};

/// What a piece covers in the interval with one number.
struct PosedBody : ScalarBody<PosedBody> {
  PosedBody() = default;
  /// `of` must outlive the body; 0 <= number < kMostSpans.
  PosedBody(const PosedPiece& of, int of_number) : piece(&of), number(of_number) {}

  ColumnSpan column(double x, double y) const { return piece->column(x, y, number); }
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    columnKernels().pose_reach(piece->span(), blocks, low, high);
  }
  unsigned hits(const LeafColumns& leaf, unsigned quarters, double) const {
    return columnKernels().pose_hits(piece->span(), leaf, quarters);
  }
  double highestReach() const { return piece->bounds().max.z() + kCullSlackMm; }
  double startAt(const BodyContext&, const Vec3&) const { return piece->middleShare(); }
  /// Many pieces see one edge, and a distance to one takes as long as to all of them.
  bool isAskedWhole(const BodyContext&) const { return true; }

  const PosedPiece* piece = nullptr;
  int number = 0;
};

}  // namespace proveout
