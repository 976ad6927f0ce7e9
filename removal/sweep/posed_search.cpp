#include "removal/sweep/posed_search.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace posed_search_detail {

/// What is shorter holds nothing, by t.
constexpr double kNoWidth = 1e-13;
/// Of rough bounds, mm.
constexpr double kRoundingMm = 1e-7;
/// Nothing is nearer to an axis or a centre than this, mm.
constexpr double kLeastRadius = 1e-12;
/// Newton's method takes what is rounder for this, mm: near an edge it would creep.
constexpr double kLeastStepRadius = 1e-3;
/// Newton's method stops where it promises to gain this share of the tolerance.
constexpr double kGain = 0.05;

/// Where value + slope w + k w^2 / 2 comes down to 0; requires value > 0.
inline double fallsTo(double value, double slope, double k) {
  if (slope >= 0.0 && k >= 0.0) return std::numeric_limits<double>::infinity();
  const double square = slope * slope - 2.0 * k * value;
  if (square < 0.0) return std::numeric_limits<double>::infinity();
  if (slope >= 0.0) return (std::sqrt(square) + slope) / -k;
  return 2.0 * value / (std::sqrt(square) - slope);
}

}  // namespace posed_search_detail

using namespace posed_search_detail;

double PosedSearch::roughBound(const PosedStretch& s) const {
  // The part lies around a piece of its axis, of which a point moves the farther the higher it is. The place
  // on it from which the distance less that way is least:
  const Vec3 axis = s.middleAxis(), w = p_ - s.middleTip();
  const double turn = s.axis[0], z = w.dot(axis), radius = profile_.maxRadius();
  const double rho = std::sqrt(std::max(0.0, w.squaredNorm() - z * z));
  const bool rises = turn < 0.9 && profile_.zMin() >= 0.0;
  const double least = rises ? z + rho * turn / std::sqrt(1.0 - turn * turn) : z;
  const double up = std::clamp(least, profile_.zMin(), profile_.zMax());
  const double reach = rises ? up : std::max(std::abs(profile_.zMin()), std::abs(profile_.zMax()));
  return std::sqrt(rho * rho + (z - up) * (z - up)) - radius - s.mostShift(reach + radius) - kRoundingMm;
}

void PosedSearch::look(const PosedStretch& stretch, std::size_t number, double start) {
  stretch_ = &stretch, number_ = number;
  const auto& [v1, v2, v3] = stretch.tip;
  const auto& [a1, a2, a3] = stretch.axis;
  // The point in a frame that goes with the axis and does not turn about it.
  const double r = (p_ - stretch.middleTip()).norm() + v1, turn2 = a1 * a1 + a2;
  speed_ = a1 * r + v1;
  bend_ = turn2 * r + 2.0 * a1 * v1 + v2;
  third_ = (a1 * a1 * a1 + 5.0 * a1 * a2 + a3) * r + 3.0 * turn2 * v1 + 3.0 * a1 * v2 + v3;
  open_count_ = 0;
  centre_up_ = -std::numeric_limits<double>::infinity();
  settle(-1.0, 1.0, start);
  if (!isOver()) divide();
}

PosedSearch::Pose PosedSearch::pose(double t) {
  ++evaluations_;
  const PosedStretch::Moving m = stretch_->at(t);
  const Vec3 a = m.at.tail<3>(), c1 = m.first.head<3>(), a1 = m.first.tail<3>(), c2 = m.second.head<3>(),
             a2 = m.second.tail<3>();
  const Vec3 w = p_ - m.at.head<3>().matrix();
  const double z = w.dot(a);
  const Vec3 u = w - z * a;
  const double rho = std::max(u.norm(), kLeastRadius);
  const Vec3 e = rho > 1e-9 ? Vec3(u / rho) : a.unitOrthogonal();
  const ProfileSample s = profile_.sample(rho, z);

  const double along = c1.dot(a), turned = e.dot(a1);
  const Vec3 u1 = along * a - c1 - z * a1;
  const double z1 = w.dot(a1) - along, rho1 = e.dot(u1);
  const double u2 = 2.0 * along * turned - rho * turned * turned - z * e.dot(a2) - e.dot(c2);
  const double z2 = w.dot(a2) - 2.0 * c1.dot(a1) - c2.dot(a);
  const double across2 = std::max(0.0, u1.squaredNorm() - rho1 * rho1), out = std::max(0.0, s.gr);

  Pose pose;
  pose.t = t, pose.value = s.value, pose.slope = s.gr * rho1 + s.gz * z1;
  pose.count = 1;
  Bound& plain = pose.bounds[0];
  plain.k = s.gr * u2 + s.gz * z2;
  plain.third = third_;
  plain.widest = 2.0, plain.speed = speed_;
  plain.round[0] = {out * across2, 3.0 * out * std::sqrt(across2) * bend_, rho};
  plain.round[1] = {0.0, 0.0, 1.0};
  pose.bend = plain.k + out * across2 / std::max(rho, kLeastStepRadius);
  if (s.radius > 0.0) {
    const double beside = s.gr * z1 - s.gz * rho1;
    pose.bend += beside * beside / std::max(s.radius, kLeastStepRadius);
    addRound(s, rho, z, rho1, z1, m, pose);
  }
  // On a sharp edge itself the profile's gradient is that of a level top.
  if (s.value == 0.0 && s.gz == 1.0 && z < profile_.zMax()) pose.count = 0;
  if (pose.value < best_.value) best_ = {number_, t, pose.value};
  return pose;
}

