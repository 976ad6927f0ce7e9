// Half-edges are collapsed, each only if the distance to the mesh as it was stays within the tolerance. Every
// triangle carries a bound of it: going from the surface before a collapse to that after it moves no point by
// more than VertexStar::join tells, so that the sum of what it was moved by bounds the distance both ways.
// (Bounds added up along a chain of maps: J. Cohen, D. Manocha, M. Olano, "Simplifying polygonal models using
// successive mappings", 1997.)
//
// Blocks of space are worked on side by side; a collapse needs all of its surroundings in one block. Larger
// blocks follow, and in the end all of it at once, for what lay on the borders of blocks.
#include "core/mesh/edge_collapser.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/base/stretches.h"
#include "core/geometry/to_float.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mean_edge.h"

namespace proveout {
namespace {

constexpr std::uint32_t kNoBlock = CornerTable::kNone;
constexpr float kNotAgain = std::numeric_limits<float>::infinity();
/// Edges of the blocks of a round, in edges of triangles; 0: all is one block.
constexpr double kBlocks[] = {64.0, 256.0, 0.0};
/// Limits of the passes, as parts of the tolerance: what costs little goes first.
constexpr double kPasses[] = {0.1, 0.3, 1.0};
/// Neighbours lie nearly flat on each other: the cosine between their normals.
constexpr float kFolded = -0.8f;

/// Numbers from 0 for what is kept of a list, in its order.
class Numbering {
 public:
  template <typename Kept>
  Numbering(std::size_t size, const Kept& kept) : size_(size), first_(size / kPart + 2, 0) {
    parallelFor(std::size_t{0}, first_.size() - 1, [&](std::size_t part) {
      std::size_t count = 0;
      for (std::size_t i = part * kPart; i < endOf(part); ++i) count += kept(i);
      first_[part + 1] = count;
    });
    for (std::size_t part = 1; part < first_.size(); ++part) first_[part] += first_[part - 1];
  }
  std::size_t count() const { return first_.back(); }
  /// Calls body(i, n) for what is kept; n: its number.
  template <typename Kept, typename Body>
  void forEach(const Kept& kept, const Body& body) const {
    parallelFor(std::size_t{0}, first_.size() - 1, [&](std::size_t part) {
      std::size_t next = first_[part];
      for (std::size_t i = part * kPart; i < endOf(part); ++i) {
        if (kept(i)) body(i, next++);
      }
    });
  }

 private:
  static constexpr std::size_t kPart = 4096;
  std::size_t endOf(std::size_t part) const { return std::min(size_, (part + 1) * kPart); }

  std::size_t size_;
  std::vector<std::size_t> first_;  ///< number of each part, and the count of all
};

float largestCoordinate(const TriMesh& mesh) {
  Eigen::Array3f most = Eigen::Array3f::Zero();
  for (const auto& p : mesh.positions) most = most.max(p.array().abs());
  return most.maxCoeff();
}

}  // namespace

EdgeCollapser::EdgeCollapser(const TriMesh& mesh, double tolerance, std::span<const std::uint8_t> frozen,
                             std::span<const float> off)
    : mesh_(mesh),
      tolerance_(tolerance),
      table_(mesh.triangles, mesh.motion, mesh.positions.size()),
      triangles_(std::make_unique_for_overwrite<TriangleState[]>(mesh.triangles.size())),
      vertices_(mesh.positions.size()),
      around_{table_, mesh.positions, {triangles_.get(), mesh.triangles.size()}} {
  // So many units in the last place of the coordinates: less high triangles could be turned over by rounding.
  constexpr double kLeastUnits = 64.0;
  PROVEOUT_ASSERT(frozen.empty() || frozen.size() == mesh.positions.size());
  PROVEOUT_ASSERT(off.empty() || off.size() == mesh.positions.size());
  around_.least_height = kLeastUnits * std::numeric_limits<float>::epsilon() * largestCoordinate(mesh);
  findNormals(off);
  holdFolds();
  movable_.reserve(vertices_.size());
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    if (!frozen.empty() && frozen[v] != 0) vertices_[v].freedom = Freedom::kNone;
    if (vertices_[v].freedom != Freedom::kNone && !table_.gone(v)) movable_.push_back(v);
  }
}

