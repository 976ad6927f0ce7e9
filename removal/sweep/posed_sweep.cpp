#include "removal/sweep/posed_sweep.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "removal/sweep/leaning_sweep.h"

namespace proveout {

namespace posed_sweep_detail {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Stretches are about this many tool radii long, or longer where the tool is thin.
constexpr double kStretchRadii = 8.0, kLeastStretchMm = 5.0;
/// A pose that is as near as this to a point of the surface touches it, mm.
constexpr double kThereMm = 0.1 * kSweepToleranceMm;
/// Poses on both sides of one at which a rim may leave the surface are as far from it, mm.
constexpr double kKinkStepMm = 1e-3;
/// Faces whose normals differ by no more meet smoothly.
const double kRimCos = std::cos(degToRad(10.0));
/// The gradient of a straight element's face is its normal within this.
constexpr double kFaceSlack = 1e-6;

inline double longestStretch(const ConvexProfile& profile) {
  return std::max(kLeastStretchMm, kStretchRadii * profile.maxRadius());
}

}  // namespace posed_sweep_detail

using namespace posed_sweep_detail;

Box3 stretchBounds(const ConvexProfile& profile, const PosedStretch& stretch) {
  const Box3 part = leaningBounds(profile, ToolFrame(stretch.middleAxis()));
  const Vec3 tip = stretch.middleTip(), axis = stretch.middleAxis();
  const double shift = stretch.mostShift(farthestFromTip(profile));
  const Box3 moved = Box3{tip + part.min, tip + part.max}.inflated(shift + kTrackMm);
  // Balls around both ends of the part's axis, too, hold all of it between them.
  Box3 balls;
  for (const double z : {profile.zMin(), profile.zMax()}) {
    const Vec3 end = tip + z * axis;
    balls.extend(Box3{end, end}.inflated(profile.maxRadius() + stretch.mostShift(std::abs(z)) + kTrackMm));
  }
  return {moved.min.cwiseMax(balls.min), moved.max.cwiseMin(balls.max)};
}

Box3 boundsBetween(const ConvexProfile& profile, const PosedStretch& stretch, double from, double to) {
  Box3 box;
  for (const double t : {from, to}) {
    const PosedStretch::Pose pose = stretch.poseAt(t);
    const Box3 part = leaningBounds(profile, ToolFrame(pose.axis));
    box.extend(Box3{pose.tip + part.min, pose.tip + part.max});
  }
  // What moves between two poses leaves their chord by an eighth of its second derivative.
  const double bend = stretch.tip[1] + farthestFromTip(profile) * stretch.axis[1];
  return box.inflated(bend * (to - from) * (to - from) / 8.0 + kTrackMm);
}

PosedSweep::PosedSweep(const ConvexProfile& profile, const MotionWay& way)
    : profile_(&profile), track_(std::make_shared<const PosedTrack>(way, longestStretch(profile))) {}

PosedPlace PosedSweep::nearest(const Vec3& p, const PosedSearch::Goal& goal, std::size_t first,
                               std::size_t last, const PosedPlace* start) const {
  const std::vector<PosedStretch>& all = stretches();
  PROVEOUT_ASSERT_DEAR(first < last && last <= all.size());
  PosedSearch search(*profile_, p, goal);
  if (last - first == 1) {
    search.look(all[first], first, start != nullptr && start->stretch == first ? start->t : 0.0);
    return search.best();
  }
  // First where a low value is likely.
  std::size_t begin = first;
  double begin_t = 0.0, least = kInfinity;
  if (start != nullptr && start->stretch >= first && start->stretch < last) {
    begin = start->stretch, begin_t = start->t;
  } else {
    for (std::size_t i = first; i < last; ++i) {
      const double bound = search.roughBound(all[i]);
      if (bound < least) least = bound, begin = i;
    }
    if (least > goal.cutoff) return {begin, 0.0, least};
  }
  search.look(all[begin], begin, begin_t);
  // Neighbours first, as the pose goes over from one to the next.
  for (std::size_t step = 1; step < last - first && !search.isOver(); ++step) {
    for (const bool up : {true, false}) {
      if (up ? step >= last - begin : step > begin - first) continue;
      const std::size_t i = up ? begin + step : begin - step;
      if (search.isOver() || search.roughBound(all[i]) >= search.wanted()) continue;
      search.look(all[i], i, up ? -1.0 : 1.0);
    }
  }
  return search.best();
}

double PosedSweep::distance(const Vec3& p, double cutoff, double tolerance) const {
  return nearest(p, {cutoff, tolerance}, 0, stretches().size()).value;
}

PosedSweep::At PosedSweep::at(const Vec3& p, std::size_t stretch, double t) const {
  const PosedStretch::Moving m = stretches()[stretch].at(t);
  const Vec3 axis = m.at.tail<3>(), c1 = m.first.head<3>(), a1 = m.first.tail<3>(),
             w = p - m.at.head<3>().matrix();
  const double z = w.dot(axis);
  const Vec3 u = w - z * axis;
  const double rho = u.norm();
  const Vec3 out = rho > 1e-9 ? Vec3(u / rho) : axis.unitOrthogonal();
  const ProfileSample s = profile_->sample(rho, z);
  // The gradient turns with the tool; the point goes against it.
  const double slope = s.gr * out.dot(-c1 - z * a1) + s.gz * (w.dot(a1) - c1.dot(axis));
  return {s.value, slope, s.element, Vec3(s.gr * out + s.gz * axis).stableNormalized(), s.gz};
}

ProfileSample PosedSweep::profileAt(const Vec3& p, const PosedPlace& place) const {
  const PosedStretch::Pose pose = stretches()[place.stretch].poseAt(place.t);
  const Vec3 w = p - pose.tip;
  const double z = w.dot(pose.axis);
  return profile_->sample((w - z * pose.axis).norm(), z);
}

/// Where a sharp rim of the tool leaves the surface: as for Sweep.
SweepSample PosedSweep::withRim(const Vec3& p, const PosedPlace& place) const {
  const PosedStretch& stretch = stretches()[place.stretch];
  const At here = at(p, place.stretch, place.t);
  const double speed = stretch.tip[0] + stretch.axis[0] * (p - stretch.middleTip()).norm();
  const double step = std::min(0.5, kKinkStepMm / std::max(speed, 1e-12));
  const bool first = place.stretch == 0 && place.t <= -1.0,
             last = place.stretch + 1 == stretches().size() && place.t >= 1.0;
  if (first || last) return {here.value, here.gradient, here.element};
  const double before_t = place.t - step, after_t = place.t + step;
  // Beyond the ends of a stretch its neighbour goes on.
  const At before = before_t < -1.0 && place.stretch > 0 ? at(p, place.stretch - 1, 1.0)
                                                         : at(p, place.stretch, std::max(-1.0, before_t)),
           after = after_t > 1.0 && place.stretch + 1 < stretches().size()
                       ? at(p, place.stretch + 1, -1.0)
                       : at(p, place.stretch, std::min(1.0, after_t));
  if (before.slope < 0.0 && after.slope > 0.0) {
    const Vec3 mix = before.gradient * after.slope - after.gradient * before.slope;
    const bool rim = before.element != after.element && before.gradient.dot(after.gradient) < kRimCos;
    const int element =
        rim ? ConvexProfile::kEdgeIds + std::min(before.element, after.element) : here.element;
    if (const double norm = mix.norm(); norm > 0.0) return {here.value, mix / norm, element};
  }
  return {here.value, here.gradient, here.element};
}

SweepSample PosedSweep::sample(const Vec3& p) const {
  return withRim(p, nearest(p, {kInfinity, kLineToleranceMm}, 0, stretches().size()));
}

SweepSample PosedSweep::sampleOnSurface(const Vec3& p, double start) const {
  const PosedPlace from = placeAt(start);
  // A pose that touches the point is as good as any other.
  return withRim(p, nearest(p, {kInfinity, kLineToleranceMm, kThereMm}, 0, stretches().size(),
                            start >= 0.0 ? &from : nullptr));
}

SweepSample PosedSweep::sampleOutside(const Vec3& p, double tolerance, double& start) const {
  const PosedPlace from = placeAt(start);
  const PosedPlace place =
      nearest(p, {kInfinity, tolerance}, 0, stretches().size(), start >= 0.0 ? &from : nullptr);
  start = shareAt(place);
  const At found = at(p, place.stretch, place.t);
  const ConvexProfile::Element& e = profile_->element(found.element - profile_->firstElementId());
  const bool at_end = !e.arc && std::abs(found.axial + e.dr) > kFaceSlack;
  return {found.value, found.gradient, at_end ? ConvexProfile::kEdgeIds + found.element : found.element};
}

bool PosedSweep::holds(const Vec3& a, const Vec3& b) const {
  for (const Vec3& p : {Vec3(0.5 * (a + b)), a, b}) {
    const PosedPlace place = nearest(p, {0.0, kLineToleranceMm}, 0, stretches().size());
    if (!(place.value < 0.0)) return false;
    if (profileAt(a, place).value < 0.0 && profileAt(b, place).value < 0.0) return true;
  }
  return false;
}

PosedPlace PosedSweep::placeAt(double share) const {
  const std::vector<PosedStretch>& all = stretches();
  const auto above = std::upper_bound(all.begin(), all.end(), share,
                                      [](double s, const PosedStretch& stretch) { return s < stretch.from; });
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - all.begin() - 1, 0));
  const PosedStretch& s = all[i];
  return {i, std::clamp((2.0 * share - s.from - s.to) / (s.to - s.from), -1.0, 1.0), kInfinity};
}

double PosedSweep::shareAt(const PosedPlace& place) const {
  return std::clamp(stretches()[place.stretch].shareAt(place.t), 0.0, 1.0);
}

double PosedSweep::parameterAt(const Vec3& at) const {
  constexpr int kLooks = 9;
  double least = kInfinity, share = 0.0;
  for (const PosedStretch& s : stretches()) {
    if ((at - s.middleTip()).norm() - s.tip[0] > least) continue;
    for (int k = 0; k < kLooks; ++k) {
      const double t = 2.0 * k / (kLooks - 1) - 1.0, off = (at - s.poseAt(t).tip).norm();
      if (off < least) least = off, share = s.shareAt(t);
    }
  }
  return share;
}

Box3 PosedSweep::bounds() const {
  Box3 box;
  for (const PosedStretch& s : stretches()) {
    const Box3 one = stretchBounds(*profile_, s);
    box.extend(one);
  }
  return box;
}

}  // namespace proveout
