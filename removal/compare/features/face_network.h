// Which faces of a CAD model meet, and how: what features are recognised from.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Where two faces meet.
struct FaceBorder {
  std::uint32_t other = kNoFace;  ///< the face on the other side
  double length_mm = 0.0;
  /// Share of that length, 0..1, that is an outer edge; an inner edge; the rest: one runs into the other
  /// smoothly.
  double convex = 0.0, concave = 0.0;
  Vec3 middle = Vec3::Zero();  ///< of its points, by length

  bool isConvex() const { return convex > 0.5; }
  bool isConcave() const { return concave > 0.5; }
  bool isSmooth() const { return convex + concave < 0.5; }
};

/// Faces, their extents and borders. Faces of no known surface have borders, too.
class FaceNetwork {
 public:
  /// Both have to outlive it. Directions that differ by less than `smooth_rad` run into each other.
  FaceNetwork(const TriMesh& mesh, const CadFaces& faces, double smooth_rad);

  std::size_t size() const { return faces_.faces.size(); }
  const CadFace& face(std::uint32_t f) const { return faces_.faces[f]; }
  std::span<const FaceBorder> borders(std::uint32_t f) const { return borders_[f]; }
  const FaceBorder* border(std::uint32_t a, std::uint32_t b) const;
  double area_mm2(std::uint32_t f) const { return area_[f]; }
  Vec3 middle(std::uint32_t f) const { return middle_[f]; }  ///< by area, mm
  /// Corners of the face's triangles, each once.
  std::span<const std::uint32_t> corners(std::uint32_t f) const { return corners_[f]; }
  Vec3 point(std::uint32_t corner) const { return mesh_.positions[corner].cast<double>(); }
  /// From where to where the face goes along a line, mm from `from`; `direction`: unit.
  struct Range {
    double low = 0.0, high = 0.0;
    double middle() const { return 0.5 * (low + high); }
  };
  Range along(std::uint32_t f, const Vec3& from, const Vec3& direction) const;

 private:
  void gatherFaces();
  void gatherBorders(double smooth_rad);

  const TriMesh& mesh_;
  const CadFaces& faces_;
  std::vector<std::vector<FaceBorder>> borders_;  ///< per face, by the other face's number
  std::vector<std::vector<std::uint32_t>> corners_;
  std::vector<double> area_;
  std::vector<Vec3> middle_;
};

}  // namespace proveout
