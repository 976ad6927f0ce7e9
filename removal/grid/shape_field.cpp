#include "removal/grid/shape_field.h"

#include "core/mesh/signed_distance.h"
#include "removal/grid/placed_field.h"

namespace proveout {

namespace {

/// A closed mesh as a blank. Also for the nearest point: outside of it the distance is exact.
class MeshField final : public BlankField {
 public:
  explicit MeshField(const TriMesh& mesh)
      : surface_(toSurface(mesh)), distance_(surface_), box_(meshBounds(mesh)) {}
  BlankSample sample(const Vec3& p) const override {
    const SurfaceDistance d = distance_.at(p);
    return {d.distance, d.gradient.cast<double>().normalized(), 0};
  }
  Box3 bounds() const override { return box_; }
  double volume() const override { return 0.0; }

 private:
  SurfaceMesh surface_;
  SignedDistance distance_;
  Box3 box_;
};

}  // namespace

Result<std::unique_ptr<BlankField>> shapeField(const StockShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return makeBlankField(*box);
  if (const auto* round = std::get_if<CylinderShape>(&shape)) return makeBlankField(*round);
  if (const auto* known = std::get_if<FieldShape>(&shape)) return placedField(*known);
  if (const auto* mesh = std::get_if<MeshShape>(&shape))
    return std::unique_ptr<BlankField>(std::make_unique<MeshField>(mesh->mesh));
  return std::unique_ptr<BlankField>();
}

}  // namespace proveout
