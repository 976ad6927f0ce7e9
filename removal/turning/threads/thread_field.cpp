#include "removal/turning/threads/thread_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace proveout {

namespace {

constexpr double kStill = 1e-12;  ///< mm: a coordinate that does not move
constexpr std::size_t kMostBins = 1024;

}  // namespace

PolarPoint PolarPoint::of(const Vec3& p) {
  return {std::sqrt(p.x() * p.x() + p.y() * p.y()), std::atan2(p.y(), p.x()), p.z()};
}

double wrapAngle(double angle) { return angle - 2.0 * kPi * std::round(angle / (2.0 * kPi)); }

HelixSweep::HelixSweep(const ThreadSweep& s, const ThreadOutline& outline, int number)
    : outline_(&outline),
      from_(s.from),
      way_(s.to - s.from),
      start_(s.start_rad),
      turn_(2.0 * kPi * s.turns),
      bend_(s.bend),
      motion_(s.motion),
      number_(number) {
  min_ = s.from.cwiseMin(s.to) + outline.min();
  max_ = s.from.cwiseMax(s.to) + outline.max();
  steepest_ = way_.norm() * (1.0 + std::abs(bend_)) / std::abs(turn_);
}

double HelixSweep::wayAt(double t) const {
  if (t < 0.0) return (1.0 - bend_) * t;
  if (t > 1.0) return 1.0 + (1.0 + bend_) * (t - 1.0);
  return t + bend_ * (t * t - t);
}

double HelixSweep::partAt(double way) const {
  if (bend_ == 0.0) return std::clamp(way, 0.0, 1.0);
  const double b = 1.0 - bend_;
  const double root = std::sqrt(std::max(0.0, b * b + 4.0 * bend_ * way));
  return b + root > 0.0 ? std::min(1.0, 2.0 * way / (b + root)) : 0.0;
}

Vec2 HelixSweep::slopeAt(double t) const {
  return way_ * ((1.0 - bend_ + 2.0 * bend_ * std::clamp(t, 0.0, 1.0)) / turn_);
}

bool HelixSweep::window(const Vec2& low, const Vec2& high, Window& out) const {
  out = {0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    const double least = low[axis] - outline_->max()[axis] - from_[axis],
                 most = high[axis] - outline_->min()[axis] - from_[axis];
    if (std::abs(way_[axis]) < kStill) {
      if (least > 0.0 || most < 0.0) return false;
      continue;
    }
    double a = least / way_[axis], b = most / way_[axis];
    if (a > b) std::swap(a, b);
    if (a > 1.0 || b < 0.0) return false;
    if (a > 0.0) out.first = std::max(out.first, partAt(a) - 1e-9);
    if (b < 1.0) out.last = std::min(out.last, partAt(b) + 1e-9);
  }
  return out.first <= out.last;
}

double HelixSweep::endValue(double r, double t) const {
  const double beyond = std::max(-t, t - 1.0) * std::abs(turn_);
  if (beyond <= -0.5 * kPi) return -r;
  return r * std::sin(std::clamp(beyond, -0.5 * kPi, 0.5 * kPi));
}

double HelixSweep::valueAt(const PolarPoint& p, double t) const {
  return std::max(outline_->near(p.inPlane() - at(t)).value, endValue(p.r, t));
}

Vec3 HelixSweep::turned(const Vec2& normal, const PolarPoint& p, double t) const {
  const double around = p.r > 0.0 ? -normal.dot(slopeAt(t)) / p.r : 0.0;
  const double c = std::cos(p.phi), s = std::sin(p.phi);
  return Vec3(normal.x() * c - around * s, normal.x() * s + around * c, normal.y());
}

HelixSweep::Lean HelixSweep::leanAt(int face, const PolarPoint& p, double t) const {
  if (face == kEndFace) {
    const double angle = (t - (t < 0.5 ? 0.0 : 1.0)) * turn_, sign = turn_ > 0.0 ? 1.0 : -1.0;
    const Vec3 around(-std::sin(p.phi - angle), std::cos(p.phi - angle), 0.0);
    return {(t < 0.5 ? -sign : sign) * p.r * std::sin(angle), (t < 0.5 ? -sign : sign) * around};
  }
  const ThreadOutline::Face near = outline_->nearFace(face, p.inPlane() - at(t));
  return {near.value, turned(near.gradient, p, t)};
}

