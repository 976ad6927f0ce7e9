#include "removal/sweep/kinds/lean_line_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "removal/sweep/leaning_sweep.h"

namespace proveout {

namespace {

ColumnSpan raised(ColumnSpan span, double by) { return {span.lo + by, span.hi + by}; }

}  // namespace

LeanLine::LeanLine(const ConvexProfile& of, const ToolFrame& in, const Vec3& start, const Vec3& end,
                   const PoseSolid& known)
    : view(axialView(poseAt(start, in.axis()), end - start)),
      solid(&known),
      profile(&of),
      frame(in),
      from(start),
      to(end),
      way(in.wayToTool(end - start)) {
  const Box3 tool = leaningBounds(of, frame);
  bounds = {start.cwiseMin(end) + tool.min, start.cwiseMax(end) + tool.max};
  if (std::abs(in.axis().z()) < kLeastAxisRise) return;
  const double steps = known.corners ? std::max(1.0, std::ceil((end - start).norm() / posesApart(of))) : 1.0;
  poses = steps < kMostPoses ? static_cast<int>(steps) + 1 : 0;
}

ColumnSpan LeanLine::column(double x, double y) const {
  if (x < bounds.min.x() || x > bounds.max.x() || y < bounds.min.y() || y > bounds.max.y()) return {};
  LineMeeting meeting(through({x, y, from.z()}, Vec3::UnitZ()), way);
  meeting.meet(*profile);
  return raised(meeting.span(), from.z());
}

void LeanLine::columns(const double* x, const double* y, int count, double* lo, double* hi) const {
  std::array<PoseAt, kMostPoses> at;
  for (int i = 0; i < poses; ++i)
    at[static_cast<std::size_t>(i)] = poseAt(from + (to - from) * i / (poses - 1), frame.axis());
  columnKernels().poses({solid, at.data(), poses, !solid->corners}, x, y, count, lo, hi);
}

EdgeCut LeanLineBody::levelCut(const BodyContext&, const Vec3& a, double dx, double dy, double inside) const {
  LineMeeting meeting(line->through(a, Vec3(dx, dy, 0.0)), line->way);
  meeting.meet(*line->profile);
  // A line that only touches the volume meets nothing: the point inside lies on it within rounding.
  return {std::clamp(meeting.span().lo, 0.0, inside)};
}

std::optional<double> LeanLineBody::simpleBend(const ConvexProfile::Element& e) const {
  if (e.arc) return e.cr == 0.0 ? std::optional(1.0 / e.radius) : std::nullopt;
  if (e.dz == 0.0) return 0.0;
  if (e.dr != 0.0) return std::nullopt;
  return wallBend(e.ar, e.ar);
}

Vec3 LeanLineBody::directionAt(const Vec3&) const {
  if (line->way.head<2>().isZero(0.0)) return Vec3::Zero();
  return (line->to - line->from) / line->way.norm();
}

SweptField LeanLineBody::field(const BodyContext& of) const {
  return SweptField(*of.profile, line->frame, line->from, line->to, nullptr);
}

}  // namespace proveout
