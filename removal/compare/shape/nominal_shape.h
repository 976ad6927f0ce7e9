// The curved faces that a nominal's facets stand for.
#pragma once

#include <array>
#include <vector>

#include "core/mesh/cad_faces.h"
#include "core/mesh/signed_distance.h"
#include "core/mesh/surface_mesh.h"

namespace proveout {

/// How far the true surface may be beyond the facets at a place, mm, along the outward normal: it lies
/// between the two. Both 0 on flat faces, `low` < 0 on hollow ones, `high` > 0 on round ones.
struct Bulge {
  double low = 0.0, high = 0.0;
};

/// Reads a mesh as exporters write it: vertices on the true surface, chords between them. A facet belongs to
/// a curved face where it turns the same way, by about the same curvature, against its neighbours on two
/// sides (or lies beside such a facet and is as wide); the chord may not be larger than an exporter's
/// tolerance. Between the vertices the face is the quadratic one with their mean normals: exact to a few per
/// cent of the chord on cylinders, cones, spheres and tori. Vertices that split a chord, as programs leave
/// that cut meshes with meshes, do not end it.
///
/// Facets that meet others on two opposite sides only, at nearly parallel borders (strips of a cylinder, the
/// fan of a cone), are straight along them: what normals at their ends say of that direction is noise.
///
/// What cannot be known is whether a prism of many sides was meant as such. So both readings count: a
/// deviation is one where neither explains it. Regular polygons whose chords would be higher than an
/// exporter's are read as flats, but in doubt: unsureAt() holds the round that they could stand for.
class NominalShape {
 public:
  /// Both must outlive this: a mesh that is closed, manifold but for edges that solids share, and distances
  /// to it, which are asked later only and may be made then: reading takes most memory as long as it goes on.
  NominalShape(const SurfaceMesh& mesh, const SignedDistance& distance);
  /// Takes the faces of the CAD model that the mesh was made of in place of reading them: planes, cylinders,
  /// cones, spheres and tori as they are; facets of other faces count as they are, unsure by their chord.
  NominalShape(const SurfaceMesh& mesh, const SignedDistance& distance, const CadFaces& faces);

  /// At a place that SignedDistance::at found.
  Bulge at(const SurfaceDistance& nearest, const Vec3& place) const;
  /// At a point of a triangle.
  double at(std::uint32_t triangle, const Vec3& point) const;

  /// How far the true face may lie beyond both readings at a place on a triangle, mm: by how much neighbours
  /// lie off the face as read there, around it and within `reach`, and doubt. At most twice the chords; 0 on
  /// flat faces away from curved ones.
  double unsureAt(std::uint32_t triangle, const Vec3& place, double reach) const;
  /// The largest that unsureAt() may say.
  double mostUnsure() const;

  /// The largest bulge there is.
  double largest() const { return largest_; }
  /// The largest that is not known from the CAD model, and where.
  double largestRead() const { return read_ ? largest_ : mostUnsure(); }
  const Vec3& largestReadAt() const { return largest_at_; }
  /// The highest chord of flats that could stand for a round, mm, and where.
  double largestDoubt() const { return largest_doubt_; }
  const Vec3& largestDoubtAt() const { return largest_doubt_at_; }

 private:
  void takeExact(std::uint32_t triangle, const CadFace& face);
  double largestOf(std::uint32_t triangle) const;
  void lookAround();

  const SurfaceMesh& mesh_;
  const SignedDistance& distance_;
  /// Per triangle: of its corners, and how much more the middles of its edges have than the mean of their
  /// ends.
  std::vector<std::array<float, 6>> bulge_;
  std::vector<float> doubt_;  ///< per triangle, mm; empty: there is none
  std::vector<float>
      misfit_;  ///< per triangle: how far off it is read, by its neighbours, mm; empty: all is flat
  std::vector<std::array<float, 2>>
      around_;                 ///< per vertex: the largest bulge and misfit of the triangles around
  bool read_ = true;           ///< false: by the faces of a CAD model
  std::vector<char> faceted_;  ///< per triangle: of a face that is no exact one; empty: there is none
  double chord_ = 0.0;         ///< of those, mm
  double largest_ = 0.0, largest_doubt_ = 0.0;
  Vec3 largest_at_ = Vec3::Zero(), largest_doubt_at_ = Vec3::Zero();
};

}  // namespace proveout
