// A body as facets, and the surfaces that its faces have exactly.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <vector>

namespace proveout::step_reader {

/// See CadFace; `kind` is an index of SurfaceKind.
struct FaceSurface {
  int kind = 5;
  std::array<double, 3> origin{}, axis{0.0, 0.0, 1.0};
  double radius = 0.0, tube_radius = 0.0, half_angle_rad = 0.0, turn_rad = 0.0;
  bool hollow = false;
};

struct Facets {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> face_of;  ///< for each triangle: which of `faces`
  std::vector<TopoDS_Face> faces;
  std::vector<FaceSurface> surfaces;  ///< one a face
};

/// Makes facets of a body: on faces of exact kinds no farther off than `chord_mm`, on a body with other faces
/// no farther than `free_chord_mm`. Throws Refusal where a face cannot be meshed.
/// Whether the facets bound a solid: each edge is used both ways equally often, and their normals point out.
bool areClosed(const Facets& facets);

Facets facetsOf(const TopoDS_Shape& body, double chord_mm, double free_chord_mm);

}  // namespace proveout::step_reader
