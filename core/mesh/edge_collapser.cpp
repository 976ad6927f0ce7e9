// Half-edges are collapsed, each only if the distance to the mesh as it was stays within the tolerance. Every
// triangle carries a bound of it: going from the surface before a collapse to that after it moves no point by
// more than VertexStar::join tells, so that the sum of what it was moved by bounds the distance both ways.
// (Bounds added up along a chain of maps: J. Cohen, D. Manocha, M. Olano, "Simplifying polygonal models using
// successive mappings", 1997.)
//
// Blocks of space are worked on side by side; a collapse needs all of its surroundings in one block. Larger
// blocks follow, and in the end all of it at once, for what lay on the borders of blocks.
#include "core/mesh/edge_collapser.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/base/stretches.h"
#include "core/mesh/intersections.h"

namespace proveout {
namespace {

constexpr float kNotAgain = std::numeric_limits<float>::infinity();
/// Needs of a vertex whose surroundings are in several blocks.
constexpr float kNextRound = -1.0f;
/// Edges of the blocks of a round, in edges of triangles; 0: all is one block.
constexpr double kBlocks[] = {48.0, 190.0, 0.0};
/// Limits of the passes, as parts of the tolerance: what costs little goes first.
constexpr double kPasses[] = {1e-3, 0.1, 0.3, 1.0};
/// Neighbours lie nearly flat on each other: the cosine between their normals.
constexpr float kFolded = -0.8f;

}  // namespace

double EdgeCollapser::meanEdge(const TriMesh& mesh) {
  constexpr std::size_t kEach = 64;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += kEach, ++count)
    sum += (mesh.positions[mesh.triangles[t][0]] - mesh.positions[mesh.triangles[t][1]]).norm();
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

EdgeCollapser::EdgeCollapser(const TriMesh& mesh, double tolerance, std::span<const std::uint8_t> frozen)
    : mesh_(mesh),
      tolerance_(tolerance),
      table_(mesh.triangles, mesh.positions.size()),
      normals_(mesh.triangles.size()),
      error_(mesh.triangles.size(), 0.0f),
      drift_(mesh.positions.size(), 0.0f),
      needs_(mesh.positions.size(), 0.0f),
      freedom_(mesh.positions.size(), Freedom::kNone),
      block_(mesh.positions.size(), 0),
      swept_(mesh.positions.size(), 0),
      around_{table_, mesh.positions, normals_, error_} {
  // So many units in the last place of the coordinates: less high triangles could be turned over by rounding.
  constexpr double kLeastUnits = 64.0;
  const Box3 bounds = meshBounds(mesh);
  const double far = std::max(bounds.min.cwiseAbs().maxCoeff(), bounds.max.cwiseAbs().maxCoeff());
  around_.least_height = kLeastUnits * std::numeric_limits<float>::epsilon() * far;
  forEachBelow(mesh.triangles.size(), [&](std::size_t t) {
    const auto [a, b, c] = cornersOf(mesh, static_cast<std::uint32_t>(t));
    normals_[t] = (b - a).cross(c - a).normalized().cast<float>();
  });
  forEachBelow(mesh.positions.size(), [&](std::size_t v) {
    if (frozen.empty() || frozen[v] == 0) freedom_[v] = freedomOf(static_cast<std::uint32_t>(v));
  });
}

/// Whether neighbours in the triangles around a vertex lie nearly flat on each other.
bool EdgeCollapser::isFolded(std::uint32_t v) const {
  const std::uint32_t first = table_.outOf(v);
  std::uint32_t h = first;
  do {
    const std::uint32_t after = table_.turned(h);
    if (normals_[h / 3].dot(normals_[after / 3]) < kFolded) return true;
    h = after;
  } while (h != first);
  return false;
}

/// Around what is folded already nothing is taken away: the layers may be as near to each other as can be.
EdgeCollapser::Freedom EdgeCollapser::freedomOf(std::uint32_t v) const {
  if (table_.gone(v)) return Freedom::kNone;
  int borders = 0;
  const std::uint32_t first = table_.outOf(v);
  std::uint32_t h = first;
  do {
    const std::uint32_t after = table_.turned(h);
    if (isFolded(table_.to(h))) return Freedom::kNone;
    borders += motionOf(h / 3) != motionOf(after / 3) ? 1 : 0;
    h = after;
  } while (h != first);
  return borders == 0 ? Freedom::kFree : borders == 2 ? Freedom::kBorder : Freedom::kNone;
}

bool EdgeCollapser::run(const Progress& progress) {
  const double edge = meanEdge(mesh_);
  std::uint32_t round = 0;
  for (const double size : kBlocks) {
    if (progress.cancelled()) return false;
    simplifyBlocks(size * edge, round++);
  }
  return true;
}

/// The vertices that are left, block by block; in each round the borders of blocks are elsewhere.
std::vector<EdgeCollapser::Placed> EdgeCollapser::placed(double size) const {
  constexpr double kShift = 0.37;
  std::vector<Placed> all;
  for (std::uint32_t v = 0; v < table_.vertexCount(); ++v) {
    if (!table_.gone(v)) all.push_back({0, v});
  }
  if (size <= 0.0) return all;
  forEachBelow(all.size(), [&](std::size_t i) {
    for (int k = 0; k < 3; ++k) {
      const double cell = std::floor(mesh_.positions[all[i].vertex][k] / size + kShift);
      all[i].block =
          all[i].block << 21 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(cell)) & 0x1FFFFF);
    }
  });
  tbb::parallel_sort(all.begin(), all.end());
  return all;
}

