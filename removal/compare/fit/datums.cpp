#include "removal/compare/fit/datums.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/geometry/place_text.h"
#include "core/mesh/triangle_tree.h"
#include "removal/compare/features/face_fits.h"
#include "removal/compare/fit/fit.h"

namespace proveout {
namespace datum_detail {

/// How far a point may be off the feature that it names, mm.
constexpr double kNear = 1.0;
/// Holes lean no more against the normal of the plane: the cosine.
constexpr double kAcross = 0.996;
constexpr const char* kNames[] = {"first", "second", "third"};

Error wrong(std::size_t k, const Vec3& at, const std::string& what) {
  return inputError(fmt::format("the {} datum, at {} mm, {}", kNames[k], placeText(at), what));
}

/// The face that a datum names.
Result<std::uint32_t> faceAt(const TriangleTree& tree, const CadFaces& faces, std::size_t k, const Vec3& at) {
  const auto found = tree.nearest(at, TriangleTree::kNone, kNear);
  if (found.triangle == TriangleTree::kNone || found.squared > kNear * kNear)
    return wrong(k, at, fmt::format("lies on no face of the nominal within {:g} mm", kNear));
  const CadFace* const face = faces.exactAt(found.triangle);
  if (face == nullptr) return wrong(k, at, "lies on a face that is neither a plane nor a hole");
  const bool hole = face->isWholeCylinder() && face->hollow;
  if (k == 0 && face->kind != SurfaceKind::kPlane)
    return wrong(k, at, "has to lie on a plane; it lies on the " + describe(*face));
  if (k > 0 && !hole)
    return wrong(k, at, "has to lie on the wall of a hole; it lies on the " + describe(*face));
  return faces.of_triangle[found.triangle];
}

/// The mesh with the triangles of some faces alone, with the faces.
struct ChosenFaces {
  TriMesh mesh;
  CadFaces faces;
};
ChosenFaces onlyFaces(const TriMesh& nominal, const CadFaces& faces,
                      const std::array<std::uint32_t, 3>& chosen) {
  ChosenFaces out;
  out.mesh.positions = nominal.positions;
  for (const std::uint32_t face : chosen) out.faces.faces.push_back(faces.faces[face]);
  for (std::size_t t = 0; t < nominal.triangles.size(); ++t) {
    const auto at = std::find(chosen.begin(), chosen.end(), faces.of_triangle[t]);
    if (at == chosen.end()) continue;
    out.mesh.triangles.push_back(nominal.triangles[t]);
    out.faces.of_triangle.push_back(static_cast<std::uint32_t>(at - chosen.begin()));
  }
  return out;
}

/// Where the axis of a hole meets the plane.
Vec3 meeting(const CadFace& plane, const CadFace& hole) {
  return hole.origin + plane.axis.dot(plane.origin - hole.origin) / plane.axis.dot(hole.axis) * hole.axis;
}

/// A plane with an origin in it and a direction of it.
struct Frame {
  Vec3 origin, x, z;
  double length = 0.0;  ///< from hole to hole, mm

  Eigen::Matrix3d axes() const {
    Eigen::Matrix3d out;
    out << x, z.cross(x), z;
    return out;
  }
};
Frame frameOf(const CadFace& plane, const CadFace& first, const CadFace& second) {
  Frame out;
  out.origin = meeting(plane, first);
  out.z = plane.axis;
  const Vec3 way = meeting(plane, second) - out.origin;
  out.length = way.norm();
  out.x = way.normalized();
  return out;
}

Status checkHoles(const ChosenFaces& chosen, const std::vector<Vec3>& datums) {
  constexpr double kLeast = 0.1;  // mm
  const CadFace& plane = chosen.faces.faces[0];
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(plane.axis.dot(chosen.faces.faces[k].axis)) < kAcross)
      return wrong(k, datums[k], "is on a hole that does not go across the plane of the first datum");
  }
  if (frameOf(plane, chosen.faces.faces[1], chosen.faces.faces[2]).length < kLeast)
    return wrong(2, datums[2],
                 "is on a hole with the same axis as that of the second; the turn needs another");
  return Done{};
}

}  // namespace datum_detail

Result<Alignment> alignByDatums(const TriMesh& nominal, const CadFaces& faces,
                                const std::vector<Vec3>& datums, const ExactPart& part) {
  namespace d = datum_detail;
  if (datums.size() != 3)
    return inputError(fmt::format("an alignment by datums has three points, on a plane and two holes, not {}",
                                  datums.size()));
  const TriangleTree tree(toSurface(nominal));
  std::array<std::uint32_t, 3> chosen{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Result<std::uint32_t> face = d::faceAt(tree, faces, k, datums[k]);
    if (!face) return face.error();
    chosen[k] = *face;
  }
  const d::ChosenFaces only = d::onlyFaces(nominal, faces, chosen);
  if (const Status good = d::checkHoles(only, datums); !good) return good.error();
  constexpr std::size_t kMostTriangles = 20'000;
  const double spacing = std::max(0.05, std::sqrt(meshArea(only.mesh) / kMostTriangles));
  const std::vector<FaceFit> fits =
      fitFaces(makeSampleMesh(only.mesh, spacing, kMostTriangles), only.faces, part);
  Alignment out;
  out.kind = AlignKind::kDatums;
  std::array<const FaceFit*, 3> found{};
  for (const FaceFit& fit : fits) found[fit.face] = &fit;
  for (std::size_t k = 0; k < 3; ++k) {
    if (found[k] == nullptr || found[k]->gone() || found[k]->points == 0)
      return d::wrong(k, datums[k], "is on a feature that the part lacks near there");
    out.points += found[k]->points;
    out.left_out += found[k]->missed;
  }
  const d::Frame model = d::frameOf(only.faces.faces[0], only.faces.faces[1], only.faces.faces[2]),
                 made = d::frameOf(found[0]->fitted, found[1]->fitted, found[2]->fitted);
  out.motion.rotation = made.axes() * model.axes().transpose();
  out.motion.translation = made.origin - out.motion.rotation * model.origin;
  out.rms_mm = std::abs(made.length - model.length);
  out.moved_mm = farthestMove(out.motion, nominal);
  out.turned_rad = turnOf(out.motion);
  return out;
}

}  // namespace proveout
