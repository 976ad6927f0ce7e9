#include "removal/surface/surface_mend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/geometry/triangle.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/intersections.h"

namespace proveout {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Pair = std::array<std::uint32_t, 2>;
using Points = std::array<Vec3, 3>;
using Vec3i = Eigen::Vector3i;

/// How far old and new surface may be apart, in cells: what changes the surface least is tried first.
constexpr std::array<double, 3> kReaches = {1e-3, 0.01, 0.05};
/// What is looked at around the pairs, and the edge of the blocks that it is found by, in cells.
constexpr double kMarginCells = 2.0, kBlockCells = 2.0;
/// Stretches that the filter of regions has along each axis.
constexpr int kStretches = 1024;
/// Rounds over all pairs; each that changes something leaves fewer of them.
constexpr int kRounds = 8;
/// Changes that are tried at most, about two seconds, and what each group has of them at the least: what then
/// is left is a surface that they cannot mend.
constexpr std::size_t kMostTrials = 100000, kGroupTrials = 5000;
/// Triangles that one task looks at.
constexpr std::size_t kPart = 8192;
/// How far a vertex is shifted away from a neighbour at most, by their distance.
constexpr float kMostBack = 0.2f;
constexpr std::uint32_t kGone = 0xFFFFFFFFu;
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

Box3 boxOf(const Points& p) {
  return {p[0].cwiseMin(p[1]).cwiseMin(p[2]), p[0].cwiseMax(p[1]).cwiseMax(p[2])};
}

struct Edit {
  enum Kind { kTurn, kJoin, kMove };
  Kind kind = kMove;
  std::uint32_t a = 0, b = 0;                    ///< the edge; kJoin: a becomes b; kMove: a alone
  Eigen::Vector3f to = Eigen::Vector3f::Zero();  ///< of kMove
};

/// Space in blocks.
class Blocks {
 public:
  explicit Blocks(double cell_mm) : scale_(1.0 / (kBlockCells * cell_mm)) {}

  std::uint64_t keyAt(const Vec3& p) const { return keyOf(blockOf(p)); }
  /// Calls body(key) for each block that the box reaches into.
  template <typename Body>
  void each(const Box3& box, Body&& body) const {
    const Vec3i from = blockOf(box.min), to = blockOf(box.max);
    for (int x = from.x(); x <= to.x(); ++x) {
      for (int y = from.y(); y <= to.y(); ++y) {
        for (int z = from.z(); z <= to.z(); ++z) body(keyOf(Vec3i(x, y, z)));
      }
    }
  }

  /// The blocks that the box reaches into, and a little more.
  Box3 around(const Box3& box) const {
    const auto corner = [&](const Vec3& p, double more) {
      return Vec3((blockOf(p).cast<double>() + Vec3::Constant(more)) / scale_);
    };
    return {corner(box.min, -0.1), corner(box.max, 1.1)};
  }

 private:
  Vec3i blockOf(const Vec3& p) const { return (p * scale_).array().floor().cast<int>().matrix(); }
  static std::uint64_t keyOf(const Vec3i& block) {
    const auto part = [](int i) { return static_cast<std::uint64_t>(i) & 0x1FFFFF; };
    return part(block.x()) << 42 | part(block.y()) << 21 | part(block.z());
  }

  double scale_;
};

/// A filter: whether a triangle can touch one of some boxes. Most are nowhere near.
class Regions {
 public:
  void add(const Box3& box) { boxes_.push_back(box); }
  /// To be called when all boxes are added.
  void finish();
  bool mayTouch(const TriMesh& mesh, std::uint32_t t) const {
    const auto& v = mesh.triangles[t];
    const Eigen::Vector3f &a = mesh.positions[v[0]], &b = mesh.positions[v[1]], &c = mesh.positions[v[2]];
    for (int axis = 0; axis < 3; ++axis) {
      const float low = (std::min({a[axis], b[axis], c[axis]}) - low_[axis]) * scale_[axis],
                  high = (std::max({a[axis], b[axis], c[axis]}) - low_[axis]) * scale_[axis];
      if (high < 0.0f || low >= kStretches) return false;
      const int first = low < 0.0f ? 0 : static_cast<int>(low),
                last = high >= kStretches ? kStretches - 1 : static_cast<int>(high);
      const auto& upto = boxes_upto_[axis];
      if (upto[last + 1] == upto[first]) return false;
    }
    return true;
  }

