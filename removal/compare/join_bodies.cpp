#include "removal/compare/join_bodies.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/box_tree.h"
#include "core/geometry/place_text.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "removal/compare/mesh_boolean.h"

namespace proveout {

namespace join_detail {

/// Faces of two bodies nearer than this are one face to whoever made them: some roundings of float
/// coordinates, mm.
constexpr double kSameMm = 1e-4;
/// Bodies with such a gap are made larger by this before they are joined, mm.
constexpr double kGrowMm = 6e-5;

/// A solid, with its voids, and what is asked of it.
struct Body {
  explicit Body(TriMesh m)
      : mesh(std::move(m)),
        surface(toSurface(mesh)),
        tree(surface),
        box(meshBounds(mesh)),
        volume(meshVolume(mesh)) {}
  Body(const Body&) = delete;
  TriMesh mesh;
  SurfaceMesh surface;
  TriangleTree tree;
  Box3 box;
  double volume;  ///< mm3
};

/// A place of a's surface, with material of b right in front of it. Looked for in the middles of the
/// triangles and of their thirds.
std::optional<Vec3> faceInside(const Body& a, const Body& b) {
  const Box3 reach = b.box.inflated(kSameMm);
  std::optional<Vec3> found;
  a.tree.forEachIn(reach, [&](std::uint32_t t) {
    const Vec3 normal = a.surface.areaVector(t);
    if (found || !(normal.norm() > 0.0)) return;
    const Vec3 middle = a.surface.middle(t);
    for (int corner = -1; corner < 3 && !found; ++corner) {
      const Vec3 at =
          corner < 0 ? middle : Vec3((2.0 * middle + a.surface.points[a.surface.triangles[t][corner]]) / 3.0);
      if (b.tree.goesRound(at + 2.0 * kSameMm * normal.normalized())) found = at;
    }
  });
  return found;
}

bool meet(const Body& a, const Body& b) {
  if (!a.box.inflated(kSameMm).overlaps(b.box)) return false;
  return surfacesMeet(a.mesh, b.mesh) || faceInside(a, b) || faceInside(b, a);
}

/// Moves vertices that lie near the other body outwards, so that a gap as wide as rounding closes.
TriMesh grown(const Body& body, const Body& towards) {
  std::vector<Vec3> out(body.mesh.positions.size(), Vec3::Zero());
  for (std::size_t t = 0; t < body.surface.triangles.size(); ++t) {
    const Vec3 normal = body.surface.areaVector(t);
    if (!(normal.norm() > 0.0)) continue;
    for (const auto v : body.surface.triangles[t]) out[v] += normal.normalized();
  }
  TriMesh mesh = body.mesh;
  for (std::size_t v = 0; v < out.size(); ++v) {
    if (out[v].isZero() ||
        towards.tree.nearest(body.surface.points[v], TriangleTree::kNone, kSameMm).triangle ==
            TriangleTree::kNone)
      continue;
    mesh.positions[v] = (body.surface.points[v] + kGrowMm * out[v].normalized()).cast<float>();
  }
  return mesh;
}

/// The sum of two bodies whose union cannot be made, by moving one of them by less than rounding; none where
/// they overlap by no more than that may do.
std::optional<TriMesh> sumBeside(const Body& a, const Body& b) {
  const Eigen::Vector3f aside(0.61f, 0.53f, 0.59f);  // along no face that bodies have in common
  TriMesh moved = b.mesh;
  for (auto& p : moved.positions) p += static_cast<float>(kGrowMm) * aside;
  std::optional<TriMesh> sum = booleanOf(a.mesh, moved, BooleanKind::kUnion);
  const double both = sum ? a.volume + b.volume - meshVolume(*sum) : 0.0;
  if (both <= kGrowMm * std::min(meshArea(a.mesh), meshArea(b.mesh))) return std::nullopt;
  return sum;
}

class Joiner {
 public:
  Joiner(const Shells& shells, const std::string& name) : name_(name) {
    std::vector<TriMesh> voids;
    for (TriMesh& shell : shellMeshes(shells)) {
      if (meshVolume(shell) < 0.0) {
        voids.push_back(std::move(shell));
      } else {
        bodies_.push_back(std::make_unique<Body>(std::move(shell)));
      }
    }
    near_ = BoxTree(boxes());
    giveVoids(voids);
    near_ = BoxTree(boxes());
  }

  Result<JoinedBodies> run() {
    JoinedBodies out;
    // Each body is joined with what came before; what that reaches may reach further bodies.
    for (std::size_t last = bodies_.size(); last-- > 0;) {
      if (bodies_[last] == nullptr) continue;
      std::unique_ptr<Body> body = std::move(bodies_[last]);
      for (bool grew = true; grew;) {
        grew = false;
        for (const std::size_t i : bodiesNear(body->box)) {
          Result<std::unique_ptr<Body>> both = joinPair(*body, *bodies_[i]);
          if (!both) return both.error();
          if (*both == nullptr) continue;
          out.joined += out.joined == 0 ? 2 : 1;
          body = std::move(*both);
          bodies_[i] = nullptr;
          grew = true;
          break;
        }
      }
      append(out.mesh, body->mesh);
    }
    return out;
  }

