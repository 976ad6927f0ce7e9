#include "removal/surface/mesh/merge_judge.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"

namespace proveout {

namespace {

/// Triangles of merged vertices that lean more than this (73 degrees) from the exact surface are refused.
constexpr double kLeastAgreement = 0.3;
/// Merged triangles may be off the corners of the quads that they replace, and off the middles of the quads'
/// edges, by at most this many times the height of a merged patch.
constexpr double kMostOff = 1.0;

/// What merging made of a quad.
class MergedQuad {
 public:
  /// `before`: as it was, with the length unit and the origin of the mesh.
  explicit MergedQuad(const Quad& before) : normal_(before.normal) {
    const std::array<Vec3, 4>& p = before.p;
    for (std::size_t i = 0; i < 4; ++i) {
      held_[i] = p[i];
      held_[4 + i] = 0.5 * (p[i] + p[(i + 1) % 4]);
    }
    const bool at02 = cutQuad(p, before.middle, normal_, before.smooth_corners).at02;
    held_[8] = at02 ? 0.5 * (p[0] + p[2]) : 0.5 * (p[1] + p[3]);
  }
  /// For a quad that became one triangle.
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = facing(a, b, c);
    for (const Vec3& p : held_) off = std::max(off, std::abs(n.dot(p - a)));
  }
  /// For a quad that became the triangles a, b, c and a, c, d. Each is held against what is on its side of
  /// their edge: a plane may be near to what lies far beside its triangle.
  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 of_b = facing(a, b, c), of_d = facing(a, c, d), to_d = normal_.cross(c - a);
    for (const Vec3& p : held_)
      off = std::max(off, std::abs((to_d.dot(p - a) > 0.0 ? of_d : of_b).dot(p - a)));
  }
  /// Cosine of the largest angle between the exact surface and a triangle.
  double agreement = 1.0;
  /// Largest distance of the points that the triangles replace from their planes.
  double off = 0.0;

 private:
  Vec3 facing(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 area = (b - a).cross(c - a), n = area / (area.norm() + 1e-300);
    agreement = std::min(agreement, normal_.dot(n));
    return n;
  }
  const Vec3& normal_;
  /// The points that it replaces, as they were: corners, middles of the sides, and of the edge that it was
  /// cut along.
  std::array<Vec3, 9> held_;
};

/// Where vertices of the grid are written to in the mesh, mm.
class MeshPlaces {
 public:
  explicit MeshPlaces(const SurfaceGrid& grid) : grid_(grid) {}
  Vec3 of(std::uint32_t vertex) {
    const std::uint32_t cell = grid_.cellOf(vertex);
    if (leaf_ == nullptr || cell - leaf_->base >= leaf_->cells) {
      leaf_ = &grid_.leaves()[grid_.leafOf(cell)];
      origin_ = grid_.impl().position(leaf_->stock->origin);
    }
    const Eigen::Vector3f& p =
        vertex == cell ? grid_.vertex(cell) : leaf_->extra[vertex - leaf_->extra_base].p;
    return toFloat(origin_ + grid_.impl().h * p.cast<double>()).cast<double>();
  }

 private:
  const SurfaceGrid& grid_;
  const SurfaceLeaf* leaf_ = nullptr;  ///< of the last one
  Vec3 origin_ = Vec3::Zero();
};

}  // namespace

MergeJudge::MergeJudge(const SurfaceGrid& grid, const VertexMerger& merger)
    : grid_(grid), merger_(merger), reach_(kMostOff * merger.flatness() * grid.impl().h) {}

void MergeJudge::judgeLeaf(const SurfaceLeaf& leaf, const LeafQuads& quads,
                           std::vector<std::uint32_t>& faults) const {
  const Stock::Impl& impl = grid_.impl();
  const Vec3 origin = impl.position(leaf.stock->origin);
  QuadReader reader(grid_);
  reader.load(leaf);
  MeshPlaces places(grid_);
  const auto addFaults = [&](const Quad& quad) {
    for (const std::uint32_t corner : quad.v) {
      if (merger_.merged(corner)) faults.push_back(merger_.standIn(corner));
    }
  };
  const std::uint8_t* of_quad = quads.states.data();
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    const std::uint8_t state = *of_quad++;
    if (!(state & QuadState::kMerged)) return;
    Quad quad;
    reader.readCorners(axis, x, y, z, quad);
    if (state & QuadState::kBulged) addFaults(quad);
    const Polygon poly = polygonOf(merger_, quad.v);
    if (poly.count == 0) return;
    reader.read(axis, x, y, z, c, quad);
    for (Vec3& p : quad.p) p = origin + impl.h * p;
    quad.middle = origin + impl.h * quad.middle;
    MergedQuad made(quad);
    for (int i = 0; i < poly.count; ++i) quad.p[i] = places.of(poly.v[i]);
    if (poly.count == 3) {
      made.add(quad.p[0], quad.p[1], quad.p[2]);
    } else {
      const int a = cutQuad(quad.p, quad.middle, quad.normal, 0u).at02 ? 0 : 1;
      made.add(quad.p[a], quad.p[a + 1], quad.p[a + 2], quad.p[(a + 3) % 4]);
    }
    if (made.agreement <= kLeastAgreement || made.off > reach_) addFaults(quad);
  });
}

std::vector<std::uint32_t> MergeJudge::faults(const std::vector<LeafQuads>& quads,
                                              const std::vector<std::uint8_t>& changed,
                                              Progress& progress) const {
  std::vector<std::uint32_t> out;
  if (!merger_.active()) return out;
  std::vector<std::vector<std::uint32_t>> of_leaf(quads.size());
  parallelFor(std::size_t{0}, quads.size(), [&](std::size_t i) {
    if (changed[i] != 0 && quads[i].triangles != 0 && !progress.cancelled())
      judgeLeaf(grid_.leaves()[i], quads[i], of_leaf[i]);
  });
  if (progress.cancelled()) return out;
  for (const std::vector<std::uint32_t>& faults : of_leaf)
    out.insert(out.end(), faults.begin(), faults.end());
  return out;
}

}  // namespace proveout