 private:
  std::vector<Box3> boxes_;
  Eigen::Vector3f low_, scale_;
  /// Stretches that a box reaches into, of those before this one.
  std::array<std::array<int, kStretches + 1>, 3> boxes_upto_;
};

void Regions::finish() {
  Box3 all;
  for (const Box3& box : boxes_) all.extend(box);
  low_ = all.min.cast<float>();
  scale_ = (kStretches * all.size().cwiseInverse()).cast<float>();
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, kStretches + 1> taken{};
    for (const Box3& box : boxes_) {
      const auto at = [&](double x) {
        return std::clamp(static_cast<int>((x - low_[axis]) * scale_[axis]), 0, kStretches - 1);
      };
      std::fill(&taken[at(box.min[axis])], &taken[at(box.max[axis])] + 1, 1);
    }
    int sum = 0;
    for (int k = 0; k <= kStretches; ++k) boxes_upto_[axis][k] = std::exchange(sum, sum + taken[k]);
  }
}

/// What is around the pairs, in groups that do not touch each other.
class Surroundings {
 public:
  struct Group {
    std::vector<std::uint32_t> triangles;  ///< ascending
    std::vector<Pair> pairs;               ///< in the order given
  };

  Surroundings(const TriMesh& mesh, double cell_mm, const std::vector<Pair>& pairs);
  const std::vector<Group>& groups() const { return groups_; }
  const Blocks& blocks() const { return blocks_; }
  /// Whether all triangles at a vertex here are known.
  bool whole(const Vec3& p) const { return marked_.contains(blocks_.keyAt(p)); }

 private:
  void mark(const TriMesh& mesh, double margin, const std::vector<Pair>& pairs);
  std::vector<std::uint32_t> nearTriangles(const TriMesh& mesh) const;
  void share(const TriMesh& mesh, const std::vector<std::uint32_t>& near, const std::vector<Pair>& pairs);

  Blocks blocks_;
  std::unordered_set<std::uint64_t> marked_;
  Regions regions_;  ///< that marked_ is in
  std::vector<Group> groups_;
};

Surroundings::Surroundings(const TriMesh& mesh, double cell_mm, const std::vector<Pair>& pairs)
    : blocks_(cell_mm) {
  mark(mesh, kMarginCells * cell_mm, pairs);
  regions_.finish();
  share(mesh, nearTriangles(mesh), pairs);
}

void Surroundings::mark(const TriMesh& mesh, double margin, const std::vector<Pair>& pairs) {
  for (const Pair& pair : pairs) {
    for (const std::uint32_t t : pair) {
      const Box3 box = boxOf(cornersOf(mesh, t)).inflated(margin);
      regions_.add(blocks_.around(box));
      blocks_.each(box, [&](std::uint64_t key) { marked_.insert(key); });
    }
  }
}

std::vector<std::uint32_t> Surroundings::nearTriangles(const TriMesh& mesh) const {
  const auto isNear = [&](std::uint32_t t) {
    if (!regions_.mayTouch(mesh, t)) return false;
    bool inside = false;
    blocks_.each(boxOf(cornersOf(mesh, t)),
                 [&](std::uint64_t key) { inside = inside || marked_.contains(key); });
    return inside;
  };
  const std::size_t count = mesh.triangles.size(), parts = count / kPart + 1;
  std::vector<std::vector<std::uint32_t>> found(parts);
  parallelFor(std::size_t{0}, parts, [&](std::size_t part) {
    for (std::size_t t = part * kPart; t < std::min(count, (part + 1) * kPart); ++t) {
      const auto number = static_cast<std::uint32_t>(t);
      if (isNear(number)) found[part].push_back(number);
    }
  });
  std::vector<std::uint32_t> near;
  for (const auto& part : found) near.insert(near.end(), part.begin(), part.end());
  return near;
}

