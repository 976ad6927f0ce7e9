// Signed distance to a closed triangle mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace proveout {

/// The nearest place of a surface.
struct SurfaceDistance {
  double distance = 0.0;  ///< mm; positive outside, negative inside
  Eigen::Vector3f gradient =
      Eigen::Vector3f::Zero();   ///< unit, of the signed distance; the normal where distance is 0
  std::uint32_t triangle = 0;    ///< that holds the nearest point
  std::int8_t part = kFacePart;  ///< of it, see TrianglePoint
};

/// The sign comes from the normal of the nearest feature: of the face, of the two faces at an edge, or the
/// angle-weighted normal at a vertex, which is exact for surfaces that do not run through themselves (J. A.
/// Baerentzen, H. Aanaes, "Signed distance computation using the angle weighted pseudonormal", 2005). Where
/// that is not to be trusted (slivers, folds, edges of more than two faces, nearly tangential directions),
/// and for distances above `sure_mm`, the winding number decides: faults of a mesh do not turn it.
class SignedDistance {
 public:
  /// `mesh` must outlive this, be closed and have proper triangles; at least one.
  explicit SignedDistance(const SurfaceMesh& mesh, double sure_mm = 0.0);

  SurfaceDistance at(const Vec3& point) const { return at(point, nullptr); }

  /// Distances of all points, in parallel. The result does not depend on the number of threads. Points that
  /// follow each other should lie near each other. Returns an empty vector where `progress` was cancelled.
  std::vector<SurfaceDistance> at(const std::vector<Vec3>& points, Progress& progress, double from,
                                  double to) const;

  bool inside(const Vec3& point) const { return tree_.goesRound(point); }
  const SurfaceMesh& mesh() const { return mesh_; }
  const TriangleTree& tree() const { return tree_; }
  /// The triangle beyond edge `corner` (to the next corner) of a triangle; kNone where it is not just one.
  std::uint32_t neighbour(std::uint32_t triangle, int corner) const {
    return normals_.neighbour[3 * triangle + static_cast<std::uint32_t>(corner)];
  }

 private:
  /// A point whose distance is known: its triangle is a good guess, and its sign may be that of points
  /// nearby.
  struct Known {
    Vec3 point;
    SurfaceDistance distance;
  };
  SurfaceDistance at(const Vec3& point, const Known* known) const;
  struct Normals {
    explicit Normals(const SurfaceMesh& mesh);
    void compute(const SurfaceMesh& mesh);
    void findNeighbours(const SurfaceMesh& mesh);
    void doubtFolds(const SurfaceMesh& mesh);
    // In float: their sides are told to a thousandth, and there is one a triangle.
    std::vector<Eigen::Vector3f> of_face;    ///< unit; zero: not to be trusted
    std::vector<Eigen::Vector3f> of_vertex;  ///< angle-weighted, not unit; zero: not to be trusted
    std::vector<std::uint32_t> neighbour;    ///< per half-edge: the triangle beyond
  };
  Vec3 featureNormal(std::uint32_t triangle, int part) const;

  const SurfaceMesh& mesh_;
  double sure_mm_;
  Normals normals_;  ///< before the tree: the table of edges that they take is gone when that is made
  TriangleTree tree_;
};

}  // namespace proveout
