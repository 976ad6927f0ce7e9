#include "removal/surface/repair/surface_mend.h"

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
#include "removal/surface/repair/mend_pairs.h"

namespace proveout {

namespace {

using Points = std::array<Vec3, 3>;

/// How far old and new surface may be apart, in cells: what changes the surface least is tried first.
constexpr std::array<double, 3> kReaches = {1e-3, 0.01, 0.05};
/// Rounds over all pairs; each that changes something leaves fewer of them.
constexpr int kRounds = 8;
/// Changes that are tried at most, of some ten microseconds each: for each pair of a group, for a group, and
/// for all, half a second. What then is left is a surface that they cannot mend. A group gets fewer for what
/// is mended elsewhere only beyond the last, so that what is changed in a place mostly depends on this place
/// alone.
constexpr std::size_t kPairTrials = 200, kGroupTrials = 20000, kMostTrials = 50000;
/// How far a vertex is shifted away from a neighbour at most, by their distance.
constexpr float kMostBack = 0.2f;

struct Edit {
  enum Kind { kTurn, kJoin, kMove };
  Kind kind = kMove;
  std::uint32_t a = 0, b = 0;                    ///< the edge; kJoin: a becomes b; kMove: a alone
  Eigen::Vector3f to = Eigen::Vector3f::Zero();  ///< of kMove
};

/// Trials for each group.
std::vector<std::size_t> sharedTrials(const std::vector<MendSurroundings::Group>& groups) {
  std::vector<std::size_t> out;
  std::size_t all = 0;
  for (const MendSurroundings::Group& group : groups)
    all += out.emplace_back(std::min(kGroupTrials, kPairTrials * group.pairs.size()));
  if (all <= kMostTrials) return out;
  for (std::size_t& trials : out) trials = trials * kMostTrials / all;
  return out;
}

/// Changes the triangles of one group.
class Mender {
 public:
  /// `seen`: one a triangle, 0; shared by the menders of all groups.
  Mender(TriMesh& mesh, double cell_mm, const MendSurroundings& around, const MendSurroundings::Group& group,
         std::vector<std::uint32_t>& seen, std::size_t most_trials)
      : edit_(mesh, MeshEditor::FanOrder::kRenewed, group.triangles),
        pairs_(edit_, around.blocks(), kReaches.back() * cell_mm, group.triangles, seen),
        cell_(cell_mm),
        around_(around),
        group_(group),
        most_trials_(most_trials) {}

  /// Returns the pairs that are left.
  std::vector<TrianglePair> run();
  /// Makes the triangles what they were before run().
  void takeBack() { edit_.takeBack(before_); }
  const LostParts& lost() const { return lost_; }

 private:
  using Triangles = std::vector<std::uint32_t>;

  struct Choice {
    Edit edit;
    std::size_t gain = 0;  ///< pairs fewer
    double moved = 0.0;    ///< between old and new surface
  };

  /// What was found out, and where: as long as no triangle in there changes it holds.
  template <typename T>
  struct Found {
    Box3 box;
    T what;
  };

  Points points(std::uint32_t t) const { return cornersOf(edit_.mesh(), t); }
  const Eigen::Vector3f& position(std::uint32_t v) const { return edit_.mesh().positions[v]; }
  bool whole(std::uint32_t v) const { return around_.whole(position(v).cast<double>()); }
  const std::vector<TrianglePair>& pairsBefore(const Edit& edit, const Triangles& triangles);

  Triangles affected(const Edit& edit) const;
  bool allowed(const Edit& edit) const;
  void apply(const Edit& edit);
  double apart(const std::vector<Points>& from, const std::vector<Points>& to, double limit) const;
  Box3 boxOfStar(std::uint32_t v) const;
  Box3 boxOfEdits(std::uint32_t a) const;
  std::vector<Edit> editsAt(std::uint32_t a, bool moves) const;
  std::optional<Choice> tryEdit(const Edit& edit);
  const std::vector<Choice>& choicesAt(std::uint32_t a, bool moves);
  Choice bestFor(const TrianglePair& pair, double reach);
  bool mend(const TrianglePair& pair, double reach);

