// The blank as a grid, from a closed mesh.
#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "removal/grid/face_numbers.h"
#include "removal/grid/leaf_changes.h"
#include "removal/grid/stock_impl.h"
#include "removal/vdb/vdb_coord.h"
#include "removal/vdb/vdb_extern.h"
#include "removal/vdb/vdb_module.h"

namespace proveout {

namespace {

/// Voxels on either side of the surface that the rasteriser fills: a cell that the surface crosses has its
/// corners within sqrt(3) of it, and the search for the nearest triangle looks one further.
constexpr float kBand = 3.0f;

/// Adapter that OpenVDB's rasteriser reads a mesh through, in index space of the stock's grid.
class MeshAdapter {
 public:
  MeshAdapter(const TriMesh& mesh, const Stock::Impl& impl) : mesh_(mesh), impl_(impl) {}
  std::size_t polygonCount() const { return mesh_.triangles.size(); }
  std::size_t pointCount() const { return mesh_.positions.size(); }
  std::size_t vertexCount(std::size_t) const { return 3; }
  void getIndexSpacePoint(std::size_t polygon, std::size_t corner, openvdb::Vec3d& out) const {
    const Vec3 p =
        (mesh_.positions[mesh_.triangles[polygon][corner]].cast<double>() - impl_.origin) / impl_.h;
    out = {p.x(), p.y(), p.z()};
  }

 private:
  const TriMesh& mesh_;
  const Stock::Impl& impl_;
};

Vec3 triangleNormal(const TriMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = mesh.positions[t[0]].cast<double>();
  const Vec3 n = (mesh.positions[t[1]].cast<double>() - a).cross(mesh.positions[t[2]].cast<double>() - a);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::UnitZ());
}

/// Parameter at which start + t * step, 0 <= t <= 1, meets the triangle, or -1.
double hitTriangle(const TriMesh& mesh, int triangle, const Vec3& start, const Vec3& step) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = mesh.positions[t[0]].cast<double>(), ab = mesh.positions[t[1]].cast<double>() - a,
             ac = mesh.positions[t[2]].cast<double>() - a;
  const Vec3 p = step.cross(ac);
  const double det = ab.dot(p);
  if (det == 0.0) return -1.0;
  const Vec3 s = start - a;
  const double u = s.dot(p) / det;
  const Vec3 q = s.cross(ab);
  const double v = step.dot(q) / det;
  constexpr double kSlack = 1e-9;
  if (u < -kSlack || v < -kSlack || u + v > 1.0 + kSlack) return -1.0;
  const double at = ac.dot(q) / det;
  return at >= 0.0 && at <= 1.0 ? at : -1.0;
}

class MeshBlank {
 public:
  MeshBlank(Stock::Impl& impl, const TriMesh& mesh) : impl_(impl), mesh_(mesh) {}

  Status build() {
    openvdb::initialize();
    nearest_ = openvdb::Int32Grid::create(-1);
    const auto unit = openvdb::math::Transform::createLinearTransform(1.0);
    // Distances come in voxels: the adapter works in index space and the transform is the identity.
    grid_ = openvdb::tools::meshToVolume<openvdb::FloatGrid>(MeshAdapter(mesh_, impl_), *unit, kBand, kBand,
                                                             0, nearest_.get());
    copyTiles();
    std::vector<LeafChange> changes;
    for (auto it = grid_->tree().cbeginLeaf(); it; ++it) {
      LeafChange change;
      change.origin = fromVdb(it->origin());
      for (int v = 0; v < 512; ++v) {
        if (it->getValue(v) < 0.0f) change.material[v & 7] |= 1ull << (v >> 3);
      }
      changes.push_back(change);
    }
    commitChanges(impl_, addressesOf(changes), [&](std::size_t i, const LeafEdges& edges, const auto&) {
      return crossings(changes[i], edges);
    });
    return Done{};
  }

 private:
  void copyTiles() {
    for (auto it = grid_->tree().cbeginValueAll(); it; ++it) {
      if (it.getLevel() == 0 || it.getValue() >= 0.0f) continue;
      openvdb::CoordBBox box;
      it.getBoundingBox(box);
      impl_.tree.fillInside(leafCoord(fromVdb(box.min())), leafCoord(fromVdb(box.max())));
    }
  }

  std::vector<Crossing> crossings(const LeafChange& leaf, const LeafEdges& edges) const {
    auto distance = grid_->getConstUnsafeAccessor();
    auto nearest = nearest_->getConstUnsafeAccessor();
    std::vector<Crossing> out;
    out.reserve(edges.count);
    forEachEdge(edges, [&](int axis, int x, int y, int z) {
      const Coord at = leaf.origin.offsetBy(x, y, z);
      out.push_back(crossing(nearest, at, axis, distance.getValue(toVdb(at)),
                             distance.getValue(toVdb(at.offsetBy(axis == 0, axis == 1, axis == 2)))));
    });
    return out;
  }

  /// The exact hit of the edge with one of the triangles nearest to the voxels around it; where none is hit
  /// (rounding at a triangle's rim) the distances' own zero.
  template <typename Accessor>
  Crossing crossing(Accessor& nearest, const Coord& at, int axis, float d0, float d1) const {
    Crossing c;
    const Vec3 start = impl_.position(at), step = Vec3::Unit(axis) * impl_.h;
    double best = -1.0;
    int triangle = -1;
    for (int n = 0; n < 28; ++n) {
      Coord near = at.offsetBy(n % 3 - 1, n / 3 % 3 - 1, n / 9 % 3 - 1);
      if (n == 27) {
        near = at;
        near[axis] += 2;
      }
      const int candidate = nearest.getValue(toVdb(near));
      if (candidate < 0) continue;
      const double t = hitTriangle(mesh_, candidate, start, step);
      if (t < 0.0) continue;
      const bool first = d0 < 0.0f ? t < best : t > best;  // the crossing next to the material's end
      if (triangle < 0 || first) {
        best = t;
        triangle = candidate;
      }
    }
    if (triangle < 0) {
      best = d0 / (d0 - d1);
      triangle = nearest.getValue(toVdb(d0 < 0.0f ? at : at.offsetBy(axis == 0, axis == 1, axis == 2)));
    }
    const Vec3 n =
        triangle >= 0 ? triangleNormal(mesh_, triangle) : Vec3(Vec3::Unit(axis) * (d0 < d1 ? 1.0 : -1.0));
    c.element = flatFaceOf(n);
    c.setPosition(best);
    c.setNormal(n);
    return c;
  }

  Stock::Impl& impl_;
  const TriMesh& mesh_;
  openvdb::FloatGrid::Ptr grid_;
  openvdb::Int32Grid::Ptr nearest_;
};

}  // namespace

Status rasteriseMesh(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options) {
  if (Status solid = checkSolid(shape); !solid) return solid;
  impl.initial_volume = meshVolume(shape.mesh);
  const double leaves = meshArea(shape.mesh) / (impl.h * impl.h * 64.0) * 3.0;
  if (const double bytes = 3.0 * leafBytes(leaves), limit = memoryLimit(options); bytes > limit) {
    return memoryError(bytes, limit, impl.h);
  }
  return MeshBlank(impl, shape.mesh).build();
}

}  // namespace proveout
