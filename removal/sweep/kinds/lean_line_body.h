// Bodies of tools whose axis leans but stands still, on straight ways: lines, and the chords of curves that
// have no body of their own.
#pragma once

#include "removal/sweep/kinds/line_meeting.h"
#include "removal/sweep/kinds/pose_solid.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {

/// A part of a tool that leans, on a line. Lengths in mm.
struct LeanLine {
  /// `from`, `to`: of the tip, workpiece frame. `profile` must outlive this, and so must `solid`, what the
  /// kernels know of it.
  LeanLine(const ConvexProfile& of, const ToolFrame& frame, const Vec3& from, const Vec3& to,
           const PoseSolid& solid);

  /// The line through `p` along a unit direction, both of the workpiece frame; in the tool's frame, its
  /// origin at the tip's start.
  SpaceLine through(const Vec3& p, const Vec3& along) const {
    return {frame.toTool(p - from), frame.toTool(along)};
  }
  ColumnSpan column(double x, double y) const;
  /// As ColumnKernel. Requires `poses`.
  void columns(const double* x, const double* y, int count, double* lo, double* hi) const;

  PoseSpan span() const { return {solid, &view, 1, 0.0, bounds.min.data(), bounds.max.data()}; }

  Box3 bounds;  ///< of the volume, workpiece frame
  AxialView view;
  const PoseSolid* solid;
  /// Of the kernels: the ends, or, of a short line of a part with round corners, as many as it needs. 0:
  /// columns are found one by one.
  int poses = 0;
  static constexpr int kMostPoses = 33;
  const ConvexProfile* profile;
  ToolFrame frame;
  Vec3 from, to;  ///< of the tip, workpiece frame
  Vec3 way;       ///< from the start to the end, tool frame
};

/// The swept volume is convex and meets every line in one interval, whose ends LineMeeting tells.
struct LeanLineBody : ScalarBody<LeanLineBody> {
  LeanLineBody() = default;
  /// `of` must outlive the body.
  explicit LeanLineBody(const LeanLine& of) : line(&of) {}

  Vec3 axis() const { return line->frame.axis(); }
  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    if (line->poses == 0) return ScalarBody::columns(x, y, count, lo, hi);
    line->columns(x, y, count, lo, hi);
  }
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    columnKernels().pose_reach(line->span(), blocks, low, high);
  }
  unsigned hits(const LeafColumns& leaf, unsigned quarters, double) const {
    return columnKernels().pose_hits(line->span(), leaf, quarters);
  }
  ColumnSpan column(double x, double y) const { return line->column(x, y); }
  double highestReach() const { return line->bounds.max.z() + kCullSlackMm; }
  bool isConvex() const { return true; }
  bool holdsEdges(double, const Vec2&, double) const { return true; }

  EdgeCut levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const;
  std::optional<double> simpleBend(const ConvexProfile::Element& element) const;
  Vec3 directionAt(const Vec3& p) const;
  SweptField field(const BodyContext& of) const;

  const LeanLine* line = nullptr;
};

/// A line that stands for a part of a curve. Its surface is that of the curve.
struct LeanChordBody : LeanLineBody {
  using LeanLineBody::LeanLineBody;

  double startAt(const BodyContext& of, const Vec3&) const {
    return of.whole->parameterAt(0.5 * (line->from + line->to));
  }
  std::optional<double> simpleBend(const ConvexProfile::Element&) const { return std::nullopt; }
  Vec3 directionAt(const Vec3&) const { return Vec3::Zero(); }
  SweptField field(const BodyContext& of) const { return *of.whole; }
};

}  // namespace proveout
