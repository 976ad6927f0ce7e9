#include "removal/grid/placed_field.h"

namespace proveout {
namespace {

class PlacedField final : public BlankField {
 public:
  PlacedField(std::unique_ptr<BlankField> field, const RigidTransform& place)
      : field_(std::move(field)), place_(place), back_(place.inverse()) {}

  BlankSample sample(const Vec3& p) const override {
    BlankSample s = field_->sample(back_(p));
    s.normal = place_.rotation * s.normal;
    return s;
  }
  double value(const Vec3& p) const override { return field_->value(back_(p)); }
  Box3 bounds() const override { return place_(field_->bounds()); }
  double volume() const override { return field_->volume(); }
  std::optional<FacePoint> facePoint(std::uint64_t face, const Vec3& p, double most) const override {
    std::optional<FacePoint> point = field_->facePoint(face, back_(p), most);
    if (point) *point = {place_(point->p), place_.rotation * point->normal};
    return point;
  }
  bool isSimple(std::uint64_t face) const override { return field_->isSimple(face); }

 private:
  std::unique_ptr<BlankField> field_;
  RigidTransform place_, back_;
};

}  // namespace

bool staysInPlace(const RigidTransform& move) {
  return move.rotation == Eigen::Matrix3d::Identity() && move.translation.isZero(0.0);
}

std::unique_ptr<BlankField> placeField(std::unique_ptr<BlankField> field, const RigidTransform& place) {
  if (staysInPlace(place)) return field;
  return std::make_unique<PlacedField>(std::move(field), place);
}

Result<std::unique_ptr<BlankField>> placedField(const FieldShape& shape) {
  Result<std::unique_ptr<BlankField>> field = shape.body->field();
  if (field) *field = placeField(std::move(*field), shape.place);
  return field;
}

}  // namespace proveout
