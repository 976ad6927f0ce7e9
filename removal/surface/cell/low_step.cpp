#include "removal/surface/cell/low_step.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace proveout {

namespace {

/// Normals lean by no more than this (35 degrees) from their mean. Heights of steps, least and most, and by
/// how much faces of one level may differ, in cells.
const double kParallelCos = std::cos(degToRad(35.0));
constexpr double kLeastStep = 0.02, kMostStep = 1.2, kOneLevel = 0.02;
/// Planes that lean towards each other so much that they meet within this many cells form a feature edge and
/// no step.
constexpr double kMeetWithin = 0.5;
/// If they lean by more than 35 degrees (sine) they are no step in any case.
constexpr double kMostLean = 0.574;
/// How exactly edges are found on the bodies, and from how far aside the wall is probed, in cells; the wall
/// must face aside by at least this.
constexpr double kFoundWithin = 2e-4, kWallFrom = 0.25, kLeastAside = 0.3;
/// Least cosine between a wall's normal and the side, and between an upper face's normal and up; the upper
/// edge is no farther aside than kMostAside, in cells.
constexpr double kUpright = 0.5, kMostAside = 0.6;
/// How far outside the cell the two edges may be.
constexpr double kStepReach = 0.75;
constexpr int kWallRounds = 3, kStepRounds = 5;

class StepFinder {
 public:
  StepFinder(std::span<const SheetPoint> points, ExactFaces& exact) : points_(points), exact_(exact) {}

  std::optional<LowStep> find() {
    LowStep out;
    if (!findUp() || !findLevels() || leansTooFar() || !findAside()) return std::nullopt;
    if (!findWall(out.low) || !findTop(out.low, out.high)) return std::nullopt;
    out.motion = static_cast<MotionId>(low_->id >> 16);
    return out;
  }

 private:
  bool findUp();
  bool findLevels();
  bool leansTooFar() const;
  bool findAside();
  bool findWall(Vec3& b);
  bool findTop(const Vec3& b, Vec3& t);
  double heightOf(const CellFace& f) const {
    const Plane p = planeAt(f, mean_);
    return p.d / p.n.dot(up_);
  }
  bool isLow(std::uint64_t face) { return exact_.source(face).body == body_; }
  bool endsAtRims(std::uint64_t face) {
    const ExactFaces::Source source = exact_.source(face);
    return source.body >= 0 && source.ends_at_rims;
  }
  Vec3 rimNear(const Vec3& x) { return exact_.foot(body_, x + aside_ - up_).p; }
  Vec3 inTheMiddle(const Vec3& b, const Vec3& along) const;

