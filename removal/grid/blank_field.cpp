#include "removal/grid/blank_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "removal/grid/edge_root.h"

namespace proveout {

namespace {

double rowCoordinate(double first, int i, double h) { return first + i * h; }

class BoxField : public BlankField {
 public:
  explicit BoxField(const BoxShape& shape) : box_{shape.min, shape.max} {}

  // The largest of the six signed plane distances: exact at faces, a lower bound at edges outside.
  BlankSample sample(const Vec3& p) const override {
    BlankSample best{-1e300, Vec3::UnitX(), 0};
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box_.min[axis] - p[axis], high = p[axis] - box_.max[axis];
      if (low > best.value) best = {low, -Vec3::Unit(axis), 2 * axis};
      if (high > best.value) best = {high, Vec3::Unit(axis), 2 * axis + 1};
    }
    return best;
  }
  Box3 bounds() const override { return box_; }
  double volume() const override { return box_.size().prod(); }

  LeafBits material(const Vec3& first, double h) const override {
    std::uint64_t layer = ~0ull;
    LeafBits bits{};
    for (int i = 0; i < 8; ++i) {
      if (!within(0, rowCoordinate(first.x(), i, h))) layer &= ~(0xFFull << leafBit(i, 0));
      if (!within(1, rowCoordinate(first.y(), i, h))) layer &= ~(0x0101010101010101ull << i);
    }
    for (int z = 0; z < 8; ++z) bits[z] = within(2, rowCoordinate(first.z(), z, h)) ? layer : 0;
    return bits;
  }
  EdgeHit edgeHit(const Vec3& start, int axis, double length, bool inside) const override {
    // Into the box through its lower face, out of it through the upper one.
    const double wall = inside ? box_.max[axis] : box_.min[axis];
    return {std::clamp((wall - start[axis]) / length, 0.0, 1.0), Vec3::Unit(axis) * (inside ? 1.0 : -1.0),
            2 * axis + (inside ? 1 : 0)};
  }
  bool isLevel() const override { return true; }

 private:
  bool within(int axis, double p) const { return p > box_.min[axis] && p < box_.max[axis]; }

  Box3 box_;
};

class CylinderField : public BlankField {
 public:
  explicit CylinderField(const CylinderShape& shape) : s_(shape) {}

  BlankSample sample(const Vec3& p) const override {
    Vec3 radial = p - s_.base;
    const double along = radial[s_.axis];
    radial[s_.axis] = 0.0;
    const double r = radial.norm();
    const Vec3 out = r > 0.0 ? Vec3(radial / r) : Vec3(Vec3::Unit((s_.axis + 1) % 3));
    BlankSample best{r - s_.radius, out, 0};
    if (-along > best.value) best = {-along, -Vec3::Unit(s_.axis), 1};
    if (along - s_.length > best.value) best = {along - s_.length, Vec3::Unit(s_.axis), 2};
    if (s_.inner_radius > 0.0 && s_.inner_radius - r > best.value) best = {s_.inner_radius - r, -out, 3};
    return best;
  }
  Box3 bounds() const override {
    Box3 box{s_.base - Vec3::Constant(s_.radius), s_.base + Vec3::Constant(s_.radius)};
    box.min[s_.axis] = s_.base[s_.axis];
    box.max[s_.axis] = s_.base[s_.axis] + s_.length;
    return box;
  }
  double volume() const override {
    return kPi * (s_.radius * s_.radius - s_.inner_radius * s_.inner_radius) * s_.length;
  }

 private:
  CylinderShape s_;
};

}  // namespace

LeafBits BlankField::material(const Vec3& first, double h) const {
  LeafBits bits{};
  for (int z = 0; z < 8; ++z) {
    for (int bit = 0; bit < 64; ++bit) {
      const Vec3 p(rowCoordinate(first.x(), bit >> 3, h), rowCoordinate(first.y(), bit & 7, h),
                   rowCoordinate(first.z(), z, h));
      if (sample(p).value < 0.0) bits[z] |= 1ull << bit;
    }
  }
  return bits;
}

BlankField::EdgeHit BlankField::edgeHit(const Vec3& start, int axis, double length, bool inside) const {
  const auto point = [&](double t) { return Vec3(start + Vec3::Unit(axis) * (t * length)); };
  const auto f = [&](double t) { return (inside ? -1.0 : 1.0) * sample(point(t)).value; };
  const double at_start = f(0.0), at_end = f(1.0);
  double t;
  if (at_start <= 0.0) {  // rounding may put an end on the other side by a hair
    t = 0.0;
  } else {
    t = at_end >= 0.0 ? 1.0 : edgeRoot(f, 0.0, at_start, 1.0, at_end, 1e-9);
  }
  const BlankSample s = sample(point(t));
  return {t, s.normal, s.face};
}

std::optional<BlankField::FacePoint> BlankField::facePoint(std::uint64_t, const Vec3&, double) const {
  return std::nullopt;
}

bool BlankField::isSimple(std::uint64_t) const { return true; }

Result<std::unique_ptr<BlankField>> makeBlankField(const BoxShape& s) {
  if (!s.min.allFinite() || !s.max.allFinite() || (s.max - s.min).minCoeff() <= 0.0) {
    return inputError(fmt::format("stock box: every max must be above its min (min {} {} {}, max {} {} {})",
                                  s.min.x(), s.min.y(), s.min.z(), s.max.x(), s.max.y(), s.max.z()));
  }
  return std::unique_ptr<BlankField>(new BoxField(s));
}

Result<std::unique_ptr<BlankField>> makeBlankField(const CylinderShape& s) {
  const bool finite = s.base.allFinite() && std::isfinite(s.radius) && std::isfinite(s.inner_radius) &&
                      std::isfinite(s.length);
  if (!finite || s.axis < 0 || s.axis > 2 || s.radius <= 0.0 || s.length <= 0.0) {
    return inputError("stock cylinder: radius and length must be above 0");
  }
  if (s.inner_radius < 0.0 || s.inner_radius >= s.radius) {
    return inputError("stock tube: the inner radius must be at least 0 and below the outer one");
  }
  return std::unique_ptr<BlankField>(new CylinderField(s));
}

}  // namespace proveout
