#include "removal/compare/join_bodies.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/place_text.h"
#include "core/mesh/flat_triangles.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "removal/compare/body_gap.h"
#include "removal/compare/mesh_boolean.h"

namespace proveout {

namespace join_detail {

/// Faces of two bodies nearer than this are one face to whoever made them: some roundings of float
/// coordinates, mm.
constexpr double kSameMm = 1e-4;
/// Bodies with such a gap are made larger by this before they are joined, mm.
constexpr double kGrowMm = 6e-5;
/// Narrower gaps between faces of two bodies are closed, mm: no tool gets into them, and no tolerance of a
/// part is that small.
constexpr double kClosedGapMm = 0.005;
/// Gaps up to this are told, mm: they may be meant, but nothing can cut them.
constexpr double kToldGapMm = 0.05;

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
  double volume;           ///< mm3
  bool one_shell = false;  ///< known to be one shell, without voids
};

/// Whether a place of `shell` that is not on the body is in it; none where all its vertices are on it.
std::optional<bool> liesIn(const TriMesh& shell, const Body& body) {
  for (const auto& position : shell.positions) {
    const Vec3 p = position.cast<double>();
    if (body.tree.nearest(p, TriangleTree::kNone, kSameMm).triangle == TriangleTree::kNone)
      return body.tree.goesRound(p);
  }
  return std::nullopt;
}

/// Whether their surfaces may have points in common, by the boxes of their triangles.
bool comeNear(const TriMesh& shell, const Body& body) {
  bool near = false;
  for (const auto& t : shell.triangles) {
    Box3 box;
    for (const std::uint32_t v : t) box.extend(shell.positions[v].cast<double>());
    body.tree.forEachIn(box.inflated(kSameMm), [&](std::uint32_t) { near = true; });
    if (near) break;
  }
  return near;
}

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

enum class Meeting : std::uint8_t { kNone, kMeet, kSecondInFirst, kFirstInSecond };

Meeting meetingOf(const Body& a, const Body& b) {
  if (!a.box.inflated(kSameMm).overlaps(b.box)) return Meeting::kNone;
  if (surfacesMeet(a.mesh, b.mesh)) return Meeting::kMeet;
  if (a.one_shell && b.one_shell) {
    if (liesIn(b.mesh, a).value_or(false)) return Meeting::kSecondInFirst;
    if (liesIn(a.mesh, b).value_or(false)) return Meeting::kFirstInSecond;
  }
  return faceInside(a, b) || faceInside(b, a) ? Meeting::kMeet : Meeting::kNone;
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
  explicit Joiner(const std::string& name) : name_(name) {}

  Result<JoinedBodies> run(const Shells& shells) {
    if (const Status taken = takeApart(shells); !taken) return taken.error();
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
    tellGaps(out);
    out.changed = out.joined > 0 || cut_voids_;
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
    near_.forEachPlace(box.inflated(2.0 * kToldGapMm), [&](std::uint32_t place) {
      const std::size_t i = near_.order()[place];
      if (bodies_[i] != nullptr) out.push_back(i);
    });
    std::sort(out.begin(), out.end());
    return out;
  }

  Status takeApart(const Shells& shells) {
    std::vector<TriMesh> voids;
    for (TriMesh& whole : shellMeshes(shells)) {
      TriMesh shell = withoutFlatTriangles(std::move(whole));
      if (meshVolume(shell) < 0.0) {
        voids.push_back(std::move(shell));
      } else {
        bodies_.push_back(std::make_unique<Body>(std::move(shell)));
        bodies_.back()->one_shell = true;
      }
    }
    near_ = BoxTree(boxes());
    const Status given = giveVoids(voids);
    near_ = BoxTree(boxes());
    return given;
  }

  /// To the smallest body around each; a void that none is around stays alone.
  Status giveVoids(const std::vector<TriMesh>& voids) {
    std::map<std::size_t, TriMesh> whole;
    std::vector<std::unique_ptr<Body>> alone;
    for (const TriMesh& hollow : voids) {
      std::optional<std::size_t> around;
      for (const std::size_t i : bodiesNear(meshBounds(hollow))) {
        if (around && bodies_[i]->volume >= bodies_[*around]->volume) continue;
        if (liesIn(hollow, *bodies_[i]).value_or(false)) around = i;
      }
      if (!around) {
        alone.push_back(std::make_unique<Body>(TriMesh(hollow)));
        continue;
      }
      TriMesh& mesh = whole.try_emplace(*around, bodies_[*around]->mesh).first->second;
      if (const Status cut = takeOut(hollow, *bodies_[*around], mesh); !cut) return cut;
    }
    for (auto& [body, mesh] : whole) bodies_[body] = std::make_unique<Body>(std::move(mesh));
    std::move(alone.begin(), alone.end(), std::back_inserter(bodies_));
    return Done{};
  }

  /// Adds a void to what is left of its body; one that reaches the surface is cut out.
  Status takeOut(const TriMesh& hollow, const Body& body, TriMesh& mesh) {
    if (!comeNear(hollow, body) || !surfacesMeet(hollow, body.mesh)) {
      append(mesh, hollow);
      return Done{};
    }
    TriMesh solid = hollow;
    for (auto& t : solid.triangles) std::swap(t[1], t[2]);
    std::optional<TriMesh> rest = booleanOf(mesh, solid, BooleanKind::kDifference);
    if (!rest || !isClean(*rest)) {
      return inputError(
          fmt::format("{}: a void reaches the surface of its body at {} mm and cannot be taken out; "
                      "export the model as one solid",
                      name_, placeText(hollow.positions.front().cast<double>())));
    }
    mesh = std::move(*rest);
    cut_voids_ = true;
    return Done{};
  }

  /// Null: they need not be one.
  Result<std::unique_ptr<Body>> joinPair(const Body& a, const Body& b) {
    switch (meetingOf(a, b)) {
      case Meeting::kNone:
        return closeGap(a, b);
      case Meeting::kSecondInFirst:
        return copyOf(a);
      case Meeting::kFirstInSecond:
        return copyOf(b);
      case Meeting::kMeet:
        break;
    }
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

  static std::unique_ptr<Body> copyOf(const Body& body) {
    auto copy = std::make_unique<Body>(TriMesh(body.mesh));
    copy->one_shell = body.one_shell;
    return copy;
  }

  /// Joins two bodies that stand so close that only the model has a gap. Null: there is none, or one that
  /// stays.
  Result<std::unique_ptr<Body>> closeGap(const Body& a, const Body& b) {
    if (!a.box.inflated(kToldGapMm).overlaps(b.box)) return std::unique_ptr<Body>();
    const auto of_a = findGap(a.surface, a.tree, b.surface, b.tree, kToldGapMm);
    const auto of_b = findGap(b.surface, b.tree, a.surface, a.tree, kToldGapMm);
    if (!of_a || !of_b) return std::unique_ptr<Body>();
    const BodyGap& gap = of_a->width_mm > of_b->width_mm ? *of_a : *of_b;
    if (gap.width_mm > kClosedGapMm) {
      keep(gap, open_);
      return std::unique_ptr<Body>();
    }
    // Faces that the other body covers are gone afterwards: those of the smaller area move.
    const bool first = of_a->area_mm2 <= of_b->area_mm2;
    const BodyGap& side = first ? *of_a : *of_b;
    const TriMesh moved = withFacetsMoved(first ? a.mesh : b.mesh, side.facets, gap.width_mm + kGrowMm);
    std::optional<TriMesh> sum = booleanOf(moved, first ? b.mesh : a.mesh, BooleanKind::kUnion);
    if (sum && isClean(*sum)) {
      keep(gap, closed_);
      return std::make_unique<Body>(std::move(*sum));
    }
    return inputError(
        fmt::format("{}: there is a gap of {:.2g} mm between bodies at {} mm, which cannot be closed; "
                    "export the model as one solid",
                    name_, gap.width_mm, placeText(gap.where)));
  }

  static void keep(const BodyGap& gap, std::optional<BodyGap>& widest) {
    if (!widest || gap.width_mm > widest->width_mm) widest = gap;
  }

  void tellGaps(JoinedBodies& out) const {
    if (closed_) {
      out.notes.push_back(fmt::format("{}: closed a gap of {:.2g} mm between bodies at {} mm", name_,
                                      closed_->width_mm, placeText(closed_->where)));
    }
    if (open_) {
      out.notes.push_back(
          fmt::format("{}: there is a gap of {:.2g} mm between bodies at {} mm: material that is left in it "
                      "counts as excess, "
                      "as deep as the bodies are thick; export the model as one solid if it is not meant",
                      name_, open_->width_mm, placeText(open_->where)));
    }
  }

  /// No face of the sum lies inside of it.
  static bool isClean(const TriMesh& mesh) {
    const Body sum{TriMesh(mesh)};
    return !faceInside(sum, sum);
  }

  std::string name_;
  bool cut_voids_ = false;
  std::optional<BodyGap> closed_, open_;       ///< the widest of each
  std::vector<std::unique_ptr<Body>> bodies_;  ///< null: joined with another, or done
  BoxTree near_;                               ///< of their boxes
};

/// A face that bounds no material: with some right in front of it, or none right behind it, as where a
/// surface runs through itself. A few thousand triangles are asked.
std::optional<Vec3> idleFace(const TriMesh& mesh) {
  constexpr std::size_t kAsked = 4096;
  constexpr double kBroad = 10.0 * kSameMm;  // in less one may look past an edge
  const SurfaceMesh surface = toSurface(mesh);
  const TriangleTree tree(surface);
  const std::size_t step = std::max<std::size_t>(1, surface.triangles.size() / kAsked);
  for (std::size_t t = 0; t < surface.triangles.size(); t += step) {
    const Vec3 normal = surface.areaVector(t);
    if (!(normal.norm() > kSameMm)) continue;
    const Vec3 at = surface.middle(t), ahead = 2.0 * kSameMm * normal.normalized();
    if (tree.goesRound(at + ahead)) return at;
    double longest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& v = surface.triangles[t];
      longest = std::max(longest, (surface.points[v[(c + 1) % 3]] - surface.points[v[c]]).norm());
    }
    if (normal.norm() > kBroad * longest && !tree.goesRound(at - ahead)) return at;
  }
  return std::nullopt;
}

}  // namespace join_detail

Result<JoinedBodies> joinBodies(const Shells& shells, const std::string& name) {
  using namespace join_detail;
  JoinedBodies out;
  PROVEOUT_ASSERT(shells.shell_of.size() == shells.mesh.triangles.size());
  if (shells.count == 1) {
    out.mesh = shells.mesh;
  } else {
    Result<JoinedBodies> joined = Joiner(name).run(shells);
    if (!joined) return joined;
    out = std::move(*joined);
    if (!out.changed) out.mesh = shells.mesh;  // in its order
  }
  if (const auto at = idleFace(out.mesh)) {
    return inputError(
        fmt::format("{}: the surface crosses itself: a face bounds no material at {} mm; "
                    "export the model as one solid",
                    name, placeText(*at)));
  }
  return out;
}

}  // namespace proveout
