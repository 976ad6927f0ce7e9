#include "removal/surface/repair/intersection_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "core/geometry/triangle.h"
#include "core/mesh/mesh_editor.h"
#include "removal/surface/repair/intersecting_pairs.h"

namespace proveout {

namespace {

using Points = std::array<Vec3, 3>;

/// How far old and new surface may be apart, in cells: what moves the surface least is tried first.
constexpr std::array<double, 3> kReaches = {1e-3, 0.01, 0.05};
/// Rounds over all pairs; each round that changes something leaves fewer of them.
constexpr int kRounds = 8;
/// Limits on the changes tried, of some ten microseconds each: for each pair of a group, for a group, and
/// for all (half a second). What is left then cannot be repaired by such changes. Only beyond the last limit
/// do other groups reduce what a group gets, so that the repair of a place mostly depends on that place
/// alone.
constexpr std::size_t kPairTrials = 200, kGroupTrials = 20000, kMostTrials = 50000;
/// How far a vertex is shifted away from a neighbour at most, as a share of their distance.
constexpr float kMostBack = 0.2f;

struct Edit {
  enum Kind { kFlip, kCollapse, kMove };
  Kind kind = kMove;
  std::uint32_t a = 0, b = 0;                    ///< the edge; kCollapse: a becomes b; kMove: a alone
  Eigen::Vector3f to = Eigen::Vector3f::Zero();  ///< of kMove
};

/// Trials for each group.
std::vector<std::size_t> sharedTrials(const std::vector<RepairRegions::Group>& groups) {
  std::vector<std::size_t> out;
  std::size_t all = 0;
  for (const RepairRegions::Group& group : groups)
    all += out.emplace_back(std::min(kGroupTrials, kPairTrials * group.pairs.size()));
  if (all <= kMostTrials) return out;
  for (std::size_t& trials : out) trials = trials * kMostTrials / all;
  return out;
}

/// Changes the triangles of one group.
class IntersectionRepairer {
 public:
  /// `seen`: one a triangle, 0; shared by the repairers of all groups.
  IntersectionRepairer(TriMesh& mesh, double cell_mm, const RepairRegions& around,
                       const RepairRegions::Group& group, std::vector<std::uint32_t>& seen,
                       std::size_t most_trials)
      : edit_(mesh, MeshEditor::FanOrder::kRenewed, group.triangles),
        pairs_(edit_, around.blocks(), kReaches.back() * cell_mm, group.triangles, seen),
        cell_(cell_mm),
        around_(around),
        group_(group),
        most_trials_(most_trials) {}

  /// Returns the pairs that are left.
  std::vector<TrianglePair> run();
  /// Undoes all changes of run().
  void takeBack() { edit_.takeBack(before_); }
  const LostParts& lost() const { return lost_; }

 private:
  using Triangles = std::vector<std::uint32_t>;

  struct Choice {
    Edit edit;
    std::size_t gain = 0;  ///< pairs fewer
    double moved = 0.0;    ///< between old and new surface
  };

  /// A result and the box that it depends on: it holds as long as no triangle in there changes.
  template <typename T>
  struct Found {
    Box3 box;
    T what;
  };

  Points points(std::uint32_t t) const { return cornersOf(edit_.mesh(), t); }
  const Eigen::Vector3f& position(std::uint32_t v) const { return edit_.mesh().positions[v]; }
  bool hasWholeStar(std::uint32_t v) const { return around_.hasWholeStar(position(v).cast<double>()); }
  const std::vector<TrianglePair>& pairsBefore(const Edit& edit, const Triangles& triangles);

  Triangles affected(const Edit& edit) const;
  bool allowed(const Edit& edit) const;
  void apply(const Edit& edit);
  double deviation(const std::vector<Points>& from, const std::vector<Points>& to, double limit) const;
  Box3 boxOfStar(std::uint32_t v) const;
  Box3 boxOfEdits(std::uint32_t a) const;
  std::vector<Edit> editsAt(std::uint32_t a, bool moves) const;
  std::optional<Choice> tryEdit(const Edit& edit);
  const std::vector<Choice>& choicesAt(std::uint32_t a, bool moves);
  Choice bestFor(const TrianglePair& pair, double reach);
  bool repair(const TrianglePair& pair, double reach);

