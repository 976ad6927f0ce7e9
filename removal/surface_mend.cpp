#include "removal/surface_mend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "removal/surface_intersections.h"

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
/// Slots of the filter of blocks, as a power of two.
constexpr int kFilterBits = 16;
/// Rounds over all pairs; each that changes something leaves fewer of them.
constexpr int kRounds = 8;
/// Changes that are tried at most, about two seconds: what then is left is a surface that they cannot mend.
constexpr std::size_t kMostTrials = 100000;
constexpr std::uint32_t kGone = 0xFFFFFFFFu;

double distance2(const Vec3& p, const Points& t) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  const auto toEdge = [&](const Vec3& a, const Vec3& e) {
    const double length2 = e.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p - a).dot(e) / length2, 0.0, 1.0) : 0.0;
    return (p - a - s * e).squaredNorm();
  };
  const double aa = ab.squaredNorm(), bb = ac.squaredNorm(), c = ab.dot(ac), det = aa * bb - c * c;
  if (det > 1e-14 * aa * bb) {
    const double u = bb * d1 - c * d2, v = aa * d2 - c * d1;
    if (u >= 0.0 && v >= 0.0 && u + v <= det) {
      const Vec3 n = ab.cross(ac);
      const double up = n.dot(ap);
      return up * up / n.squaredNorm();
    }
  }
  return std::min({toEdge(t[0], ab), toEdge(t[0], ac), toEdge(t[1], t[2] - t[1])});
}

Vec3 lowOf(const Points& p) { return p[0].cwiseMin(p[1]).cwiseMin(p[2]); }
Vec3 highOf(const Points& p) { return p[0].cwiseMax(p[1]).cwiseMax(p[2]); }

struct Edit {
  enum Kind { kTurn, kJoin, kMove };
  Kind kind = kMove;
  std::uint32_t a = 0, b = 0;                    ///< the edge; kJoin: a becomes b; kMove: a alone
  Eigen::Vector3f to = Eigen::Vector3f::Zero();  ///< of kMove
};

class Mender {
 public:
  Mender(TriMesh& mesh, double cell_mm)
      : mesh_(mesh), cell_(cell_mm), scale_(1.0 / (kBlockCells * cell_mm)) {}

  std::size_t run(std::vector<Pair> pairs);

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
    std::ptrdiff_t gain = 0;  ///< pairs fewer
    double moved = 0.0;       ///< between old and new surface
  };

  Vec3i blockOf(const Vec3& p) const { return (p * scale_).array().floor().cast<int>().matrix(); }
  static std::uint64_t keyOf(const Vec3i& block) {
    const auto part = [](int i) { return static_cast<std::uint64_t>(i) & 0x1FFFFF; };
    return part(block.x()) << 42 | part(block.y()) << 21 | part(block.z());
  }
  template <typename Body>
  void eachBlock(const Vec3& low, const Vec3& high, Body&& body) const;
  Points points(const Triangle& t) const {
    return {mesh_.positions[t[0]].cast<double>(), mesh_.positions[t[1]].cast<double>(),
            mesh_.positions[t[2]].cast<double>()};
  }
  Points points(std::uint32_t t) const { return points(mesh_.triangles[t]); }
  bool gone(std::uint32_t t) const { return mesh_.triangles[t][0] == kGone; }
  bool whole(std::uint32_t v) const;
  void gather(const std::vector<Pair>& pairs);
  void insert(std::uint32_t t);
  void findNear(const std::vector<std::uint32_t>& triangles);
  std::size_t countPairs(const std::vector<std::uint32_t>& triangles);

  std::vector<std::uint32_t> affected(const Edit& edit) const;
  bool allowed(const Edit& edit) const;
  void apply(const Edit& edit, const std::vector<std::uint32_t>& triangles, Undo& undo);
  void undo(const Undo& undo);
  double apart(const std::vector<Points>& from, const std::vector<Points>& to, double limit) const;
  std::vector<Edit> editsFor(const Pair& pair, bool moves) const;
  void tryEdit(const Edit& edit, double reach, Choice& best);
  bool meets(const Pair& pair) const;
  bool mend(const Pair& pair, double reach);
  std::vector<Pair> pairsLeft();
  void compact();

  TriMesh& mesh_;
  double cell_, scale_;
  std::vector<std::uint32_t> local_;  ///< triangles around the pairs
  std::unordered_map<std::uint64_t, bool> marked_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> blocks_;
  std::unordered_map<std::uint32_t, Star> stars_;
  std::vector<std::uint32_t> seen_;  ///< number of the last search that met a triangle
  std::uint32_t search_ = 0;
  std::vector<std::uint32_t> near_;
  std::size_t trials_ = 0;
};