void EdgeCollapser::simplifyBlocks(double size, std::uint32_t round) {
  const std::vector<Placed> all = placed(size);
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 0 || all[i].block != all[i - 1].block) first.push_back(i);
    block_[all[i].vertex] = static_cast<std::uint32_t>(first.size());
    if (needs_[all[i].vertex] == kNextRound) needs_[all[i].vertex] = 0.0f;
  }
  first.push_back(all.size());
  parallelFor(std::size_t{1}, first.size(), [&](std::size_t block) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t i = first[block - 1]; i < first[block]; ++i) {
      if (freedom_[all[i].vertex] != Freedom::kNone) vertices.push_back(all[i].vertex);
    }
    simplifyBlock(std::move(vertices), round);
  });
}

/// Sweeps over the vertices, and in each joins none beside another, so that triangles do not become long
/// where they could be round.
void EdgeCollapser::simplifyBlock(std::vector<std::uint32_t> vertices, std::uint32_t round) {
  constexpr std::uint32_t kMostSweeps = 1u << 12;
  std::uint32_t sweep = round * kMostSweeps * static_cast<std::uint32_t>(std::size(kPasses));
  for (const double pass : kPasses) {
    const auto limit = static_cast<float>(pass * tolerance_);
    const std::uint32_t last = sweep + kMostSweeps - 1;
    for (std::size_t joined = 1; joined > 0 && sweep < last;) {
      ++sweep;
      joined = 0;
      for (const std::uint32_t v : vertices) {
        if (needs_[v] <= limit && needs_[v] != kNextRound && swept_[v] != sweep && tryVertex(v, limit, sweep))
          ++joined;
      }
      std::erase_if(vertices, [&](std::uint32_t v) { return table_.gone(v); });
    }
    sweep = last;
  }
}

bool EdgeCollapser::tryVertex(std::uint32_t v, float limit, std::uint32_t sweep) {
  constexpr int kMostTries = 3;
  VertexStar star;
  needs_[v] = kNotAgain;
  if (!star.look(around_, v)) return false;
  if (!isInside(star, v)) {
    needs_[v] = kNextRound;
    return false;
  }
  Ways ways;
  if (freedom_[v] == Freedom::kBorder && !followBorder(star, v, limit, ways)) return false;
  if (!findWays(star, v, limit, ways) || !star.findView()) return false;
  for (int i = 0; i < std::min(ways.count, kMostTries); ++i) {
    const auto change = star.join(ways.all[i].to);
    if (!change) continue;
    if (change->largest <= limit && staysManifold(star, ways.all[i].to) &&
        !foldsOver(star, ways.all[i].to, *change)) {
      for (const std::uint32_t end : ways.border) {
        if (freedom_[v] == Freedom::kBorder) drift_[end] = std::max(drift_[end], ways.drift);
      }
      needs_[v] = kNotAgain;
      collapse(star, ways.all[i].to, *change, sweep);
      return true;
    }
    if (change->largest > limit && change->largest <= tolerance_)
      needs_[v] = std::min(needs_[v], change->largest);
  }
  return false;
}

bool EdgeCollapser::isInside(const VertexStar& star, std::uint32_t v) const {
  for (int j = 0; j < star.size(); ++j) {
    if (block_[star.ring(j)] != block_[v]) return false;
  }
  return true;
}