  MeshEditor edit_;
  MeshEditor::Mark before_ = edit_.mark();
  IntersectingPairs pairs_;
  double cell_;
  const RepairRegions& around_;
  const RepairRegions::Group& group_;
  std::unordered_map<std::uint32_t, Found<std::vector<TrianglePair>>>
      pairs_at_;  ///< of the triangles at a vertex, as they are
  std::vector<TrianglePair> flip_pairs_;
  /// Changes at a vertex that help, at any reach, and whether vertices are moved: as all is now.
  std::map<std::pair<std::uint32_t, bool>, Found<std::vector<Choice>>> choices_;
  LostParts lost_;
  std::size_t trials_ = 0, most_trials_;
};

/// Pairs with one of the triangles that the edit changes; kept, as many edits change the same ones.
const std::vector<TrianglePair>& IntersectionRepairer::pairsBefore(const Edit& edit,
                                                                   const Triangles& triangles) {
  const bool star = edit.kind != Edit::kFlip;
  if (star) {
    if (const auto known = pairs_at_.find(edit.a); known != pairs_at_.end()) return known->second.what;
  }
  if (star) pairs_at_[edit.a].box = boxOfStar(edit.a).inflated(kReaches.back() * cell_);
  std::vector<TrianglePair>& pairs = star ? pairs_at_[edit.a].what : flip_pairs_;
  pairs.clear();
  pairs_.find(triangles, IntersectingPairs::kAll, &pairs);
  return pairs;
}

IntersectionRepairer::Triangles IntersectionRepairer::affected(const Edit& edit) const {
  const auto star = edit_.fan(edit.a);
  if (edit.kind != Edit::kFlip) return {star.begin(), star.end()};
  Triangles out;
  for (const std::uint32_t t : star) {
    const auto& v = edit_.mesh().triangles[t];
    if (std::find(v.begin(), v.end(), edit.b) != v.end()) out.push_back(t);
  }
  return out;
}

/// Whether the mesh stays a closed 2-manifold.
bool IntersectionRepairer::allowed(const Edit& edit) const {
  if (edit.kind == Edit::kMove) return true;
  const auto wing = edit_.wing(edit.a, edit.b);
  if (!wing || !hasWholeStar(wing->c) || !hasWholeStar(wing->d)) return false;
  return edit.kind == Edit::kFlip ? edit_.canFlip(*wing) : edit_.canCollapse(*wing);
}

/// Requires that it is allowed.
void IntersectionRepairer::apply(const Edit& edit) {
  if (edit.kind == Edit::kMove) return edit_.move(edit.a, edit.to);
  const auto wing = edit_.wing(edit.a, edit.b);
  PROVEOUT_ASSERT(wing.has_value());
  if (edit.kind == Edit::kFlip) {
    edit_.flip(*wing);
  } else {
    edit_.collapse(*wing);
  }
}

/// How far the triangles `from` are off `to` and what is near, by samples; infinite beyond `limit`.
double IntersectionRepairer::deviation(const std::vector<Points>& from, const std::vector<Points>& to,
                                       double limit) const {
  double farthest = 0.0;
  const auto look = [&](const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Points& t : to) least = std::min(least, squaredDistance(p, t));
    if (least <= farthest) return true;
    for (const IntersectingPairs::Near& near : pairs_.near()) {
      const Vec3 beyond = (near.box.min - p).cwiseMax(p - near.box.max).cwiseMax(0.0);
      if (beyond.squaredNorm() < least) least = std::min(least, squaredDistance(p, points(near.triangle)));
    }
    farthest = std::max(farthest, least);
    return farthest <= limit * limit;
  };
  for (const Points& t : from) {
    if (!look((t[0] + t[1] + t[2]) / 3.0)) return std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      if (!look(t[i]) || !look(0.5 * (t[i] + t[(i + 1) % 3]))) return std::numeric_limits<double>::infinity();
    }
  }
  return std::sqrt(farthest);
}