/// Most lengths of the first three derivatives of the point so high above the tip. By its own polynomial: a
/// tool that turns about the middle of its ball leaves that where it is, and bounds by those of tip and axis
/// would let no search end.
const std::array<double, 3>& PosedSearch::centreBounds(double up) {
  if (centre_up_ == up) return centre_;
  centre_up_ = up;
  centre_ = {};
  for (int k = 1; k <= PosedStretch::kDegree; ++k) {
    const PosedStretch::Row& row = stretch_->rows[static_cast<std::size_t>(k)];
    const double size = (row.head<3>() + up * row.tail<3>()).matrix().norm();
    centre_[0] += k * size;
    centre_[1] += k * (k - 1) * size;
    centre_[2] += k * (k - 1) * (k - 2) * size;
  }
  return centre_;
}

/// What is known where the nearest element is an arc: while the point stays in its sector the distance is
/// that from its centre.
void PosedSearch::addRound(const ProfileSample& s, double rho, double z, double rho_rate, double z_rate,
                           const PosedStretch::Moving& m, Pose& to) {
  const ConvexProfile::Element& e = profile_.element(s.element - profile_.firstElementId());
  if (!e.arc) return;
  const double x = rho - e.cr, y = z - e.cz;
  const double ax = e.ar - e.cr, ay = e.az - e.cz, bx = e.br - e.cr, by = e.bz - e.cz;
  const bool ball = e.cr == 0.0;
  double room = std::numeric_limits<double>::infinity();
  if (!ball || e.ar > 0.0) room = std::min(room, ax * y - ay * x);
  if (!ball || e.br > 0.0) room = std::min(room, x * by - y * bx);
  Bound bound = to.bounds[0];
  bound.widest = std::min(2.0, room / (e.radius * speed_));
  if (!ball) bound.widest = std::min(bound.widest, 0.5 * rho / speed_);
  if (!(bound.widest > 0.0)) return;
  const double radius = std::max(s.radius, kLeastRadius);
  if (ball) {
    const Vec3 from = p_ - m.at.head<3>().matrix() - e.cz * m.at.tail<3>().matrix();
    const Vec3 rate = m.first.head<3>() + e.cz * m.first.tail<3>(),
               bend = m.second.head<3>() + e.cz * m.second.tail<3>();
    const double distance = std::max(from.norm(), kLeastRadius), toward = from.dot(rate) / distance;
    const double across2 = std::max(0.0, rate.squaredNorm() - toward * toward);
    const auto& [speed, acceleration, third] = centreBounds(e.cz);
    bound.k = -from.dot(bend) / distance;
    bound.third = third;
    bound.speed = speed;
    bound.round[0] = {across2, 3.0 * std::sqrt(across2) * acceleration, distance};
  } else {
    const double beside = std::abs(s.gr * z_rate - s.gz * rho_rate);
    bound.round[1] = {beside * beside, 3.0 * beside * (bend_ + 2.0 * speed_ * speed_ / rho), radius};
  }
  to.bounds[1] = bound;
  to.count = 2;
}

