#include "core/nc/program_transforms.h"

#include <cmath>

#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

/// map := step after map.
void apply(ProgramMap& map, const Mat3& linear, const Vec3& offset) {
  map.linear = linear * map.linear;
  map.offset = linear * map.offset + offset;
}

void rotate(const Transforms& t, ProgramMap& map) {
  const PlaneFrame frame(t.rotation_plane);
  const auto [sine, cosine] = sinCosDegrees(t.angle_deg);
  Mat3 linear = Mat3::Identity();
  linear(frame.u(), frame.u()) = linear(frame.v(), frame.v()) = cosine;
  linear(frame.u(), frame.v()) = -sine;
  linear(frame.v(), frame.u()) = sine;
  const Vec3 pivot = frame.fromPlane({t.pivot.x(), t.pivot.y(), 0.0});
  apply(map, linear, pivot - linear * pivot);
}

void scale(const Transforms& t, const AxisTable& axes, ProgramMap& map) {
  const Mat3 linear = t.factors.asDiagonal();
  apply(map, linear, t.scale_center.xyz - linear * t.scale_center.xyz);
  map.factors = t.factors;
  for (int axis = kMainAxes; t.scales_further && axis < axes.count(); ++axis) {
    if (axes.at(axis).rotary()) continue;
    const auto k = static_cast<std::size_t>(axis - kMainAxes);
    map.factor[k] = t.factors.x();
    map.shift[k] = (1.0 - t.factors.x()) * t.scale_center[axis];
  }
}

void mirror(const Transforms& t, ProgramMap& map) {
  Vec3 sign = Vec3::Ones(), offset = Vec3::Zero();
  for (int axis = 0; axis < kMaxAxes; ++axis) {
    if (!t.mirrored[static_cast<std::size_t>(axis)]) continue;
    if (axis < kMainAxes) {
      sign[axis] = -1.0;
      offset[axis] = 2.0 * t.mirror[axis];
    } else {
      const auto k = static_cast<std::size_t>(axis - kMainAxes);
      map.factor[k] = -map.factor[k];
      map.shift[k] = 2.0 * t.mirror[axis] - map.shift[k];
    }
  }
  apply(map, sign.asDiagonal(), offset);
}

double factorOf(const ProgramMap& map, int axis) {
  return axis < kMainAxes ? map.factors[axis] : map.factor[static_cast<std::size_t>(axis - kMainAxes)];
}

}  // namespace

ProgramMap programMap(const Transforms& t, const AxisTable& axes) {
  ProgramMap map;
  map.factor.fill(1.0);
  if (!t.any()) return map;
  map.identity = false;
  if (t.rotates && t.rotation_inside) rotate(t, map);
  if (t.scales) scale(t, axes, map);
  if (t.rotates && !t.rotation_inside) rotate(t, map);
  if (t.mirrored.any()) mirror(t, map);
  return map;
}

double ProgramMap::sense(const WorkPlane& p) const {
  if (identity) return 1.0;
  if (p.u < kMainAxes && p.v < kMainAxes) {
    return linear(p.u, p.u) * linear(p.v, p.v) - linear(p.u, p.v) * linear(p.v, p.u) < 0.0 ? -1.0 : 1.0;
  }
  const auto sign = [&](int axis) {
    return axis < kMainAxes ? linear(axis, axis) : factor[static_cast<std::size_t>(axis - kMainAxes)];
  };
  return sign(p.u) * sign(p.v) < 0.0 ? -1.0 : 1.0;
}

double ProgramMap::radiusFactor(const WorkPlane& plane) const {
  return identity ? 1.0 : std::abs(factorOf(*this, plane.u));
}

double ProgramMap::joinFactor(const WorkPlane& plane) const {
  return identity ? 1.0 : 0.5 * (std::abs(factorOf(*this, plane.u)) + std::abs(factorOf(*this, plane.v)));
}

bool ProgramMap::unequal(const WorkPlane& plane) const {
  return !identity && std::abs(factorOf(*this, plane.u)) != std::abs(factorOf(*this, plane.v));
}

}  // namespace proveout::nc
