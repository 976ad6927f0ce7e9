// The faces of a CAD model: what surface each is exactly, and which triangles of its mesh stand for it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/mesh_placement.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

enum class SurfaceKind : std::uint8_t { kPlane, kCylinder, kCone, kSphere, kTorus, kOther };

struct CadFace {
  SurfaceKind kind = SurfaceKind::kOther;
  /// A point of the plane, the centre of sphere and torus, a point on the axis of cylinder and cone; mm.
  Vec3 origin = Vec3::Zero();
  /// Unit. Of a plane: the normal that points out of the material; of a cone: towards the wide end.
  Vec3 axis = Vec3::UnitZ();
  double radius = 0.0;          ///< mm; of a cone: at `origin`; of a torus: of its ring
  double tube_radius = 0.0;     ///< of a torus, mm
  double half_angle_rad = 0.0;  ///< of a cone, 0..pi/2
  double turn_rad = 0.0;        ///< of cylinder and cone: how far round it goes, 0..2 pi
  bool hollow = false;          ///< the material lies outside of the round: a hole, a fillet
  double residual_mm = 0.0;     ///< of one found in facets: how far their corners are off it at most
  std::string name;             ///< as the file has it; may be empty
  std::optional<std::array<float, 3>> colour;  ///< red, green, blue, 0..1

  /// Signed distance of a point to the face's surface without its borders, mm; > 0 outside of the material.
  /// Not of kOther.
  double distance(const Vec3& p) const;
  /// The direction in which that grows, unit.
  Vec3 normalAt(const Vec3& p) const;
  CadFace placed(const MeshPlacement& placement) const;
  /// A hole or a boss, whose size is a diameter: it goes farther round than the end of a slot.
  bool isWholeCylinder() const { return kind == SurfaceKind::kCylinder && turn_rad > 1.1 * kPi; }
};

inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFu;

struct CadFaces {
  std::vector<CadFace> faces;
  std::vector<std::uint32_t> of_triangle;  ///< index of its face for each triangle of the mesh, or kNoFace
  double chord_mm = 0.0;                   ///< the facets of faces of kOther lie no farther off

  /// The face of a triangle where its surface is known exactly; null: it is not.
  const CadFace* exactAt(std::uint32_t triangle) const {
    const std::uint32_t face = of_triangle[triangle];
    return face == kNoFace || faces[face].kind == SurfaceKind::kOther ? nullptr : &faces[face];
  }
};

/// Whether one of a face's names, of which a joined one has several, is that one.
bool isNamed(const CadFace& face, const std::string& name);

/// Whether two exact faces lie in one surface, to `near_mm` and, by their directions, to `near_rad`.
bool sameSurface(const CadFace& a, const CadFace& b, double near_mm, double near_rad);

/// Faces of one surface that meet along an edge of the mesh become one face: CAD systems write a hole as two
/// halves. Their names are put together, "left, right"; how far a round goes round is counted anew.
CadFaces joinedFaces(const TriMesh& mesh, CadFaces faces);

/// The face for people: "hole of diameter 8 at X20.000 Y20.000", "plane at Z5.000", and its name where it has
/// one.
std::string describe(const CadFace& face);

/// The same faces for a mesh that was made of `source`: its triangles are known by their three corners;
/// those that were changed have no face. Both meshes lie where the faces lie.
CadFaces facesOf(const TriMesh& mesh, const TriMesh& source, CadFaces faces);

}  // namespace proveout
