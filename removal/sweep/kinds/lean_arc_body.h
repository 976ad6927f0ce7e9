// Bodies of tools whose axis leans but stands still, on arcs about that axis: circles in a tilted plane.
#pragma once

#include <array>
#include <deque>

#include "removal/sweep/kinds/pose_solid.h"
#include "removal/sweep/kinds/scalar_body.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {

/// A part of a tool that leans, on an arc about its axis, or on a piece of it. Lengths in mm.
struct LeanArc {
  /// `from`, `to`: of the tip, `arc`: of this radius and without rise; all of the workpiece frame. `profile`
  /// and what is known of it must outlive this.
  LeanArc(const ConvexProfile& of, const ToolFrame& frame, const Vec3& from, const Vec3& to,
          const ArcGeometry& arc, const PoseSolid& known);
  /// Appends it in pieces that are nearly straight, as seen from a tool of this radius.
  void cut(std::deque<LeanArc>& out) const;

  /// A line comes into a ring twice, more often only beside the gap of an arc and where corners are round.
  static constexpr int kMostSpans = 4;
  /// Of the workpiece's vertical line at (x, y) the interval with this number, counted from below.
  ColumnSpan column(double x, double y, int number) const;
  using Spans = std::array<ColumnSpan, kMostSpans>;
  Spans columnSpans(double x, double y) const;

  PoseSpan span() const { return {solid, &chord, 1, sagitta, bounds.min.data(), bounds.max.data()}; }
  /// Of bodies with a number above 0: nothing where no column of a square goes through the notch.
  void reach(int number, const FourBlocks& blocks, double* low, double* high) const;

  /// Whether the direction from the centre is one that the tip has on its way.
  bool isPassed(const Vec2& level) const;

  Box3 bounds;      ///< of the volume, workpiece frame
  AxialView chord;  ///< of the tip
  double sagitta;   ///< the tip goes no farther from it
  /// Between the ends, on the inner side, there is a notch that the tool passes by: all lines that meet the
  /// volume more than once go through it. Where it is along q of the chord.
  double notch_low, notch_high;
  const PoseSolid* solid;
  const ConvexProfile* profile;
  ToolFrame frame;
  Vec3 center;       ///< of the arc at the height of the tip, tool frame
  double radius;     ///< of the arc
  Vec2 first, last;  ///< unit, from the centre to the ends, tool frame; last is counterclockwise from first
  double sweep;      ///< from first to last, above 0; a turn or more: all around
  double turn;       ///< +1: the way is counterclockwise, -1: clockwise

 private:
  void setPlace();
  /// Whether a column of the square may.
  bool meetsNotch(double x, double y, double half_width) const;
  std::uint64_t id_ = 0;
};

/// What one of the intervals is. The ends of all are where a line meets the faces of a solid of revolution
/// about the arc's axis, that of the tool's outer and of its inner side, or the tool at an end of the arc:
/// roots of quadratics, for round corners and spheres of quartics. Of all these meetings those are ends
/// between which and the next the volume lies, or does not; that is asked in the middle between them.
struct LeanArcBody : ScalarBody<LeanArcBody> {
  LeanArcBody() = default;
  /// `of` must outlive the body; 0 <= number < kMostSpans.
  LeanArcBody(const LeanArc& of, int of_number) : arc(&of), number(of_number) {}

  Vec3 axis() const { return arc->frame.axis(); }
  ColumnSpan column(double x, double y) const { return arc->column(x, y, number); }
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    arc->reach(number, blocks, low, high);
  }
  unsigned hits(const LeafColumns& leaf, unsigned quarters, double) const {
    return columnKernels().pose_hits(arc->span(), leaf, quarters);
  }
  double highestReach() const { return arc->bounds.max.z() + kCullSlackMm; }
  double startAt(const BodyContext& of, const Vec3& p) const { return of.whole->parameterAt(p); }
  std::optional<double> simpleBend(const ConvexProfile::Element& element) const;
  Vec3 directionAt(const Vec3& p) const;

  const LeanArc* arc = nullptr;
  int number = 0;
};

}  // namespace proveout