/// The ends of the border and how far it moves. False: it would move too far, or a motion would lose its last
/// triangle.
bool EdgeCollapser::followBorder(const VertexStar& star, std::uint32_t v, float limit, Ways& ways) {
  std::array<int, 2> end{};
  int count = 0;
  for (int j = 0; j < star.size(); ++j) {
    if (motionOf(star.triangle(j)) != motionOf(star.triangle(star.before(j)))) end[count++] = j;
  }
  const int run = end[1] - end[0];
  if (run < 2 || star.size() - run < 2) return false;
  const Vec3 &p = star.arm(end[0]), along = star.arm(end[1]) - p;
  const double part = std::clamp(-p.dot(along) / along.squaredNorm(), 0.0, 1.0);
  ways.drift = drift_[v] + static_cast<float>((p + part * along).norm());
  ways.border = {star.ring(end[0]), star.ring(end[1])};
  if (ways.drift > limit) {
    if (ways.drift <= tolerance_) needs_[v] = ways.drift;
    return false;
  }
  ways.all[0].to = end[0];
  ways.all[1].to = end[1];
  ways.count = 2;
  return true;
}

/// False: there are none, and needs_ says when there may be.
bool EdgeCollapser::findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways) {
  // A neighbour so many times farther from the planes than the surface may move is not worth to be looked at,
  // and the nearest one is better by this part of the tolerance than the farthest.
  constexpr double kFarOff = 3.0, kNear = 0.02;
  if (freedom_[v] == Freedom::kFree) {
    for (int j = 0; j < star.size(); ++j) ways.all[ways.count++].to = j;
  }
  double longest2 = 0.0;
  for (int j = 0; j < star.size(); ++j) longest2 = std::max(longest2, star.arm(j).squaredNorm());
  const int all = std::exchange(ways.count, 0);
  for (int i = 0; i < all; ++i) {
    const int to = ways.all[i].to;
    const double off = star.offPlanes(to);
    if (off <= kFarOff * limit) {
      ways.all[ways.count++] = {off + kNear * tolerance_ * std::sqrt(star.arm(to).squaredNorm() / longest2),
                                to};
    } else if (off <= kFarOff * tolerance_) {
      needs_[v] = std::min(needs_[v], static_cast<float>(off / kFarOff));
    }
  }
  std::sort(ways.all.begin(), ways.all.begin() + ways.count);
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
    for (int j = 0; j < star.size() && w != c && w != d; ++j) {
      if (star.ring(j) == w) return false;
    }
    h = table_.turned(h);
  } while (h != first);
  return true;
}

/// Whether a new triangle lies nearly flat on the one beyond its outer edge, and the old one did not.
bool EdgeCollapser::foldsOver(const VertexStar& star, int to, const VertexStar::Change& change) const {
  for (int j = star.after(to); star.after(j) != to; j = star.after(j)) {
    const Eigen::Vector3f& beyond = normals_[table_.twin(CornerTable::next(star.halfEdge(j))) / 3];
    const float now = change.normal[j].dot(beyond);
    if (now < kFolded && now < normals_[star.triangle(j)].dot(beyond)) return true;
  }
  return false;
}

void EdgeCollapser::collapse(const VertexStar& star, int to, const VertexStar::Change& change,
                             std::uint32_t sweep) {
  for (int j = star.after(to); star.after(j) != to; j = star.after(j)) {
    error_[star.triangle(j)] = change.error[j];
    normals_[star.triangle(j)] = change.normal[j];
  }
  table_.collapse(star.halfEdge(to));
  for (int j = 0; j < star.size(); ++j) {
    needs_[star.ring(j)] = 0.0f;
    swept_[star.ring(j)] = sweep;
  }
}

/// How far a triangle was moved at most, of all.
double EdgeCollapser::distance() const {
  double most = 0.0;
  for (std::size_t t = 0; t < error_.size(); ++t) {
    if (table_.triangles()[t][0] != CornerTable::kNone) most = std::max(most, static_cast<double>(error_[t]));
  }
  return most;
}

TriMesh EdgeCollapser::result() const {
  TriMesh out;
  std::vector<std::uint32_t> number(mesh_.positions.size());
  for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) {
    if (table_.gone(v)) continue;
    number[v] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(mesh_.positions[v]);
  }
  for (std::size_t t = 0; t < table_.triangles().size(); ++t) {
    const auto& [a, b, c] = table_.triangles()[t];
    if (a == CornerTable::kNone) continue;
    out.triangles.push_back({number[a], number[b], number[c]});
    if (!mesh_.motion.empty()) out.motion.push_back(mesh_.motion[t]);
  }
  return out;
}

}  // namespace proveout