/// Triangles that reach into one block are of one group.
void Surroundings::share(const TriMesh& mesh, const std::vector<std::uint32_t>& near,
                         const std::vector<Pair>& pairs) {
  DisjointSets sets(near.size());
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  for (std::uint32_t i = 0; i < near.size(); ++i) {
    blocks_.each(boxOf(cornersOf(mesh, near[i])),
                 [&](std::uint64_t key) { sets.join(first.try_emplace(key, i).first->second, i); });
  }
  std::vector<std::uint32_t> group_at(near.size(), kGone);
  const auto groupOf = [&](std::uint32_t i) -> Group& {
    std::uint32_t& number = group_at[sets.find(i)];
    if (number == kGone) {
      number = static_cast<std::uint32_t>(groups_.size());
      groups_.emplace_back();
    }
    return groups_[number];
  };
  for (std::uint32_t i = 0; i < near.size(); ++i) groupOf(i).triangles.push_back(near[i]);
  for (const Pair& pair : pairs) {
    const auto at = std::lower_bound(near.begin(), near.end(), pair[0]) - near.begin();
    groupOf(static_cast<std::uint32_t>(at)).pairs.push_back(pair);
  }
}

/// What is not in the mesh any more.
struct Lost {
  std::vector<std::uint32_t> triangles, vertices;

  void add(const Lost& other) {
    triangles.insert(triangles.end(), other.triangles.begin(), other.triangles.end());
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  }
};

/// Changes the triangles of one group.
class Mender {
 public:
  /// `seen`: one a triangle, 0; shared by the menders of all groups.
  Mender(TriMesh& mesh, double cell_mm, const Surroundings& around, const Surroundings::Group& group,
         std::vector<std::uint32_t>& seen, std::size_t most_trials);

  /// Returns the number of pairs that are left.
  std::size_t run();
  const Lost& lost() const { return lost_; }

 private:
  using Star = std::vector<std::uint32_t>;
  struct Undo {
    std::vector<std::pair<std::uint32_t, Triangle>> triangles;
    std::vector<std::pair<std::uint32_t, Star>> stars;
    std::uint32_t moved = kGone;
    Eigen::Vector3f from = Eigen::Vector3f::Zero();
  };

  struct Choice {
    Edit edit;
    std::size_t gain = 0;  ///< pairs fewer
    double moved = 0.0;    ///< between old and new surface
  };

  struct Near {
    std::uint32_t triangle = 0;
    Box3 box;
  };

  /// What was found out, and where: as long as no triangle in there changes it holds.
  template <typename T>
  struct Found {
    Box3 box;
    T what;
  };

  Points points(std::uint32_t t) const { return cornersOf(mesh_, t); }
  bool gone(std::uint32_t t) const { return mesh_.triangles[t][0] == kGone; }
  bool whole(std::uint32_t v) const { return around_.whole(mesh_.positions[v].cast<double>()); }
  void insert(std::uint32_t t);
  void findNear(const std::vector<std::uint32_t>& triangles);
  std::size_t findPairs(const std::vector<std::uint32_t>& triangles, std::size_t most,
                        std::vector<Pair>* found = nullptr);
  const std::vector<Pair>& pairsBefore(const Edit& edit, const std::vector<std::uint32_t>& triangles);

  std::vector<std::uint32_t> affected(const Edit& edit) const;
  bool allowed(const Edit& edit) const;
  void apply(const Edit& edit, const std::vector<std::uint32_t>& triangles, Undo& undo);
  void undo(const Undo& undo);
  double apart(const std::vector<Points>& from, const std::vector<Points>& to, double limit) const;
  Box3 boxOfStar(std::uint32_t v) const;
  Box3 boxOfEdits(std::uint32_t a) const;
  std::vector<Edit> editsAt(std::uint32_t a, bool moves) const;
  std::optional<Choice> tryEdit(const Edit& edit);
  const std::vector<Choice>& choicesAt(std::uint32_t a, bool moves);
  bool meets(const Pair& pair) const;
  bool mend(const Pair& pair, double reach);
  std::vector<Pair> pairsLeft();