HelixSweep::Side HelixSweep::sideAt(const PolarPoint& p, double t) const {
  const ThreadOutline::Near near = outline_->near(p.inPlane() - at(t));
  const double end = endValue(p.r, t);
  if (near.value >= end)
    return {near.value, turned(near.gradient, p, t).normalized(), outline_->faceOf(near.side)};
  const double sign = (t < 0.5 ? -1.0 : 1.0) * (turn_ > 0.0 ? 1.0 : -1.0);
  return {end, sign * Vec3(-std::sin(p.phi), std::cos(p.phi), 0.0), kEndFace};
}

double HelixSweep::stretch(double r) const {
  const double lean = steepest_ / std::max(0.5 * r, 1e-12);
  return std::sqrt(1.0 + lean * lean);
}

/// Below 0 within the box: where several boxes hold the point the one whose middle is nearest comes first.
double HelixSweep::boxDistance(const Vec2& p, double t) const {
  const Vec2 q = p - at(t);
  return (outline_->min() - q).cwiseMax(q - outline_->max()).maxCoeff();
}

/// Within r / 2 of the point the radius is at least half of its own, which bounds how fast the value changes.
double HelixSweep::boundAt(const PolarPoint& p, double t) const {
  const double value = valueAt(p, t);
  const double size = std::min(std::abs(value), 0.5 * p.r) / stretch(p.r);
  return value < 0.0 ? -size : size;
}

ThreadField::ThreadField(const std::vector<ThreadSweep>& threads, const Vec2& low, const Vec2& high) {
  std::map<const ConvexOutline*, std::pair<const ThreadOutline*, const ThreadOutline*>> made;
  int number = 0;
  for (const ThreadSweep& s : threads) {
    auto& [outline, mirror] = made[s.outline];
    if (outline == nullptr) {
      outline = outlines_.emplace_back(std::make_unique<ThreadOutline>(*s.outline)).get();
      mirror = outlines_.emplace_back(std::make_unique<ThreadOutline>(mirrored(*s.outline, 0))).get();
    }
    const HelixSweep across(s.acrossAxis(), *mirror, number);
    for (const HelixSweep& sweep : {HelixSweep(s, *outline, number), across}) {
      if (sweep.max().x() > 0.0 && (sweep.min().array() < high.array()).all() &&
          (sweep.max().array() > low.array()).all())
        sweeps_.push_back(sweep);
    }
    ++number;
  }
  if (sweeps_.empty()) return;
  low_ = sweeps_.front().min().y();
  double top = sweeps_.front().max().y(), least = top - low_;
  for (const HelixSweep& s : sweeps_) {
    low_ = std::min(low_, s.min().y());
    top = std::max(top, s.max().y());
    least = std::min(least, s.max().y() - s.min().y());
  }
  bin_height_ = std::max({least / 4.0, (top - low_) / kMostBins, 1e-6});
  bins_.resize(static_cast<std::size_t>((top - low_) / bin_height_) + 1);
  for (std::uint32_t i = 0; i < sweeps_.size(); ++i) {
    for (std::size_t b = binOf(sweeps_[i].min().y()); b <= binOf(sweeps_[i].max().y()); ++b)
      bins_[b].push_back(i);
  }
}

std::size_t ThreadField::binOf(double z) const {
  return static_cast<std::size_t>(
      std::clamp((z - low_) / bin_height_, 0.0, static_cast<double>(bins_.size() - 1)));
}

ThreadField::Bound ThreadField::bound(const PolarPoint& p, double most) const {
  Bound best{most, nullptr, 0.0};
  const Vec2 at = p.inPlane(), all = Vec2::Constant(most);
  forEachNear(at - all, at + all, [&](const HelixSweep& s) {
    const Vec2 reach = Vec2::Constant(std::abs(best.value));
    HelixSweep::Window window;
    if (!s.window(at - reach, at + reach, window)) return;
    // Half a turn before the start and after the end is nearer to them than to anything else of the sweep.
    const double half = kPi / std::abs(s.turn());
    if (window.first <= 0.0) window.first = -half;
    if (window.last >= 1.0) window.last = 1.0 + half;
    const auto ask = [&](double t) {
      const double value = s.boundAt(p, t);
      if (value < best.value) best = {value, &s, t};
    };
    // The pass that is nearest by its box comes first: it leaves little to the others.
    double first = 0.0, least = std::numeric_limits<double>::infinity();
    s.forEachPass(p.phi, window, [&](double t) {
      const double box = s.boxDistance(at, t);
      if (box >= least) return;
      least = box;
      first = t;
    });
    if (!std::isfinite(least)) return;
    ask(first);
    const double stretch = s.stretch(p.r);
    s.forEachPass(p.phi, window, [&](double t) {
      const double box = s.boxDistance(at, t);
      if (t != first && std::min(box, 0.5 * p.r) < stretch * best.value) ask(t);
    });
  });
  return best;
}

}  // namespace proveout