 private:
  std::vector<Box3> boxes() const {
    std::vector<Box3> out;
    for (const auto& body : bodies_) out.push_back(body->box);
    return out;
  }

  /// Those left that may touch the box, in their order.
  std::vector<std::size_t> bodiesNear(const Box3& box) const {
    std::vector<std::size_t> out;
    near_.forEachPlace(box.inflated(2.0 * kSameMm), [&](std::uint32_t place) {
      const std::size_t i = near_.order()[place];
      if (bodies_[i] != nullptr) out.push_back(i);
    });
    std::sort(out.begin(), out.end());
    return out;
  }

  /// To the smallest body around each; a void that none is around stays alone.
  void giveVoids(const std::vector<TriMesh>& voids) {
    std::map<std::size_t, TriMesh> whole;
    std::vector<std::unique_ptr<Body>> alone;
    for (const TriMesh& hollow : voids) {
      const Vec3 probe = hollow.positions.front().cast<double>();
      std::optional<std::size_t> around;
      for (const std::size_t i : bodiesNear({probe, probe})) {
        if (!bodies_[i]->tree.goesRound(probe)) continue;
        if (!around || bodies_[i]->volume < bodies_[*around]->volume) around = i;
      }
      if (around) {
        append(whole.try_emplace(*around, bodies_[*around]->mesh).first->second, hollow);
      } else {
        alone.push_back(std::make_unique<Body>(TriMesh(hollow)));
      }
    }
    for (auto& [body, mesh] : whole) bodies_[body] = std::make_unique<Body>(std::move(mesh));
    std::move(alone.begin(), alone.end(), std::back_inserter(bodies_));
  }

  /// Null: they need not be one.
  Result<std::unique_ptr<Body>> joinPair(const Body& a, const Body& b) const {
    if (!meet(a, b)) return std::unique_ptr<Body>();
    std::optional<TriMesh> sum = booleanOf(a.mesh, b.mesh, BooleanKind::kUnion);
    if (sum && isClean(*sum)) return std::make_unique<Body>(std::move(*sum));
    std::optional<Vec3> at = faceInside(a, b);
    if (!at) at = faceInside(b, a);
    if (!at) {
      // Not asked whether it is clean: in front of a step of rounding is the other body. None: they touch
      // along an edge or at a vertex.
      sum = sumBeside(a, b);
      return sum ? std::make_unique<Body>(std::move(*sum)) : std::unique_ptr<Body>();
    }
    sum = booleanOf(grown(a, b), grown(b, a), BooleanKind::kUnion);
    if (sum && isClean(*sum)) return std::make_unique<Body>(std::move(*sum));
    return inputError(
        fmt::format("{}: bodies overlap at {} mm and cannot be joined; export the model as one solid", name_,
                    placeText(*at)));
  }

  /// No face of the sum lies inside of it.
  static bool isClean(const TriMesh& mesh) {
    const Body sum{TriMesh(mesh)};
    return !faceInside(sum, sum);
  }

  std::string name_;
  std::vector<std::unique_ptr<Body>> bodies_;  ///< null: joined with another, or done
  BoxTree near_;                               ///< of their boxes
};

/// Faces within the material of a single surface that runs through itself; a few thousand triangles are
/// asked.
std::optional<Vec3> innerFace(const TriMesh& mesh) {
  constexpr std::size_t kAsked = 4096;
  const SurfaceMesh surface = toSurface(mesh);
  const TriangleTree tree(surface);
  const std::size_t step = std::max<std::size_t>(1, surface.triangles.size() / kAsked);
  for (std::size_t t = 0; t < surface.triangles.size(); t += step) {
    const Vec3 normal = surface.areaVector(t);
    if (!(normal.norm() > kSameMm)) continue;
    const Vec3 at = surface.middle(t);
    if (tree.goesRound(at + 2.0 * kSameMm * normal.normalized())) return at;
  }
  return std::nullopt;
}

}  // namespace join_detail

Result<JoinedBodies> joinBodies(const Shells& shells, const std::string& name) {
  using namespace join_detail;
  JoinedBodies out;
  if (shells.count == 1) {
    out.mesh = shells.mesh;
  } else {
    Result<JoinedBodies> joined = Joiner(shells, name).run();
    if (!joined) return joined;
    out = std::move(*joined);
    if (out.joined == 0) out.mesh = shells.mesh;  // in its order
  }
  if (const auto at = innerFace(out.mesh)) {
    return inputError(
        fmt::format("{}: the surface runs through itself: a face lies inside of the material at {} mm; "
                    "export the model as one solid",
                    name, placeText(*at)));
  }
  return out;
}

}  // namespace proveout