void EdgeCollapser::findNormals(std::span<const float> off) {
  // Single precision leaves so much of the normal of a triangle of this shape right to some 1e-4.
  constexpr float kThin = 1e-3f;
  forEachBelow(table_.triangleCount(), [&](std::size_t t) {
    const auto& v = mesh_.triangles[t];
    triangles_[t].error = off.empty() ? 0.0f : std::max({off[v[0]], off[v[1]], off[v[2]]});
    const Eigen::Vector3f p = mesh_.positions[v[1]] - mesh_.positions[v[0]];
    const Eigen::Vector3f q = mesh_.positions[v[2]] - mesh_.positions[v[0]];
    const Eigen::Vector3f area = p.cross(q);
    const float twice2 = area.squaredNorm();
    if (twice2 > kThin * kThin * p.squaredNorm() * q.squaredNorm()) {
      triangles_[t].normal = area / std::sqrt(twice2);
    } else {
      triangles_[t].normal = toFloat(p.cast<double>().cross(q.cast<double>()).normalized());
    }
  });
}

/// Whether a triangle lies nearly flat on one beside it.
bool EdgeCollapser::isFolded(std::uint32_t t) const {
  const Eigen::Vector3f& normal = triangles_[t].normal;
  float least = 1.0f;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto& beyond =
        triangles_[CornerTable::triangleOf(table_.turned(CornerTable::halfEdge(t, i)))].normal;
    least = std::min(least, normal.dot(beyond));
  }
  return least < kFolded;
}

/// Around what is folded already nothing is taken away: the layers may be as near to each other as can be.
void EdgeCollapser::holdFolds() {
  constexpr std::size_t kPart = 4096;
  const std::size_t count = table_.triangleCount();
  std::vector<std::vector<std::uint32_t>> folded(count / kPart + 1);
  parallelFor(std::size_t{0}, folded.size(), [&](std::size_t part) {
    for (std::size_t t = part * kPart; t < std::min(count, (part + 1) * kPart); ++t) {
      if (isFolded(static_cast<std::uint32_t>(t))) folded[part].push_back(static_cast<std::uint32_t>(t));
    }
  });
  const auto holdAround = [&](std::uint32_t first) {
    std::uint32_t h = first;
    do {
      vertices_[table_.from(h)].freedom = vertices_[table_.to(h)].freedom = Freedom::kNone;
      h = table_.turned(h);
    } while (h != first);
  };
  for (const auto& part : folded) {
    for (const std::uint32_t t : part) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t h = CornerTable::halfEdge(t, i), twin = table_.twin(h);
        const auto& beyond = triangles_[CornerTable::triangleOf(twin)].normal;
        if (triangles_[t].normal.dot(beyond) >= kFolded) continue;
        holdAround(h);
        holdAround(twin);
      }
    }
  }
}

bool EdgeCollapser::run(const Progress& progress) {
  const double edge = meanEdge(mesh_);
  std::uint32_t round = 0;
  for (const double size : kBlocks) {
    if (progress.cancelled()) return false;
    std::vector<Block> all = blocks(size * edge);
    parallelFor(std::size_t{0}, all.size(),
                [&](std::size_t block) { simplifyBlock(std::move(all[block]), round); });
    ++round;
  }
  return true;
}

/// A collapse within a block leads to no edges out of it: what is off its border now is so until the end.
void EdgeCollapser::findCells(double size) {
  // Makes all coordinates of cells positive, so that cutting off is rounding down.
  constexpr double kShift = 0.37 + (1 << 20);
  constexpr std::uint32_t kBits = 10, kMask = (1u << kBits) - 1;
  cells_.resize(size > 0.0 ? vertices_.size() : 0);
  const double each = 1.0 / size;
  forEachBelow(cells_.size(), [&](std::size_t v) {
    std::uint32_t number = 0;
    for (int k = 0; k < 3; ++k) {
      const auto cell = static_cast<std::int32_t>(mesh_.positions[v][k] * each + kShift);
      number = number << kBits | (static_cast<std::uint32_t>(cell) & kMask);
    }
    cells_[v] = number;
  });
}