  std::span<const SheetPoint> points_;
  ExactFaces& exact_;
  Faces faces_;
  const CellFace *low_ = nullptr, *high_ = nullptr;
  std::int64_t body_ = ExactFaces::kNoBody;
  double step_ = 0.0;
  Vec3 mean_ = Vec3::Zero(), up_ = Vec3::Zero();
  Vec3 aside_ = Vec3::Zero();  ///< unit, across the wall, into the material
};

/// The mean direction of the normals. False if they do not have one in common, are of one face, or none is of
/// a face that could be the lower level.
bool StepFinder::findUp() {
  if (std::ranges::none_of(points_, [&](const SheetPoint& s) { return endsAtRims(s.face); })) return false;
  for (const SheetPoint& s : points_) {
    mean_ += s.p / static_cast<double>(points_.size());
    up_ += s.n;
  }
  up_.normalize();
  bool one = true;
  for (const SheetPoint& s : points_) {
    if (!(s.n.dot(up_) > kParallelCos)) return false;
    one = one && s.face == points_[0].face;
  }
  return !one;
}

/// The levels: one body's faces lowest, and all others above them on one level.
bool StepFinder::findLevels() {
  const auto count = static_cast<std::size_t>(collectFaces(points_, kSameFaceCos, faces_));
  std::array<double, 12> height{};
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    findCurvature(points_, faces_[i]);
    height[i] = heightOf(faces_[i]);
    if (height[i] < height[lowest]) lowest = i;
  }
  low_ = &faces_[lowest];
  body_ = exact_.source(low_->id).body;
  if (!endsAtRims(low_->id)) return false;
  double highest = -std::numeric_limits<double>::infinity(), below_all = height[lowest];
  step_ = -highest;
  for (std::size_t i = 0; i < count; ++i) {
    if (isLow(faces_[i].id)) below_all = std::max(below_all, height[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (isLow(faces_[i].id)) continue;
    const double above = height[i] - below_all;
    highest = std::max(highest, above);
    if (above >= step_) continue;
    step_ = above;
    high_ = &faces_[i];
  }
  return step_ > kLeastStep && step_ < kMostStep && highest < step_ + kOneLevel;
}

/// Whether the levels lean against each other too much, judged where the lower one leans least: it may curve
/// up at its edge.
bool StepFinder::leansTooFar() const {
  double lean = 1.0;
  for (const SheetPoint& s : points_) {
    if (s.face == low_->id) lean = std::min(lean, s.n.cross(high_->normal).norm());
  }
  return lean > kMostLean || step_ < kMeetWithin * lean;
}

/// The direction from the lower points to the upper ones. False if they lie above each other.
bool StepFinder::findAside() {
  Vec3 below = Vec3::Zero(), above = Vec3::Zero();
  double of_below = 0.0;
  for (const SheetPoint& s : points_) {
    const bool low = isLow(s.face);
    (low ? below : above) += s.p;
    of_below += low ? 1.0 : 0.0;
  }
  aside_ = above / (static_cast<double>(points_.size()) - of_below) - below / of_below;
  aside_ -= up_ * up_.dot(aside_);
  if (!(aside_.norm() > kLeastStep)) return false;
  aside_.normalize();
  return true;
}

/// The middle of the part of the line through `b` that is in the cell; without one, its point nearest to the
/// middle of the cell.
Vec3 StepFinder::inTheMiddle(const Vec3& b, const Vec3& along) const {
  constexpr double kAcross = 1e-3;
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(along[k]) < kAcross) continue;
    const double one = -b[k] / along[k], other = (1.0 - b[k]) / along[k];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  const double at = from < to ? 0.5 * (from + to) : along.dot(Vec3::Constant(0.5) - b);
  return b + at * along;
}

/// The lower edge of the wall, probed from aside and below: the body's own edge, or where the floor blends
/// into the wall.
bool StepFinder::findWall(Vec3& b) {
  b = rimNear(mean_ + up_ * heightOf(*low_));
  for (int round = 0; round < kWallRounds; ++round) {
    if (!(outsideBy(b) < 1.0)) return false;
    const ExactFaces::Foot wall = exact_.foot(body_, b + 0.5 * step_ * up_ + kWallFrom * aside_);
    if (!(wall.normal.dot(aside_) < -kLeastAside)) return false;
    aside_ = (up_ * up_.dot(wall.normal) - wall.normal).normalized();
    if (round + 1 == kWallRounds) break;
    const Vec3 before = std::exchange(b, rimNear(inTheMiddle(b, up_.cross(aside_))));
    if ((b - before).norm() < kFoundWithin) break;
  }
  return outsideBy(b) < kStepReach && !exact_.isCovered(b, kLeastStep);
}

/// Where the wall meets the upper face.
bool StepFinder::findTop(const Vec3& b, Vec3& t) {
  const std::int64_t above = exact_.source(high_->id).body;
  const Vec3 along = up_.cross(aside_);
  t = b + step_ * up_;
  for (int round = 0; round < kStepRounds; ++round) {
    Plane upper = planeAt(*high_, t);
    if (above != ExactFaces::kNoBody) {
      const ExactFaces::Foot foot = exact_.foot(above, t - ExactFaces::kProbeDepth * high_->normal);
      if (!(foot.normal.dot(up_) > kUpright)) return false;
      upper = {foot.normal, foot.normal.dot(foot.p - t)};
    }
    const ExactFaces::Foot wall = exact_.foot(body_, t + kWallFrom * aside_);
    if (!(wall.normal.dot(aside_) < -kUpright)) return false;
    const std::array<Plane, 3> planes = {upper, Plane{wall.normal, wall.normal.dot(wall.p - t)},
                                         Plane{along, along.dot(b - t)}};
    const Vec3 move = meetPlanes(planes);
    t += move;
    if (!(outsideBy(t) < kStepReach)) return false;
    if (move.norm() < kFoundWithin) break;
    if (round + 1 == kStepRounds) return false;
  }
  const double high = up_.dot(t - b);
  return high > 0.5 * kLeastStep && high < kMostStep && std::abs(aside_.dot(t - b)) < kMostAside &&
         !exact_.isCovered(t, kLeastStep);
}

}  // namespace

std::optional<LowStep> findLowStep(std::span<const SheetPoint> points, ExactFaces& exact) {
  return exact.active() && !exact.ofBlank() ? StepFinder(points, exact).find() : std::nullopt;
}

}  // namespace proveout