  TriMesh& mesh_;
  double cell_;
  const Surroundings& around_;
  const Surroundings::Group& group_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> blocks_;
  std::unordered_map<std::uint32_t, Star> stars_;
  std::vector<std::uint32_t>& seen_;  ///< number of the last search that met a triangle
  std::uint32_t search_ = 0;
  std::vector<Near> near_;
  std::unordered_map<std::uint32_t, Found<std::vector<Pair>>>
      pairs_at_;  ///< of the triangles at a vertex, as they are
  std::vector<Pair> turned_pairs_;
  /// Changes at a vertex that help, at any reach, and whether vertices are moved: as all is now.
  std::map<std::pair<std::uint32_t, bool>, Found<std::vector<Choice>>> choices_;
  Lost lost_;
  std::size_t trials_ = 0, most_trials_;
};

Mender::Mender(TriMesh& mesh, double cell_mm, const Surroundings& around, const Surroundings::Group& group,
               std::vector<std::uint32_t>& seen, std::size_t most_trials)
    : mesh_(mesh), cell_(cell_mm), around_(around), group_(group), seen_(seen), most_trials_(most_trials) {
  for (const std::uint32_t t : group.triangles) {
    insert(t);
    for (const std::uint32_t v : mesh_.triangles[t]) stars_[v].push_back(t);
  }
}

void Mender::insert(std::uint32_t t) {
  around_.blocks().each(boxOf(points(t)), [&](std::uint64_t key) {
    auto& list = blocks_[key];
    if (list.empty() || list.back() != t) list.push_back(t);
  });
}

/// Sets near_ to the triangles that are near these and not among them.
void Mender::findNear(const std::vector<std::uint32_t>& triangles) {
  near_.clear();
  ++search_;
  Box3 box;
  for (const std::uint32_t t : triangles) {
    seen_[t] = search_;
    if (gone(t)) continue;
    box.extend(boxOf(points(t)));
  }
  if (box.empty()) return;
  box = box.inflated(kReaches.back() * cell_);
  around_.blocks().each(box, [&](std::uint64_t key) {
    const auto found = blocks_.find(key);
    if (found == blocks_.end()) return;
    for (const std::uint32_t u : found->second) {
      if (seen_[u] == search_ || gone(u)) continue;
      seen_[u] = search_;
      const Near near{u, boxOf(points(u))};
      if (near.box.overlaps(box)) near_.push_back(near);
    }
  });
}

/// The number of pairs with one of these triangles, as far as to the first beyond `most`.
std::size_t Mender::findPairs(const std::vector<std::uint32_t>& triangles, std::size_t most,
                              std::vector<Pair>* found) {
  findNear(triangles);
  std::size_t count = 0;
  const auto look = [&](std::uint32_t t, std::uint32_t u) {
    const Pair pair{std::min(t, u), std::max(t, u)};
    if (!meets(pair)) return;
    ++count;
    if (found != nullptr) found->push_back(pair);
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t t = triangles[i];
    if (gone(t)) continue;
    const Box3 box = boxOf(points(t));
    for (std::size_t j = 0; j <= i && count <= most; ++j) look(t, triangles[j]);
    for (std::size_t j = 0; j < near_.size() && count <= most; ++j) {
      if (near_[j].box.overlaps(box)) look(t, near_[j].triangle);
    }
  }
  return count;
}

/// Pairs with one of the triangles that the edit changes. Many edits change the same ones.
const std::vector<Pair>& Mender::pairsBefore(const Edit& edit, const std::vector<std::uint32_t>& triangles) {
  const bool star = edit.kind != Edit::kTurn;
  if (star) {
    if (const auto known = pairs_at_.find(edit.a); known != pairs_at_.end()) return known->second.what;
  }
  if (star) pairs_at_[edit.a].box = boxOfStar(edit.a).inflated(kReaches.back() * cell_);
  std::vector<Pair>& pairs = star ? pairs_at_[edit.a].what : turned_pairs_;
  pairs.clear();
  findPairs(triangles, kAll, &pairs);
  return pairs;
}

