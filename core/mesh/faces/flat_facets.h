// The flat facets of a mesh, each of all triangles that lie in one plane, and how they meet.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Neighbours on a curved face turn by no more than this, where the facets are large and where they are
/// small; and leave it by no more than so many mm.
inline constexpr double kSoftTurn = degToRad(20.0), kSteepTurn = degToRad(42.0);
inline constexpr double kMostSoftChord = 0.25, kMostSteepChord = 0.12;

struct FlatFacet {
  Vec3 normal = Vec3::Zero();  ///< unit, out of the material
  Vec3 middle = Vec3::Zero();  ///< by area, mm
  double area = 0.0;           ///< mm2
  bool firm = false;           ///< wide enough for its normal to say something
};

/// The border of a facet to another one.
struct FacetLink {
  std::uint32_t other = 0;
  double length = 0.0;  ///< mm
  double turn = 0.0;    ///< between the normals, rad, >= 0; of two firm facets
  bool smooth = false;  ///< a curved face may go on across it
  bool alike = false;   ///< both are about as wide across it
};

/// A corner of a facet.
struct FacetCorner {
  std::uint32_t vertex = 0;
  /// It is at the end of a smooth border of the facet: where a curved face was divided into facets, so that
  /// it lies on that face. Others may be anywhere on the facet.
  bool on_curve = false;
};

class FlatFacets {
 public:
  /// `near_mm`: how far corners may lie off the plane of their facet. The mesh has to outlive this.
  FlatFacets(const TriMesh& mesh, double near_mm);

  std::size_t size() const { return facets_.size(); }
  const FlatFacet& operator[](std::uint32_t f) const { return facets_[f]; }
  std::span<const FacetLink> links(std::uint32_t f) const { return rowOf(links_, first_link_, f); }
  std::span<const FacetCorner> corners(std::uint32_t f) const { return rowOf(corners_, first_corner_, f); }
  std::uint32_t of(std::size_t triangle) const { return of_triangle_[triangle]; }
  Vec3 point(std::uint32_t vertex) const { return mesh_.positions[vertex].cast<double>(); }
  std::size_t vertices() const { return mesh_.positions.size(); }
  const TriMesh& mesh() const { return mesh_; }

 private:
  template <typename T>
  static std::span<const T> rowOf(const std::vector<T>& all, const std::vector<std::uint32_t>& first,
                                  std::uint32_t f) {
    return std::span(all).subspan(first[f], first[f + 1] - first[f]);
  }
  void joinTriangles(double near_mm);
  void gatherLinks();
  void gatherCorners();

  const TriMesh& mesh_;
  std::vector<std::uint32_t> across_;  ///< per half edge the triangle behind it; kNone: there is not just one
  std::vector<std::uint32_t> of_triangle_;
  std::vector<FlatFacet> facets_;
  std::vector<FacetLink> links_;      ///< facet by facet, by the other's number
  std::vector<FacetCorner> corners_;  ///< facet by facet, by vertex
  std::vector<std::uint32_t> first_link_, first_corner_;
};

}  // namespace proveout