Box3 IntersectionRepairer::boxOfStar(std::uint32_t v) const {
  Box3 box;
  for (const std::uint32_t t : edit_.fan(v)) box.extend(boxOf(points(t)));
  return box;
}

/// The box in which edits at a vertex change or read triangles: around its neighbours, and as far beyond as
/// the vertex may be shifted.
Box3 IntersectionRepairer::boxOfEdits(std::uint32_t a) const {
  Box3 box;
  for (const std::uint32_t t : edit_.fan(a)) {
    for (const std::uint32_t v : edit_.mesh().triangles[t]) box.extend(boxOfStar(v));
  }
  return box.inflated(kReaches.back() * cell_ + kMostBack * box.size().maxCoeff());
}

std::vector<Edit> IntersectionRepairer::editsAt(std::uint32_t a, bool moves) const {
  std::vector<Edit> edits;
  const auto star = edit_.fan(a);
  const Eigen::Vector3f& from = position(a);
  const auto move = [&](const Eigen::Vector3f& way, float part) {
    edits.push_back({Edit::kMove, a, a, from + part * (way - from)});
  };
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const std::uint32_t t : star) {
    const std::uint32_t b = edit_.following(t, a, 1);
    middle += position(b) / toFloat(star.size());
    if (moves) {
      for (const float part : {0.05f, 0.2f, 0.5f, -0.05f, -kMostBack}) move(position(b), part);
    } else if (hasWholeStar(b)) {
      edits.push_back({Edit::kFlip, a, b});
      edits.push_back({Edit::kCollapse, a, b});
      edits.push_back({Edit::kCollapse, b, a});
    }
  }
  if (!moves) return edits;
  for (const float part : {0.1f, 0.5f, 1.0f}) move(middle, part);
  return edits;
}

/// Tries an edit and takes it back. None if it does not reduce the pairs or moves the surface too far.
std::optional<IntersectionRepairer::Choice> IntersectionRepairer::tryEdit(const Edit& edit) {
  if (!allowed(edit)) return std::nullopt;
  const Triangles triangles = affected(edit);
  const std::vector<TrianglePair>& pairs = pairsBefore(edit, triangles);
  if (pairs.empty()) return std::nullopt;
  ++trials_;
  std::vector<Points> was, is;
  for (const std::uint32_t t : triangles) was.push_back(points(t));
  const MeshEditor::Mark before = edit_.mark();
  apply(edit);
  // Most edits do not help, which the known pairs show at once.
  const std::size_t most = pairs.size() - 1;
  auto left = static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [&](const TrianglePair& pair) { return pairs_.meets(pair); }));
  if (left <= most) left = pairs_.find(triangles, most);
  std::optional<Choice> choice;
  if (left <= most) {
    const double reach = kReaches.back() * cell_;
    for (const std::uint32_t t : triangles) {
      if (!edit_.gone(t)) is.push_back(points(t));
    }
    double moved = deviation(was, is, reach);
    if (moved <= reach) moved = std::max(moved, deviation(is, was, reach));
    if (moved <= reach) choice = {edit, pairs.size() - left, moved};
  }
  edit_.takeBack(before);
  return choice;
}

/// Edits at a vertex that help; kept, as many pairs have a vertex in common.
const std::vector<IntersectionRepairer::Choice>& IntersectionRepairer::choicesAt(std::uint32_t a,
                                                                                 bool moves) {
  const auto [known, fresh] = choices_.try_emplace({a, moves});
  Found<std::vector<Choice>>& found = known->second;
  if (fresh) {
    found.box = boxOfEdits(a);
    for (const Edit& edit : editsAt(a, moves)) {
      if (const auto choice = tryEdit(edit)) found.what.push_back(*choice);
    }
  }
  return found.what;
}