template <typename Body>
void Mender::eachBlock(const Vec3& low, const Vec3& high, Body&& body) const {
  const Vec3i from = blockOf(low), to = blockOf(high);
  for (int x = from.x(); x <= to.x(); ++x) {
    for (int y = from.y(); y <= to.y(); ++y) {
      for (int z = from.z(); z <= to.z(); ++z) body(Vec3i(x, y, z));
    }
  }
}

/// Whether all triangles at the vertex are known.
bool Mender::whole(std::uint32_t v) const {
  return marked_.contains(keyOf(blockOf(mesh_.positions[v].cast<double>())));
}

void Mender::insert(std::uint32_t t) {
  const Points p = points(t);
  eachBlock(lowOf(p), highOf(p), [&](const Vec3i& block) {
    auto& list = blocks_[keyOf(block)];
    if (list.empty() || list.back() != t) list.push_back(t);
  });
}

void Mender::gather(const std::vector<Pair>& pairs) {
  const Vec3 margin = Vec3::Constant(kMarginCells * cell_);
  std::vector<std::uint8_t> maybe(std::size_t{1} << kFilterBits, 0);  // most triangles are nowhere near
  const auto slot = [](const Vec3i& block) {
    return keyOf(block) * 0x9E3779B97F4A7C15ull >> (64 - kFilterBits);
  };
  for (const Pair& pair : pairs) {
    for (const std::uint32_t t : pair) {
      const Points p = points(t);
      eachBlock(lowOf(p) - margin, highOf(p) + margin, [&](const Vec3i& block) {
        marked_.emplace(keyOf(block), true);
        maybe[slot(block)] = 1;
      });
    }
  }
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Points p = points(t);
    bool inside = false;
    eachBlock(lowOf(p), highOf(p), [&](const Vec3i& block) {
      inside = inside || (maybe[slot(block)] != 0 && marked_.contains(keyOf(block)));
    });
    if (!inside) continue;
    local_.push_back(t);
    insert(t);
    for (const std::uint32_t v : mesh_.triangles[t]) stars_[v].push_back(t);
  }
  seen_.assign(mesh_.triangles.size(), 0);
}

/// Sets near_ to the triangles that are near these and not among them.
void Mender::findNear(const std::vector<std::uint32_t>& triangles) {
  near_.clear();
  ++search_;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const std::uint32_t t : triangles) {
    seen_[t] = search_;
    if (gone(t)) continue;
    for (const Vec3& p : points(t)) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  if (!(low.x() <= high.x())) return;
  low.array() -= kReaches.back() * cell_;
  high.array() += kReaches.back() * cell_;
  eachBlock(low, high, [&](const Vec3i& block) {
    const auto found = blocks_.find(keyOf(block));
    if (found == blocks_.end()) return;
    for (const std::uint32_t u : found->second) {
      if (seen_[u] == search_ || gone(u)) continue;
      seen_[u] = search_;
      const Points p = points(u);
      if ((lowOf(p).array() <= high.array()).all() && (highOf(p).array() >= low.array()).all())
        near_.push_back(u);
    }
  });
}

/// Pairs with one of these triangles.
std::size_t Mender::countPairs(const std::vector<std::uint32_t>& triangles) {
  findNear(triangles);
  std::size_t count = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t t = triangles[i];
    if (gone(t)) continue;
    count += isNeedle(mesh_, t);
    for (const std::uint32_t u : near_) count += trianglesMeet(mesh_, std::min(t, u), std::max(t, u));
    for (std::size_t j = 0; j < i; ++j) {
      const std::uint32_t u = triangles[j];
      if (!gone(u)) count += trianglesMeet(mesh_, std::min(t, u), std::max(t, u));
    }
  }
  return count;
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
    std::array<std::uint32_t, 2> ends;
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
    for (const Points& t : to) least = std::min(least, distance2(p, t));
    if (least <= farthest) return true;
    for (const std::uint32_t t : near_) {
      if (!gone(t)) least = std::min(least, distance2(p, points(t)));
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

std::vector<Edit> Mender::editsFor(const Pair& pair, bool moves) const {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : pair) {
    for (const std::uint32_t v : mesh_.triangles[t]) {
      if (whole(v) && std::find(vertices.begin(), vertices.end(), v) == vertices.end()) vertices.push_back(v);
    }
  }
  std::vector<Edit> edits;
  for (const std::uint32_t a : vertices) {
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
        for (const float part : {0.05f, 0.2f, 0.5f, -0.05f, -0.2f}) move(mesh_.positions[b], part);
      } else if (whole(b)) {
        edits.push_back({Edit::kTurn, a, b});
        edits.push_back({Edit::kJoin, a, b});
        edits.push_back({Edit::kJoin, b, a});
      }
    }
    if (!moves) continue;
    for (const float part : {0.1f, 0.5f, 1.0f}) move(middle, part);
  }
  return edits;
}