std::vector<std::uint32_t> Mender::affected(const Edit& edit) const {
  const Star& star = stars_.at(edit.a);
  if (edit.kind != Edit::kTurn) return star;
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : star) {
    const Triangle& v = mesh_.triangles[t];
    if (std::find(v.begin(), v.end(), edit.b) != v.end()) out.push_back(t);
  }
  return out;
}

/// The corner after `v`, or the one after that.
std::uint32_t following(const Triangle& t, std::uint32_t v, int steps) {
  const auto at = static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
  return t[(at + static_cast<std::size_t>(steps)) % 3];
}

/// Whether the mesh stays a closed 2-manifold.
bool Mender::allowed(const Edit& edit) const {
  if (edit.kind == Edit::kMove) return true;
  const auto ringOf = [&](std::uint32_t v) {
    std::vector<std::uint32_t> ring;
    for (const std::uint32_t t : stars_.at(v)) ring.push_back(following(mesh_.triangles[t], v, 1));
    std::sort(ring.begin(), ring.end());
    return ring;
  };
  if (edit.kind == Edit::kTurn) {
    const std::vector<std::uint32_t> pair = affected(edit);
    if (pair.size() != 2 || stars_.at(edit.a).size() < 4 || stars_.at(edit.b).size() < 4) return false;
    std::array<std::uint32_t, 2> ends{};
    for (int i = 0; i < 2; ++i) {
      for (const std::uint32_t v : mesh_.triangles[pair[i]]) {
        if (v != edit.a && v != edit.b) ends[i] = v;
      }
    }
    if (ends[0] == ends[1] || !whole(ends[0]) || !whole(ends[1])) return false;
    const auto ring = ringOf(ends[0]);
    return !std::binary_search(ring.begin(), ring.end(), ends[1]);
  }
  const auto a = ringOf(edit.a), b = ringOf(edit.b);
  std::vector<std::uint32_t> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  if (common.size() != 2 || a.size() + b.size() < 8) return false;
  return std::all_of(common.begin(), common.end(),
                     [&](std::uint32_t v) { return whole(v) && stars_.at(v).size() > 3; });
}

void Mender::apply(const Edit& edit, const std::vector<std::uint32_t>& triangles, Undo& undo) {
  if (edit.kind == Edit::kMove) {
    undo.moved = edit.a;
    undo.from = mesh_.positions[edit.a];
    mesh_.positions[edit.a] = edit.to;
    return;
  }
  for (const std::uint32_t t : triangles) {
    undo.triangles.push_back({t, mesh_.triangles[t]});
    for (const std::uint32_t v : mesh_.triangles[t]) {
      if (std::none_of(undo.stars.begin(), undo.stars.end(), [&](const auto& s) { return s.first == v; }))
        undo.stars.push_back({v, stars_.at(v)});
      std::erase(stars_.at(v), t);
    }
  }
  if (edit.kind == Edit::kTurn) {
    std::uint32_t first = triangles[0], second = triangles[1];
    if (following(mesh_.triangles[first], edit.a, 1) != edit.b) std::swap(first, second);
    const std::uint32_t c = following(mesh_.triangles[first], edit.a, 2);
    const std::uint32_t d = following(mesh_.triangles[second], edit.a, 1);
    mesh_.triangles[first] = {edit.a, d, c};
    mesh_.triangles[second] = {d, edit.b, c};
  } else {
    for (const std::uint32_t t : triangles) {
      Triangle& v = mesh_.triangles[t];
      if (std::find(v.begin(), v.end(), edit.b) != v.end()) {
        v.fill(kGone);
      } else {
        *std::find(v.begin(), v.end(), edit.a) = edit.b;
      }
    }
  }
  for (const std::uint32_t t : triangles) {
    if (gone(t)) continue;
    for (const std::uint32_t v : mesh_.triangles[t]) {
      Star& star = stars_.at(v);
      if (std::none_of(undo.stars.begin(), undo.stars.end(), [&](const auto& s) { return s.first == v; }))
        undo.stars.push_back({v, star});
      star.push_back(t);
    }
  }
}