/// The best edit for a pair; vertices are moved only where nothing else helps. Its gain is 0 if there is
/// none.
IntersectionRepairer::Choice IntersectionRepairer::bestFor(const TrianglePair& pair, double reach) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : pair) {
    for (const std::uint32_t v : edit_.mesh().triangles[t]) {
      if (hasWholeStar(v) && std::find(vertices.begin(), vertices.end(), v) == vertices.end())
        vertices.push_back(v);
    }
  }
  Choice best;
  for (const bool moves : {false, true}) {
    if (best.gain > 0 || trials_ > most_trials_) break;
    for (const std::uint32_t a : vertices) {
      for (const Choice& choice : choicesAt(a, moves)) {
        if (choice.moved > reach || choice.gain < best.gain) continue;
        if (choice.gain > best.gain || choice.moved < best.moved) best = choice;
      }
    }
  }
  return best;
}

/// Makes the best edit for a pair that still intersects. False if there is none.
bool IntersectionRepairer::repair(const TrianglePair& pair, double reach) {
  const Choice best = bestFor(pair, reach);
  if (best.gain == 0) return false;
  const Triangles triangles = affected(best.edit);
  Box3 changed;
  for (const std::uint32_t t : triangles) changed.extend(boxOf(points(t)));
  apply(best.edit);
  for (const std::uint32_t t : triangles) {
    if (!edit_.gone(t)) changed.extend(boxOf(points(t)));
  }
  std::erase_if(pairs_at_, [&](const auto& found) { return found.second.box.overlaps(changed); });
  std::erase_if(choices_, [&](const auto& found) { return found.second.box.overlaps(changed); });
  for (const std::uint32_t t : triangles) {
    if (edit_.gone(t)) {
      lost_.triangles.push_back(t);
    } else {
      pairs_.insert(t);
    }
  }
  if (best.edit.kind == Edit::kCollapse) lost_.vertices.push_back(best.edit.a);
  return true;
}

std::vector<TrianglePair> IntersectionRepairer::run() {
  std::vector<TrianglePair> pairs = group_.pairs;
  for (const double reach : kReaches) {
    for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
      bool any = false;
      for (const TrianglePair& pair : pairs) {
        while (pairs_.meets(pair) && repair(pair, reach * cell_)) any = true;
      }
      if (!any) break;
      pairs = pairs_.among(group_.triangles);
    }
  }
  return pairs;
}

}  // namespace

std::vector<TrianglePair> repairIntersections(TriMesh& mesh, const std::vector<TrianglePair>& pairs,
                                              double cell_mm, RepairAim aim) {
  if (pairs.empty()) return {};
  const RepairRegions around(mesh, cell_mm, pairs);
  const auto& groups = around.groups();
  const std::vector<std::size_t> trials = sharedTrials(groups);
  std::vector<std::uint32_t> seen(mesh.triangles.size(), 0);
  std::vector<std::unique_ptr<IntersectionRepairer>> repairers(groups.size());
  std::vector<std::vector<TrianglePair>> left(groups.size());
  parallelFor(std::size_t{0}, groups.size(), [&](std::size_t i) {
    repairers[i] = std::make_unique<IntersectionRepairer>(mesh, cell_mm, around, groups[i], seen, trials[i]);
    left[i] = repairers[i]->run();
  });
  std::vector<TrianglePair> out;
  for (const auto& list : left) out.insert(out.end(), list.begin(), list.end());
  if (aim == RepairAim::kAll && !out.empty()) {
    for (const auto& repairer : repairers) repairer->takeBack();
    return out;
  }
  LostParts all;
  for (const auto& repairer : repairers) {
    const LostParts& part = repairer->lost();
    all.triangles.insert(all.triangles.end(), part.triangles.begin(), part.triangles.end());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
  }
  takeOut(mesh, std::move(all));
  return out;
}

}  // namespace proveout