/// The vertices that may go and are worth a look, by their blocks; in each round the borders of blocks are
/// elsewhere. Two blocks may have one number, and then are worked on by one thread.
std::vector<EdgeCollapser::Block> EdgeCollapser::blocks(double size) {
  findCells(size);
  const auto most = toFloat(tolerance_);
  std::vector<Block> out;
  std::unordered_map<std::uint32_t, std::size_t> number;
  std::uint32_t last = kNoBlock;
  std::size_t at = 0, left = 0;
  for (const std::uint32_t v : movable_) {
    VertexState& state = vertices_[v];
    if (table_.gone(v) || state.freedom == Freedom::kNone) continue;
    movable_[left++] = v;
    state.place = Place::kUnknown;
    state.kept = state.isWorth(most);
    if (!state.kept) continue;
    const std::uint32_t cell = cells_.empty() ? 0 : cells_[v];
    if (cell != last) at = number.try_emplace(last = cell, number.size()).first->second;
    if (at == out.size()) out.emplace_back();
    out[at].push_back(v);
  }
  movable_.resize(left);
  return out;
}

/// Sweeps over the vertices, and in each joins none beside another, so that triangles do not become long
/// where they could be round.
void EdgeCollapser::simplifyBlock(Block vertices, std::uint32_t round) {
  constexpr std::uint32_t kMostSweeps = 1u << 12;
  Sweeps sweeps;
  sweeps.sorted = vertices.size();
  sweeps.vertices = std::move(vertices);
  std::uint32_t last = round * kMostSweeps * static_cast<std::uint32_t>(std::size(kPasses));
  for (const double pass : kPasses) {
    sweeps.sweep = last;
    last += kMostSweeps;
    startPass(sweeps, pass);
    while (!sweeps.todo.empty() && sweeps.sweep + 1 < last) sweepBlock(sweeps);
  }
}

/// Lists what is worth a look with this part of the tolerance, in the order of the vertices' numbers.
void EdgeCollapser::startPass(Sweeps& sweeps, double part) {
  sweeps.limit = toFloat(part * tolerance_);
  const auto most = toFloat(tolerance_);
  if (sweeps.sorted < sweeps.vertices.size()) std::ranges::sort(sweeps.vertices);
  sweeps.todo.clear();
  std::size_t left = 0;
  for (const std::uint32_t v : sweeps.vertices) {
    VertexState& state = vertices_[v];
    state.kept = !table_.gone(v) && state.isWorth(most);
    if (!state.kept) continue;
    sweeps.vertices[left++] = v;
    state.listed = state.isWorth(sweeps.limit);
    if (state.listed) sweeps.todo.push_back(v);
  }
  sweeps.vertices.resize(left);
  sweeps.sorted = left;
}

/// Looks at the vertices, and leaves those that are worth to be looked at again.
void EdgeCollapser::sweepBlock(Sweeps& sweeps) {
  ++sweeps.sweep;
  sweeps.again.clear();
  for (const std::uint32_t v : sweeps.todo) {
    VertexState& state = vertices_[v];
    if (table_.gone(v)) continue;
    if (state.swept == sweeps.sweep) {
      sweeps.again.push_back(v);
      continue;
    }
    state.listed = false;
    if (state.isWorth(sweeps.limit)) tryVertex(v, sweeps);
  }
  std::swap(sweeps.todo, sweeps.again);
}

bool EdgeCollapser::isInside(const VertexStar& star, std::uint32_t v) const {
  if (cells_.empty()) return true;
  for (int j = 0; j < star.size(); ++j) {
    if (cells_[star.ring(j)] != cells_[v]) return false;
  }
  return true;
}

/// Whether the vertex is free and inside its block. How many borders of motions meet at a vertex never
/// changes: a vertex goes along borders only, and no motion at it goes with it.
bool EdgeCollapser::mayGo(const VertexStar& star, std::uint32_t v) {
  VertexState& state = vertices_[v];
  if (state.place == Place::kUnknown) state.place = isInside(star, v) ? Place::kInside : Place::kOutside;
  if (state.place == Place::kOutside) return false;
  if (state.freedom == Freedom::kUnknown) {
    state.freedom = star.borders() == 0   ? Freedom::kFree
                    : star.borders() == 2 ? Freedom::kBorder
                                          : Freedom::kNone;
  }
  return state.freedom != Freedom::kNone;
}

