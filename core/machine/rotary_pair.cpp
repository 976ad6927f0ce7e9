#include "core/machine/rotary_pair.h"

#include <Eigen/Geometry>
#include <cmath>

namespace proveout {

namespace {

/// Axes nearer to parallel than this (sine squared) are.
constexpr double kParallel = 1e-16;
/// How far (square of the half distance of the circles' points) a direction may be out of reach by rounding.
constexpr double kTouch = 1e-14;
/// Directions nearer to an axis than this (sine) lie along it.
constexpr double kAlong = 1e-9;

/// Angle about `axis` from `from` to `to`, deg.
double angleAbout(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 a = from - axis.dot(from) * axis, b = to - axis.dot(to) * axis;
  const double angle = radToDeg(std::atan2(axis.dot(a.cross(b)), a.dot(b)));
  return angle == -180.0 ? 180.0 : angle;
}

}  // namespace

AnglePairs solveAngles(const Vec3& first, const Vec3& second, const Vec3& from, const Vec3& to) {
  AnglePairs out;
  const double k = first.dot(second), sine2 = 1.0 - k * k;
  if (sine2 < kParallel) return out;
  // The meeting direction c keeps its angle to the second axis from `from` and to the first one from `to`.
  const double p = first.dot(to), q = second.dot(from);
  const double alpha = (p - k * q) / sine2, beta = (q - k * p) / sine2;
  const double rest = (1.0 - alpha * alpha - beta * beta - 2.0 * alpha * beta * k) / sine2;
  if (rest < -kTouch) return out;
  const double gamma = rest > kTouch ? std::sqrt(rest) : 0.0;
  const Vec3 across = first.cross(second), middle = alpha * first + beta * second;
  const bool first_free = to.cross(first).norm() < kAlong, second_free = from.cross(second).norm() < kAlong;
  out.count = gamma > 0.0 ? 2 : 1;
  for (int i = 0; i < out.count; ++i) {
    const Vec3 c = middle + (i == 0 ? gamma : -gamma) * across;
    AnglePair& pair = out.pair[static_cast<std::size_t>(i)];
    pair.first_free = first_free;
    pair.second_free = second_free;
    if (!second_free) pair.second = angleAbout(second, from, c);
    if (!first_free) pair.first = angleAbout(first, c, to);
  }
  return out;
}

}  // namespace proveout
