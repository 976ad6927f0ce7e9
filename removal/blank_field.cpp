#include "removal/blank_field.h"

#include <fmt/format.h>

#include <cmath>

namespace proveout {

namespace {

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

 private:
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
