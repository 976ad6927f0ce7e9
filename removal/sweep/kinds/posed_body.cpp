#include "removal/sweep/kinds/posed_body.h"

#include <algorithm>
#include <cmath>

#include "removal/sweep/kinds/line_meeting.h"
#include "removal/sweep/leaning_sweep.h"

namespace proveout {

namespace posed_body_detail {

/// A pose that holds the end of an interval no deeper than this does not go on with it, mm.
constexpr double kHeldMm = 2e-9;
/// Climbing ends where a step gains less, mm.
constexpr double kStillMm = 1e-11;
/// Through a thin edge that goes along the column each step gains no more than the edge is thick. The deepest
/// pose is asked for every so many steps, else any that is deeper.
constexpr int kMostClimbs = 20000, kQuickClimbs = 12;
/// What is between two intervals, or an interval, that is shorter than this is not looked for, mm: it is no
/// thicker than that anywhere on the column.
constexpr double kLeastStepMm = 2e-5;
/// Steps of the search in one column.
constexpr int kMostMarches = 100000;
/// Parts of a stretch whose surroundings tell where to look.
constexpr int kWayParts = 4;
/// Where culling looks at a stretch: so many of its poses that the tool moves no farther from one of them
/// than this share of its radius, but not too many.
constexpr double kViewShare = 0.25, kMostViews = 32.0;

}  // namespace posed_body_detail

using namespace posed_body_detail;

PosedPiece::PosedPiece(const PosedSweep& sweep, std::size_t number, const PoseSolid& solid)
    : bounds_(stretchBounds(sweep.profile(), sweep.stretches()[number])),
      solid_(&solid),
      sweep_(&sweep),
      number_(number),
      id_(nextPieceId()) {
  const double shift = stretch().mostShift(farthestFromTip(sweep.profile()));
  const double count =
      std::clamp(std::ceil(shift / (kViewShare * sweep.profile().maxRadius())), 1.0, kMostViews);
  between_ = shift / count + kTrackMm;
  for (int i = 0; i < count; ++i) {
    const PosedStretch::Pose pose = stretch().poseAt((2.0 * i + 1.0) / count - 1.0);
    views_.push_back(axialView(poseAt(pose.tip, pose.axis), Vec3::Zero()));
  }
}

ColumnSpan PosedPiece::spanAt(double x, double y, double t) const {
  const PosedStretch::Pose pose = stretch().poseAt(t);
  const ToolFrame frame(pose.axis);
  LineMeeting meeting({frame.toTool(Vec3(x, y, pose.tip.z()) - pose.tip), frame.toTool(Vec3::UnitZ())},
                      Vec3::Zero());
  meeting.meet(sweep_->profile());
  return {meeting.span().lo + pose.tip.z(), meeting.span().hi + pose.tip.z()};
}

/// Heights between which anything of the part may be over the line, in a share of the stretch about a pose.
/// What is higher on the tool moves farther, so that all of it lies in a cone.
ColumnSpan PosedPiece::spanAround(double x, double y, double t, double share) const {
  const ConvexProfile& part = sweep_->profile();
  const double r = part.maxRadius(), low = part.zMin(), high = part.zMax();
  const double turn = std::min(0.9, share * stretch().axis[0]);
  const double base = share * stretch().tip[0] + turn * r + kTrackMm;  // a point at the tip
  const double slope = turn / (1.0 - turn);
  ConvexProfile around;
  if (low >= 0.0) {
    const double first = low - base - turn * low, last = high + base + turn * high;
    const double narrow = r + base + slope * std::max(0.0, first + base),
                 wide = r + base + slope * (last + base);
    around.start(0.0, first), around.lineTo(narrow, first), around.lineTo(wide, last),
        around.lineTo(0.0, last);
  } else {
    const double grown = base + turn * std::max(-low, std::abs(high));
    around.start(0.0, low - grown), around.lineTo(r + grown, low - grown);
    around.lineTo(r + grown, high + grown), around.lineTo(0.0, high + grown);
  }
  const PosedStretch::Pose pose = stretch().poseAt(t);
  const ToolFrame frame(pose.axis);
  LineMeeting meeting({frame.toTool(Vec3(x, y, pose.tip.z()) - pose.tip), frame.toTool(Vec3::UnitZ())},
                      Vec3::Zero());
  meeting.meet(around);
  if (!(meeting.span().lo < meeting.span().hi)) return {};
  return {std::max(meeting.span().lo + pose.tip.z(), bounds_.min.z()),
          std::min(meeting.span().hi + pose.tip.z(), bounds_.max.z())};
}

/// Heights outside of which the piece covers nothing of a column.
ColumnSpan PosedPiece::searched(double x, double y) const {
  ColumnSpan all;
  for (int k = 0; k < kWayParts; ++k) {
    // Bounds of how far points go hold for any part of the stretch alike.
    const ColumnSpan part = spanAround(x, y, (2.0 * k + 1.0) / kWayParts - 1.0, 1.0 / kWayParts);
    all.lo = std::min(all.lo, part.lo), all.hi = std::max(all.hi, part.hi);
  }
  return all;
}

PosedPlace PosedPiece::nearest(const Vec3& p, double enough, const PosedPlace& start) const {
  return sweep_->nearest(p, {std::numeric_limits<double>::infinity(), kLineToleranceMm, enough}, number_,
                         number_ + 1, &start);
}

/// From a point that the pose `at` holds to the end of what is covered without a gap; direction: +1 up, -1
/// down.
double PosedPiece::climb(double x, double y, double z, double direction, PosedPlace at) const {
  const double any = -std::numeric_limits<double>::infinity();
  bool proven = false;  // that no pose holds the point deeper than `at`
  for (int round = 0; round < kMostClimbs; ++round) {
    const ColumnSpan span = spanAt(x, y, at.t);
    const double next = direction > 0.0 ? span.hi : span.lo;
    const bool gains = direction * (next - z) > kStillMm && std::isfinite(next);
    if (gains) z = next;
    if (!gains && proven) break;
    // A pose whose own end this is holds it within rounding: then the deepest one is asked for.
    proven = (!gains && round > 0) || round % kQuickClimbs == kQuickClimbs - 1;
    at = nearest({x, y, z}, proven ? any : -kHeldMm, at);
    if (at.value >= -kHeldMm) break;
  }
  return z;
}

ColumnSpan PosedPiece::column(double x, double y, int number) const {
  if (x < bounds_.min.x() || x > bounds_.max.x() || y < bounds_.min.y() || y > bounds_.max.y()) return {};
  return keptSpans(*this, id_, x, y)[static_cast<std::size_t>(number)];
}

PosedPiece::Spans PosedPiece::columnSpans(double x, double y) const {
  Spans out;
  std::size_t count = 0;
  const ColumnSpan all = searched(x, y);
  PosedPlace at{number_, 0.0, 0.0};
  double z = all.lo;
  for (int step = 0; z < all.hi && step < kMostMarches && count < kMostSpans; ++step) {
    at = nearest({x, y, z}, -kHeldMm, at);
    const ColumnSpan span = spanAt(x, y, at.t);
    if (!(span.lo < span.hi && span.hi > z)) {
      z += std::max(at.value, kLeastStepMm);
      continue;
    }
    const double inside = std::max(z, 0.5 * (span.lo + span.hi));
    ColumnSpan& found = out[count++];
    found = {z, climb(x, y, inside, 1.0, at)};
    if (at.value > 0.0) found.lo = climb(x, y, inside, -1.0, at);
    z = found.hi + kLeastStepMm;
  }
  return out;
}

}  // namespace proveout