/// Tries a change and takes it back. Replaces `best` if it leaves fewer pairs, or as few and moves less.
void Mender::tryEdit(const Edit& edit, double reach, Choice& best) {
  if (!allowed(edit)) return;
  const std::vector<std::uint32_t> triangles = affected(edit);
  const auto before = static_cast<std::ptrdiff_t>(countPairs(triangles));
  if (before < std::max<std::ptrdiff_t>(1, best.gain)) return;
  ++trials_;
  std::vector<Points> was, is;
  for (const std::uint32_t t : triangles) was.push_back(points(t));
  Undo back;
  apply(edit, triangles, back);
  const auto gain = before - static_cast<std::ptrdiff_t>(countPairs(triangles));
  if (gain > 0 && gain >= best.gain) {
    for (const std::uint32_t t : triangles) {
      if (!gone(t)) is.push_back(points(t));
    }
    const double moved = std::max(apart(was, is, reach), apart(is, was, reach));
    if (moved <= reach && (gain > best.gain || moved < best.moved)) best = {edit, gain, moved};
  }
  undo(back);
}

/// Makes the best change for a pair that still meets; vertices are moved only where nothing else helps. False
/// if there is none.
bool Mender::mend(const Pair& pair, double reach) {
  Choice best;
  for (const bool moves : {false, true}) {
    if (best.gain > 0 || trials_ > kMostTrials) break;
    for (const Edit& edit : editsFor(pair, moves)) tryEdit(edit, reach, best);
  }
  if (best.gain == 0) return false;
  const std::vector<std::uint32_t> triangles = affected(best.edit);
  Undo none;
  apply(best.edit, triangles, none);
  for (const std::uint32_t t : triangles) {
    if (!gone(t)) insert(t);
  }
  return true;
}

bool Mender::meets(const Pair& pair) const {
  if (gone(pair[0]) || gone(pair[1])) return false;
  return pair[0] == pair[1] ? isNeedle(mesh_, pair[0]) : trianglesMeet(mesh_, pair[0], pair[1]);
}

std::vector<Pair> Mender::pairsLeft() {
  std::vector<Pair> out;
  for (const std::uint32_t t : local_) {
    if (gone(t)) continue;
    if (isNeedle(mesh_, t)) out.push_back({t, t});
    findNear({t});
    for (const std::uint32_t u : near_) {
      if (u > t && trianglesMeet(mesh_, t, u)) out.push_back({t, u});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Leaves out what is gone.
void Mender::compact() {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (gone(static_cast<std::uint32_t>(t))) continue;
    mesh_.motion[kept] = mesh_.motion[t];
    mesh_.triangles[kept++] = mesh_.triangles[t];
  }
  if (kept == mesh_.triangles.size()) return;
  mesh_.triangles.resize(kept);
  mesh_.motion.resize(kept);
  std::vector<std::uint32_t> number(mesh_.positions.size(), kGone);
  for (const Triangle& t : mesh_.triangles) {
    for (const std::uint32_t v : t) number[v] = 0;
  }
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kGone) continue;
    mesh_.positions[next] = mesh_.positions[v];
    number[v] = next++;
  }
  mesh_.positions.resize(next);
  for (Triangle& t : mesh_.triangles) {
    for (std::uint32_t& v : t) v = number[v];
  }
}

std::size_t Mender::run(std::vector<Pair> pairs) {
  gather(pairs);
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
  compact();
  return pairs.size();
}

}  // namespace

std::size_t mendIntersections(TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                              double cell_mm) {
  return Mender(mesh, cell_mm).run(pairs);
}

}  // namespace proveout