void Mender::undo(const Undo& undo) {
  if (undo.moved != kGone) mesh_.positions[undo.moved] = undo.from;
  for (const auto& [t, triangle] : undo.triangles) mesh_.triangles[t] = triangle;
  for (const auto& [v, star] : undo.stars) stars_.at(v) = star;
}

/// How far the triangles `from` get away from `to` and from what is near, by samples; infinite beyond
/// `limit`.
double Mender::apart(const std::vector<Points>& from, const std::vector<Points>& to, double limit) const {
  double farthest = 0.0;
  const auto look = [&](const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Points& t : to) least = std::min(least, squaredDistance(p, t));
    if (least <= farthest) return true;
    for (const Near& near : near_) {
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
  for (const std::uint32_t t : stars_.at(v)) box.extend(boxOf(points(t)));
  return box;
}

/// Where changes at a vertex change triangles or look at some: around its neighbours, and as far beyond as it
/// is shifted.
Box3 Mender::boxOfEdits(std::uint32_t a) const {
  Box3 box;
  for (const std::uint32_t t : stars_.at(a)) {
    for (const std::uint32_t v : mesh_.triangles[t]) box.extend(boxOfStar(v));
  }
  return box.inflated(kReaches.back() * cell_ + kMostBack * box.size().maxCoeff());
}

std::vector<Edit> Mender::editsAt(std::uint32_t a, bool moves) const {
  std::vector<Edit> edits;
  const Star& star = stars_.at(a);
  const Eigen::Vector3f& from = mesh_.positions[a];
  const auto move = [&](const Eigen::Vector3f& way, float part) {
    edits.push_back({Edit::kMove, a, a, from + part * (way - from)});
  };
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const std::uint32_t t : star) {
    const std::uint32_t b = following(mesh_.triangles[t], a, 1);
    middle += mesh_.positions[b] / static_cast<float>(star.size());
    if (moves) {
      for (const float part : {0.05f, 0.2f, 0.5f, -0.05f, -kMostBack}) move(mesh_.positions[b], part);
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
  const std::vector<std::uint32_t> triangles = affected(edit);
  const std::vector<Pair>& pairs = pairsBefore(edit, triangles);
  if (pairs.empty()) return std::nullopt;
  ++trials_;
  std::vector<Points> was, is;
  for (const std::uint32_t t : triangles) was.push_back(points(t));
  Undo back;
  apply(edit, triangles, back);
  // Most edits help nothing: the pairs that are known tell that at once.
  const std::size_t most = pairs.size() - 1;
  auto left = static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) { return meets(pair); }));
  if (left <= most) left = findPairs(triangles, most);
  std::optional<Choice> choice;
  if (left <= most) {
    const double reach = kReaches.back() * cell_;
    for (const std::uint32_t t : triangles) {
      if (!gone(t)) is.push_back(points(t));
    }
    double moved = apart(was, is, reach);
    if (moved <= reach) moved = std::max(moved, apart(is, was, reach));
    if (moved <= reach) choice = {edit, pairs.size() - left, moved};
  }
  undo(back);
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

