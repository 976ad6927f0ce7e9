// Faces that are features by themselves: planes, cones, spheres, fillets and rounds.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "removal/compare/features/feature_parts.h"

namespace proveout {
namespace single_detail {

void addPlane(const FeatureSearch& s, std::uint32_t f, Characteristic c, Feature& out) {
  const CadFace& face = s.face(f);
  const int axis = frameAxis(face.axis);
  out.kind = FeatureKind::kPlane;
  c.to = c.from + face.axis;
  c.quantity = placeQuantity(face.axis);
  out.characteristics.push_back(c);
  if (axis < 0) {
    c.quantity = Quantity::kAngle;
    out.characteristics.push_back(c);
  }
  c.quantity = Quantity::kFlatness;
  out.characteristics.push_back(c);
}

void addCone(const FeatureSearch& s, std::uint32_t f, Characteristic c, Feature& out) {
  const CadFace& face = s.face(f);
  out.kind = FeatureKind::kCone;
  c.quantity = Quantity::kAngle;
  out.characteristics.push_back(c);
  for (const FaceBorder& border : s.network.borders(f)) {
    if (!s.across(s.face(border.other), face.axis)) continue;
    Characteristic wide = c;
    wide.quantity = Quantity::kConeDiameter;
    wide.faces = {f, border.other};
    const int along = frameAxis(face.axis);
    wide.part = along < 0 ? fmt::format("at {}", placeText(border.middle, Vec3::Zero()))
                          : fmt::format("at {}{:.3f}", "XYZ"[along], border.middle[along] + 0.0);
    out.characteristics.push_back(wide);
  }
  addPlace(f, "", c, face, out.characteristics);
  c.quantity = Quantity::kForm;
  out.characteristics.push_back(c);
}

void addRound(const FeatureSearch& s, std::uint32_t f, const Characteristic& where, Feature& out) {
  const CadFace& face = s.face(f);
  out.kind = face.kind == SurfaceKind::kSphere ? FeatureKind::kSphere : FeatureKind::kRound;
  Characteristic c = where;
  c.quantity = Quantity::kRadius;
  out.characteristics.push_back(c);
  if (face.kind == SurfaceKind::kTorus) {
    c.quantity = Quantity::kDiameter;
    c.part = "circle";
    out.characteristics.push_back(c);
    c.part.clear();
  }
  const bool placed = face.kind != SurfaceKind::kCylinder || face.turn_rad > degToRad(120.0);
  if (placed) addPlace(f, "", c, face, out.characteristics);
  c.quantity = Quantity::kForm;
  out.characteristics.push_back(c);
}

}  // namespace single_detail

void findSingleFaces(FeatureSearch& s) {
  for (std::uint32_t f = 0; f < s.network.size(); ++f) {
    const CadFace& face = s.face(f);
    if (s.taken[f] || face.kind == SurfaceKind::kOther || s.network.corners(f).empty()) continue;
    Feature out;
    Characteristic c;
    c.faces = {f};
    if (face.kind == SurfaceKind::kCylinder || face.kind == SurfaceKind::kCone) {
      const auto range = s.network.along(f, face.origin, face.axis);
      c.from = face.origin + range.low * face.axis;
      c.to = face.origin + range.high * face.axis;
      c.at = face.origin + range.middle() * face.axis;
    } else if (face.kind == SurfaceKind::kPlane) {
      const Vec3 middle = s.network.middle(f);
      c.at = c.from = middle - face.distance(middle) * face.axis;
    } else {
      c.at = c.from = c.to = face.origin;
    }
    out.faces = {f};
    out.at = face.kind == SurfaceKind::kPlane ? c.at : s.network.middle(f);
    out.name = describe(face);
    if (face.kind == SurfaceKind::kPlane) {
      single_detail::addPlane(s, f, c, out);
    } else if (face.kind == SurfaceKind::kCone) {
      single_detail::addCone(s, f, c, out);
    } else {
      single_detail::addRound(s, f, c, out);
    }
    s.add(std::move(out));
  }
}

}  // namespace proveout