  MeshEditor edit_;
  MeshEditor::Mark before_ = edit_.mark();
  MendPairs pairs_;
  double cell_;
  const MendSurroundings& around_;
  const MendSurroundings::Group& group_;
  std::unordered_map<std::uint32_t, Found<std::vector<TrianglePair>>>
      pairs_at_;  ///< of the triangles at a vertex, as they are
  std::vector<TrianglePair> turned_pairs_;
  /// Changes at a vertex that help, at any reach, and whether vertices are moved: as all is now.
  std::map<std::pair<std::uint32_t, bool>, Found<std::vector<Choice>>> choices_;
  LostParts lost_;
  std::size_t trials_ = 0, most_trials_;
};

/// Pairs with one of the triangles that the edit changes. Many edits change the same ones.
const std::vector<TrianglePair>& Mender::pairsBefore(const Edit& edit, const Triangles& triangles) {
  const bool star = edit.kind != Edit::kTurn;
  if (star) {
    if (const auto known = pairs_at_.find(edit.a); known != pairs_at_.end()) return known->second.what;
  }
  if (star) pairs_at_[edit.a].box = boxOfStar(edit.a).inflated(kReaches.back() * cell_);
  std::vector<TrianglePair>& pairs = star ? pairs_at_[edit.a].what : turned_pairs_;
  pairs.clear();
  pairs_.find(triangles, MendPairs::kAll, &pairs);
  return pairs;
}

Mender::Triangles Mender::affected(const Edit& edit) const {
  const auto star = edit_.fan(edit.a);
  if (edit.kind != Edit::kTurn) return {star.begin(), star.end()};
  Triangles out;
  for (const std::uint32_t t : star) {
    const auto& v = edit_.mesh().triangles[t];
    if (std::find(v.begin(), v.end(), edit.b) != v.end()) out.push_back(t);
  }
  return out;
}

/// Whether the mesh stays a closed 2-manifold.
bool Mender::allowed(const Edit& edit) const {
  if (edit.kind == Edit::kMove) return true;
  const auto wing = edit_.wing(edit.a, edit.b);
  if (!wing || !whole(wing->c) || !whole(wing->d)) return false;
  return edit.kind == Edit::kTurn ? edit_.canFlip(*wing) : edit_.canCollapse(*wing);
}

/// Requires that it is allowed.
void Mender::apply(const Edit& edit) {
  if (edit.kind == Edit::kMove) return edit_.move(edit.a, edit.to);
  const auto wing = edit_.wing(edit.a, edit.b);
  PROVEOUT_ASSERT(wing.has_value());
  if (edit.kind == Edit::kTurn) {
    edit_.flip(*wing);
  } else {
    edit_.collapse(*wing);
  }
}

/// How far the triangles `from` get away from `to` and from what is near, by samples; infinite beyond
/// `limit`.
double Mender::apart(const std::vector<Points>& from, const std::vector<Points>& to, double limit) const {
  double farthest = 0.0;
  const auto look = [&](const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Points& t : to) least = std::min(least, squaredDistance(p, t));
    if (least <= farthest) return true;
    for (const MendPairs::Near& near : pairs_.near()) {
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

Box3 Mender::boxOfStar(std::uint32_t v) const {
  Box3 box;
  for (const std::uint32_t t : edit_.fan(v)) box.extend(boxOf(points(t)));
  return box;
}

/// Where changes at a vertex change triangles or look at some: around its neighbours, and as far beyond as it
/// is shifted.
Box3 Mender::boxOfEdits(std::uint32_t a) const {
  Box3 box;
  for (const std::uint32_t t : edit_.fan(a)) {
    for (const std::uint32_t v : edit_.mesh().triangles[t]) box.extend(boxOfStar(v));
  }
  return box.inflated(kReaches.back() * cell_ + kMostBack * box.size().maxCoeff());
}

std::vector<Edit> Mender::editsAt(std::uint32_t a, bool moves) const {
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
    } else if (whole(b)) {
      edits.push_back({Edit::kTurn, a, b});
      edits.push_back({Edit::kJoin, a, b});
      edits.push_back({Edit::kJoin, b, a});
    }
  }
  if (!moves) return edits;
  for (const float part : {0.1f, 0.5f, 1.0f}) move(middle, part);
  return edits;
}

/// Tries a change and takes it back. Empty if it leaves as many pairs, or reaches too far.
std::optional<Mender::Choice> Mender::tryEdit(const Edit& edit) {
  if (!allowed(edit)) return std::nullopt;
  const Triangles triangles = affected(edit);
  const std::vector<TrianglePair>& pairs = pairsBefore(edit, triangles);
  if (pairs.empty()) return std::nullopt;
  ++trials_;
  std::vector<Points> was, is;
  for (const std::uint32_t t : triangles) was.push_back(points(t));
  const MeshEditor::Mark before = edit_.mark();
  apply(edit);
  // Most edits help nothing: the pairs that are known tell that at once.
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
    double moved = apart(was, is, reach);
    if (moved <= reach) moved = std::max(moved, apart(is, was, reach));
    if (moved <= reach) choice = {edit, pairs.size() - left, moved};
  }
  edit_.takeBack(before);
  return choice;
}

/// Many pairs have a vertex in common.
const std::vector<Mender::Choice>& Mender::choicesAt(std::uint32_t a, bool moves) {
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

/// The best change for a pair; vertices are moved only where nothing else helps. Without gain if there is
/// none.
Mender::Choice Mender::bestFor(const TrianglePair& pair, double reach) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : pair) {
    for (const std::uint32_t v : edit_.mesh().triangles[t]) {
      if (whole(v) && std::find(vertices.begin(), vertices.end(), v) == vertices.end()) vertices.push_back(v);
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

/// Makes the best change for a pair that still meets. False if there is none.
bool Mender::mend(const TrianglePair& pair, double reach) {
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
  if (best.edit.kind == Edit::kJoin) lost_.vertices.push_back(best.edit.a);
  return true;
}

std::vector<TrianglePair> Mender::run() {
  std::vector<TrianglePair> pairs = group_.pairs;
  for (const double reach : kReaches) {
    for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
      bool any = false;
      for (const TrianglePair& pair : pairs) {
        while (pairs_.meets(pair) && mend(pair, reach * cell_)) any = true;
      }
      if (!any) break;
      pairs = pairs_.among(group_.triangles);
    }
  }
  return pairs;
}

}  // namespace

std::vector<TrianglePair> mendIntersections(TriMesh& mesh, const std::vector<TrianglePair>& pairs,
                                            double cell_mm, MendAim aim) {
  if (pairs.empty()) return {};
  const MendSurroundings around(mesh, cell_mm, pairs);
  const auto& groups = around.groups();
  const std::vector<std::size_t> trials = sharedTrials(groups);
  std::vector<std::uint32_t> seen(mesh.triangles.size(), 0);
  std::vector<std::unique_ptr<Mender>> menders(groups.size());
  std::vector<std::vector<TrianglePair>> left(groups.size());
  parallelFor(std::size_t{0}, groups.size(), [&](std::size_t i) {
    menders[i] = std::make_unique<Mender>(mesh, cell_mm, around, groups[i], seen, trials[i]);
    left[i] = menders[i]->run();
  });
  std::vector<TrianglePair> out;
  for (const auto& list : left) out.insert(out.end(), list.begin(), list.end());
  if (aim == MendAim::kAll && !out.empty()) {
    for (const auto& mender : menders) mender->takeBack();
    return out;
  }
  LostParts all;
  for (const auto& mender : menders) {
    const LostParts& part = mender->lost();
    all.triangles.insert(all.triangles.end(), part.triangles.begin(), part.triangles.end());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
  }
  takeOut(mesh, std::move(all));
  return out;
}

}  // namespace proveout