/// Joins a vertex with the first of its neighbours that does.
void EdgeCollapser::tryVertex(std::uint32_t v, Sweeps& sweeps) {
  VertexStar star;
  Ways ways;
  VertexState& state = vertices_[v];
  const float limit = sweeps.limit;
  const bool walked = star.walk(table_, v);
  if (walked && !mayGo(star, v)) return;
  state.needs = kNotAgain;
  if (!walked) return;
  if (state.freedom == Freedom::kBorder && !followBorder(star, v, limit, ways)) return;
  star.look(around_);
  if (!findWays(star, v, limit, ways) || !star.findView()) return;
  for (int i = 0; i < ways.count; ++i) {
    VertexStar::Change change;
    const int to = ways.to[i];
    if (!star.join(to, tolerance_, change)) continue;
    if (change.moved > limit) {
      state.needs = std::min(state.needs, change.moved);
    } else if (staysManifold(star, to) && !foldsOver(star, to, change)) {
      for (int k = 0; k < 2 && state.freedom == Freedom::kBorder; ++k) {
        float& drift = vertices_[star.ring(star.borderAt()[k])].drift;
        drift = std::max(drift, ways.drift);
      }
      state.needs = kNotAgain;
      collapse(star, to, change, sweeps);
      return;
    }
  }
}

/// How far the border moves. False: too far, or a motion would lose its last triangle.
bool EdgeCollapser::followBorder(const VertexStar& star, std::uint32_t v, float limit, Ways& ways) {
  const auto& [one, other] = star.borderAt();
  const int run = other - one;
  if (run < 2 || star.size() - run < 2) return false;
  vertices_[v].needs = 0.0f;
  const Eigen::Vector3f& at = mesh_.positions[v];
  const Vec3 p = (mesh_.positions[star.ring(one)] - at).cast<double>();
  const Vec3 along = (mesh_.positions[star.ring(other)] - at).cast<double>() - p;
  const double part = std::clamp(-p.dot(along) / along.squaredNorm(), 0.0, 1.0);
  ways.drift = vertices_[v].drift + toFloat((p + part * along).norm());
  vertices_[v].next_drift = ways.drift <= tolerance_ ? ways.drift : kNotAgain;
  if (ways.drift > limit) return false;
  vertices_[v].needs = kNotAgain;
  return true;
}

void EdgeCollapser::Ways::add(int j, double rank_of_it) {
  int i = std::min(count, kMostTries);
  if (i == kMostTries && rank_of_it >= rank[i - 1]) return;
  count = std::min(count + 1, kMostTries);
  for (i = count - 1; i > 0 && rank[i - 1] > rank_of_it; --i) {
    to[i] = to[i - 1];
    rank[i] = rank[i - 1];
  }
  to[i] = j;
  rank[i] = rank_of_it;
}

/// False: there are none, and the vertex needs what may give one.
bool EdgeCollapser::findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways) {
  // Neighbours so much farther from the planes than the surface may move are not worth to be looked at: the
  // sum of the squared distances is so many times the squared limit. The nearest one is better by this part
  // of the tolerance than the farthest.
  constexpr double kFarOff2 = 6.0, kNear = 0.05;
  VertexState& state = vertices_[v];
  double longest2 = 0.0;
  for (int j = 0; j < star.size(); ++j) longest2 = std::max(longest2, star.arm(j).squaredNorm());
  const double most = kFarOff2 * limit * limit, near = kFarOff2 * std::pow(kNear * tolerance_, 2) / longest2;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](int j) {
    const double off2 = star.offPlanes2(j);
    if (off2 <= most) {
      ways.add(j, off2 + near * star.arm(j).squaredNorm());
    } else {
      least = std::min(least, off2);
    }
  };
  if (state.freedom == Freedom::kBorder) {
    for (const int j : star.borderAt()) look(j);
  } else {
    for (int j = 0; j < star.size(); ++j) look(j);
  }
  if (least <= kFarOff2 * tolerance_ * tolerance_)
    state.needs = std::min(state.needs, toFloat(std::sqrt(least / kFarOff2)));
  return ways.count > 0;
}