/// So far from a pose, at most `most`, nothing wanted lies.
double PosedSearch::reachBy(const Pose& from, const Bound& bound, double slope, double most) const {
  const double value = from.value - wanted();
  most = std::min(most, bound.widest);
  double reached = 0.0;
  for (double width = most; width > reached; width *= 0.25) {
    double k = bound.k, third = bound.third;
    for (const Bound::Round& round : bound.round) {
      const double radius = round.radius + bound.speed * width;
      k += round.bend / radius, third += round.third / radius;
    }
    reached = std::max(reached, std::min(width, fallsTo(value, slope, k - third * width / 3.0)));
    if (width < most / 100.0) break;
  }
  return reached;
}

double PosedSearch::reach(const Pose& from, double direction, double most) const {
  if (!(from.value > wanted())) return 0.0;
  double reached = 0.0;
  for (int i = from.count; i-- > 0 && reached < most;)
    reached = std::max(reached,
                       reachBy(from, from.bounds[static_cast<std::size_t>(i)], direction * from.slope, most));
  return reached;
}

void PosedSearch::push(double low, double high) {
  if (!(high - low > kNoWidth)) return;
  if (open_count_ < kMostPieces) {
    open_[static_cast<std::size_t>(open_count_++)] = {low, high};
  } else {  // what lies between is looked at again
    Piece& last = open_.back();
    last = {std::min(last.low, low), std::max(last.high, high)};
  }
}

/// Newton's method between slopes of different signs; at kinks to where the tangents meet.
int PosedSearch::newton(double low, double high, double start, std::array<Pose, kMostNewton>& seen) {
  double t = start, left_value = 0.0, left_slope = 0.0, right_value = 0.0, right_slope = 0.0;
  bool left = false, right = false;
  int count = 0;
  while (count < kMostNewton) {
    const Pose& at = seen[static_cast<std::size_t>(count++)] = pose(t);
    if (count == 1 && reach(at, 1.0, high - t) >= high - t && reach(at, -1.0, t - low) >= t - low) break;
    if (at.slope < 0.0) {
      low = t, left = true, left_value = at.value, left_slope = at.slope;
    } else {
      high = t, right = true, right_value = at.value, right_slope = at.slope;
    }
    double next = at.bend > 0.0 ? t - at.slope / at.bend : (at.slope < 0.0 ? high : low);
    if (left && right && !(next > low && next < high)) {
      next = low + (left_value - right_value + right_slope * (high - low)) / (right_slope - left_slope);
      if (!(next > low && next < high)) next = 0.5 * (low + high);
    } else if (left && right && count > 6) {
      // Between faces Newton's steps may creep: every other one halves.
      const double meet =
          low + (left_value - right_value + right_slope * (high - low)) / (right_slope - left_slope);
      next = count % 3 == 0 ? 0.5 * (low + high) : count % 3 == 1 && meet > low && meet < high ? meet : next;
    }
    next = std::clamp(next, low, high);
    if (std::abs(at.slope * (next - t)) < kGain * goal_.tolerance || high - low < kNoWidth) break;
    t = next;
  }
  return count;
}

/// Looks for a low value from `start` on, and leaves open what that does not settle.
void PosedSearch::settle(double low, double high, double start) {
  std::array<Pose, kMostNewton> seen;
  const int count = newton(low, high, start, seen);
  if (isOver()) return;
  std::sort(seen.begin(), seen.begin() + count, [](const Pose& a, const Pose& b) { return a.t < b.t; });
  double done = low;
  for (int i = 0; i < count; ++i) {
    const Pose& at = seen[static_cast<std::size_t>(i)];
    if (at.t > done) push(done, at.t - reach(at, -1.0, at.t - done));
    done = std::max(done, at.t + reach(at, 1.0, high - at.t));
  }
  push(done, high);
}

void PosedSearch::divide() {
  while (open_count_ > 0 && evaluations_ < kMostPoses && !isOver()) {
    const Piece piece = open_[static_cast<std::size_t>(--open_count_)];
    const double middle = 0.5 * (piece.low + piece.high), before = best_.value;
    const Pose at = pose(middle);
    if (at.value < before - goal_.tolerance) {
      settle(piece.low, piece.high, middle);
      continue;
    }
    push(piece.low, middle - reach(at, -1.0, middle - piece.low));
    push(middle + reach(at, 1.0, piece.high - middle), piece.high);
  }
}

}  // namespace proveout
