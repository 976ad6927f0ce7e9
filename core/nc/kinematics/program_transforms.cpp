#include "core/nc/kinematics/program_transforms.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

/// map := step after map.
void apply(ProgramMap& map, const Mat3& linear, const Vec3& offset) {
  map.linear = linear * map.linear;
  map.offset = linear * map.offset + offset;
}

/// Mirroring and scaling: what becomes of each axis, x * factor + shift.
struct AxisSteps {
  AxisSteps() { factor.fill(1.0); }
  std::array<double, kMaxAxes> factor, shift{};
};

void apply(ProgramMap& map, const AxisSteps& steps) {
  const auto three = [](const std::array<double, kMaxAxes>& a) { return Vec3(a[0], a[1], a[2]); };
  apply(map, three(steps.factor).asDiagonal(), three(steps.shift));
  for (std::size_t k = 0; k < map.factor.size(); ++k) {
    const double factor = steps.factor[k + kMainAxes];
    map.factor[k] *= factor;
    map.shift[k] = map.shift[k] * factor + steps.shift[k + kMainAxes];
  }
  if (map.pair.u < 0) return;
  const auto u = static_cast<std::size_t>(map.pair.u), v = static_cast<std::size_t>(map.pair.v);
  const Vec2 factors(steps.factor[u], steps.factor[v]), shifts(steps.shift[u], steps.shift[v]);
  map.pair.linear = factors.asDiagonal() * map.pair.linear;
  map.pair.offset = factors.cwiseProduct(map.pair.offset) + shifts;
}

bool rotatesMainAxes(const Transforms& t) { return t.rotation_u < kMainAxes && t.rotation_v < kMainAxes; }

/// The centre of the rotation in coordinates behind what was applied before it.
Vec2 pivotOf(const Transforms& t) {
  Vec2 pivot = t.pivot;
  if (!t.pivot_is_scaled || !t.scales) return pivot;
  const auto scaled = [&](double& value, int axis) {
    if (axis >= kMainAxes && !t.scales_further) return;
    const double factor = std::abs(t.factors[axis < kMainAxes ? axis : 0]);
    value = t.scale_center[axis] + factor * (value - t.scale_center[axis]);
  };
  scaled(pivot.x(), t.rotation_u);
  scaled(pivot.y(), t.rotation_v);
  return pivot;
}

void rotate(const Transforms& t, ProgramMap& map) {
  const Vec2 centre = pivotOf(t);
  const auto [sine, cosine] = sinCosDegrees(t.angle_deg);
  if (!rotatesMainAxes(t)) {
    Eigen::Matrix2d turn;
    turn << cosine, -sine, sine, cosine;
    map.pair.linear = turn * map.pair.linear;
    map.pair.offset = turn * (map.pair.offset - centre) + centre;
    return;
  }
  const int u = t.rotation_u, v = t.rotation_v;
  Mat3 linear = Mat3::Identity();
  linear(u, u) = linear(v, v) = cosine;
  linear(u, v) = -sine;
  linear(v, u) = sine;
  Vec3 pivot = Vec3::Zero();
  pivot[u] = centre.x();
  pivot[v] = centre.y();
  apply(map, linear, pivot - linear * pivot);
}

void scale(const Transforms& t, const AxisTable& axes, ProgramMap& map) {
  AxisSteps steps;
  for (int axis = 0; axis < kMaxAxes; ++axis) {
    const bool further = axis >= kMainAxes;
    if (further && (!t.scales_further || axis >= axes.count())) continue;
    if (further && axes.at(axis).rotary() && axis != t.virtual_axis) continue;
    const double told = further ? t.factors.x() : t.factors[axis];
    const double factor = t.mirrors_last ? std::abs(told) : told;
    PROVEOUT_ASSERT(factor != 0.0);  // a map that has an inverse
    steps.factor[static_cast<std::size_t>(axis)] = factor;
    steps.shift[static_cast<std::size_t>(axis)] = (1.0 - factor) * t.scale_center[axis];
  }
  apply(map, steps);
  map.factors = t.factors;
}

void mirror(const Transforms& t, ProgramMap& map) {
  AxisSteps steps;
  for (int axis = 0; axis < kMaxAxes; ++axis) {
    if (!t.mirrored[static_cast<std::size_t>(axis)]) continue;
    steps.factor[static_cast<std::size_t>(axis)] = -1.0;
    steps.shift[static_cast<std::size_t>(axis)] = 2.0 * t.mirror[axis];
  }
  apply(map, steps);
}

/// Negative factors where they mirror about the centre of scaling, outside of the rotation.
void mirrorByFactors(const Transforms& t, ProgramMap& map) {
  AxisSteps steps;
  bool any = false;
  for (int axis = 0; axis < kMainAxes; ++axis) {
    if (t.factors[axis] > 0.0) continue;
    any = true;
    steps.factor[static_cast<std::size_t>(axis)] = -1.0;
    steps.shift[static_cast<std::size_t>(axis)] = 2.0 * t.scale_center[axis];
  }
  if (any) apply(map, steps);
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
  if (t.rotates && !rotatesMainAxes(t)) {
    map.pair.u = t.rotation_u;
    map.pair.v = t.rotation_v;
  }
  if (t.rotates && t.rotation_inside) rotate(t, map);
  if (t.scales) scale(t, axes, map);
  if (t.rotates && !t.rotation_inside) rotate(t, map);
  if (t.scales && t.mirrors_last) mirrorByFactors(t, map);
  if (t.mirrored.any()) mirror(t, map);
  return map;
}

AxisPoint ProgramMap::image(const AxisPoint& p) const {
  if (identity) return p;
  AxisPoint q(linear * p.xyz + offset);
  for (std::size_t k = 0; k < q.more.size(); ++k) q.more[k] = p.more[k] * factor[k] + shift[k];
  if (pair.u < 0) return q;
  const Vec2 uv = pair.linear * pair.of(p) + pair.offset;
  q[pair.u] = uv.x();
  q[pair.v] = uv.y();
  return q;
}

AxisPoint ProgramMap::turned(const AxisPoint& d) const {
  AxisPoint difference = image(d);
  const AxisPoint origin = image(AxisPoint());
  for (int axis = 0; axis < kMaxAxes; ++axis) difference[axis] -= origin[axis];
  return difference;
}

double ProgramMap::sense(const WorkPlane& p) const {
  if (identity) return 1.0;
  if (p.u == pair.u && p.v == pair.v) return pair.linear.determinant() < 0.0 ? -1.0 : 1.0;
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

double ProgramMap::largestFactor(const WorkPlane& plane) const {
  return identity ? 1.0 : std::max(std::abs(factorOf(*this, plane.u)), std::abs(factorOf(*this, plane.v)));
}

double ProgramMap::joinFactor(const WorkPlane& plane) const {
  return identity ? 1.0 : 0.5 * (std::abs(factorOf(*this, plane.u)) + std::abs(factorOf(*this, plane.v)));
}

bool ProgramMap::unequal(const WorkPlane& plane) const {
  return !identity && std::abs(factorOf(*this, plane.u)) != std::abs(factorOf(*this, plane.v));
}

}  // namespace proveout::nc