/// Makes the best change for a pair that still meets; vertices are moved only where nothing else helps. False
/// if there is none.
bool Mender::mend(const Pair& pair, double reach) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : pair) {
    for (const std::uint32_t v : mesh_.triangles[t]) {
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
  if (best.gain == 0) return false;
  const std::vector<std::uint32_t> triangles = affected(best.edit);
  Box3 changed;
  for (const std::uint32_t t : triangles) changed.extend(boxOf(points(t)));
  Undo none;
  apply(best.edit, triangles, none);
  for (const std::uint32_t t : triangles) {
    if (!gone(t)) changed.extend(boxOf(points(t)));
  }
  std::erase_if(pairs_at_, [&](const auto& found) { return found.second.box.overlaps(changed); });
  std::erase_if(choices_, [&](const auto& found) { return found.second.box.overlaps(changed); });
  for (const std::uint32_t t : triangles) {
    if (gone(t)) {
      lost_.triangles.push_back(t);
    } else {
      insert(t);
    }
  }
  if (best.edit.kind == Edit::kJoin) lost_.vertices.push_back(best.edit.a);
  return true;
}

bool Mender::meets(const Pair& pair) const {
  if (gone(pair[0]) || gone(pair[1])) return false;
  return pair[0] == pair[1] ? isNeedle(mesh_, pair[0]) : trianglesMeet(mesh_, pair[0], pair[1]);
}

std::vector<Pair> Mender::pairsLeft() {
  std::vector<Pair> out;
  for (const std::uint32_t t : group_.triangles) {
    if (gone(t)) continue;
    if (isNeedle(mesh_, t)) out.push_back({t, t});
    findNear({t});
    for (const Near& near : near_) {
      if (near.triangle > t && trianglesMeet(mesh_, t, near.triangle)) out.push_back({t, near.triangle});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::size_t Mender::run() {
  std::vector<Pair> pairs = group_.pairs;
  for (const double reach : kReaches) {
    for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
      bool any = false;
      for (const Pair& pair : pairs) {
        while (meets(pair) && mend(pair, reach * cell_)) any = true;
      }
      if (!any) break;
      pairs = pairsLeft();
    }
  }
  return pairs.size();
}

/// Takes the elements with these ascending numbers out.
template <typename T>
void eraseAt(std::vector<T>& all, const std::vector<std::uint32_t>& gone) {
  if (gone.empty()) return;
  auto to = all.begin() + gone.front();
  for (std::size_t i = 0; i < gone.size(); ++i) {
    const auto last = i + 1 < gone.size() ? all.begin() + gone[i + 1] : all.end();
    to = std::move(all.begin() + gone[i] + 1, last, to);
  }
  all.erase(to, all.end());
}

/// Takes few triangles and vertices out of many, and numbers the vertices anew.
void takeOut(TriMesh& mesh, Lost lost) {
  std::sort(lost.triangles.begin(), lost.triangles.end());
  std::sort(lost.vertices.begin(), lost.vertices.end());
  eraseAt(mesh.triangles, lost.triangles);
  eraseAt(mesh.motion, lost.triangles);
  eraseAt(mesh.positions, lost.vertices);
  if (lost.vertices.empty()) return;
  parallelFor(std::size_t{0}, mesh.triangles.size() / kPart + 1, [&](std::size_t part) {
    for (std::size_t t = part * kPart; t < std::min(mesh.triangles.size(), (part + 1) * kPart); ++t) {
      for (std::uint32_t& v : mesh.triangles[t]) {
        if (v < lost.vertices.front()) continue;
        const auto below = std::lower_bound(lost.vertices.begin(), lost.vertices.end(), v);
        v -= static_cast<std::uint32_t>(below - lost.vertices.begin());
      }
    }
  });
}

}  // namespace

std::size_t mendIntersections(TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                              double cell_mm) {
  if (pairs.empty()) return 0;
  const Surroundings around(mesh, cell_mm, pairs);
  const auto& groups = around.groups();
  std::vector<std::uint32_t> seen(mesh.triangles.size(), 0);
  std::vector<std::size_t> left(groups.size());
  std::vector<Lost> lost(groups.size());
  parallelFor(std::size_t{0}, groups.size(), [&](std::size_t i) {
    const std::size_t most_trials =
        std::max(kGroupTrials, kMostTrials * groups[i].pairs.size() / pairs.size());
    Mender mender(mesh, cell_mm, around, groups[i], seen, most_trials);
    left[i] = mender.run();
    lost[i] = mender.lost();
  });
  Lost all;
  for (const Lost& part : lost) all.add(part);
  takeOut(mesh, std::move(all));
  return std::accumulate(left.begin(), left.end(), std::size_t{0});
}

}  // namespace proveout