bool EdgeCollapser::staysManifold(const VertexStar& star, int to) const {
  const std::uint32_t c = star.ring(star.after(to)), d = star.ring(star.before(to));
  if (table_.hasThree(c) || table_.hasThree(d) || (star.size() == 3 && table_.hasThree(star.ring(to))))
    return false;
  const std::uint32_t first = table_.outOf(star.ring(to));
  std::uint32_t h = first;
  do {
    const std::uint32_t w = table_.to(h);
    if (w != c && w != d && star.hasInRing(w)) return false;
    h = table_.turned(h);
  } while (h != first);
  return true;
}

/// Whether a new triangle lies nearly flat on the one beyond its outer edge, and the old one did not.
bool EdgeCollapser::foldsOver(const VertexStar& star, int to, const VertexStar::Change& change) const {
  for (int j = star.after(to); star.after(j) != to; j = star.after(j)) {
    const std::uint32_t outer = table_.turned(CornerTable::previous(star.halfEdge(j)));
    const Eigen::Vector3f& beyond = triangles_[CornerTable::triangleOf(outer)].normal;
    const float now = change.triangle[j].normal.dot(beyond);
    if (now < kFolded && now < triangles_[star.triangle(j)].normal.dot(beyond)) return true;
  }
  return false;
}

void EdgeCollapser::collapse(const VertexStar& star, int to, const VertexStar::Change& change,
                             Sweeps& sweeps) {
  const bool border = vertices_[table_.from(star.halfEdge(to))].freedom == Freedom::kBorder;
  for (int j = star.after(to); star.after(j) != to; j = star.after(j))
    triangles_[star.triangle(j)] = change.triangle[j];
  table_.collapse(star.halfEdge(to));
  std::array<std::uint32_t, VertexStar::kMost> again;
  std::size_t count = 0;
  for (int j = 0; j < star.size(); ++j) {
    const std::uint32_t v = star.ring(j);
    VertexState& state = vertices_[v];
    state.needs = 0.0f;
    if (border) state.next_drift = 0.0f;
    state.swept = sweeps.sweep;
    const bool may_go = state.freedom != Freedom::kNone && state.place != Place::kOutside;
    if (may_go && !state.kept) sweeps.vertices.push_back(v);
    state.kept |= may_go;
    again[count] = v;
    count += static_cast<std::size_t>(may_go && !state.listed);
    state.listed |= may_go;
  }
  sweeps.again.insert(sweeps.again.end(), again.data(), again.data() + count);
}

/// How far a triangle was moved at most, of all.
double EdgeCollapser::distance() const {
  constexpr std::size_t kPart = 4096;
  std::vector<float> most(table_.triangleCount() / kPart + 1, 0.0f);
  parallelFor(std::size_t{0}, most.size(), [&](std::size_t part) {
    for (std::size_t t = part * kPart; t < std::min(table_.triangleCount(), (part + 1) * kPart); ++t) {
      if (!table_.isGone(t)) most[part] = std::max(most[part], triangles_[t].error);
    }
  });
  return std::ranges::max(most);
}

TriMesh EdgeCollapser::result() const {
  TriMesh out;
  const auto number = std::make_unique_for_overwrite<std::uint32_t[]>(vertices_.size());
  const auto kept = [&](std::size_t v) { return !table_.gone(static_cast<std::uint32_t>(v)); };
  const auto keptTriangle = [&](std::size_t t) { return !table_.isGone(t); };
  const Numbering vertices(vertices_.size(), kept), triangles(table_.triangleCount(), keptTriangle);
  out.positions.resize(vertices.count());
  out.triangles.resize(triangles.count());
  if (!mesh_.motion.empty()) out.motion.resize(triangles.count());
  vertices.forEach(kept, [&](std::size_t v, std::size_t n) {
    number[v] = static_cast<std::uint32_t>(n);
    out.positions[n] = mesh_.positions[v];
  });
  triangles.forEach(keptTriangle, [&](std::size_t t, std::size_t n) {
    const std::array<std::uint32_t, 3> corners = table_.corners(t);
    for (std::size_t i = 0; i < 3; ++i) out.triangles[n][i] = number[corners[i]];
    if (!mesh_.motion.empty()) out.motion[n] = mesh_.motion[t];
  });
  return out;
}

}  // namespace proveout
