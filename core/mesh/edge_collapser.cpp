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
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/base/stretches.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mean_edge.h"

namespace proveout {
namespace {

constexpr float kNotAgain = std::numeric_limits<float>::infinity();
/// Added to the block of a vertex that has neighbours in others.
constexpr std::uint32_t kOnBorder = 1u << 30;
/// Edges of the blocks of a round, in edges of triangles; 0: all is one block.
constexpr double kBlocks[] = {48.0, 190.0, 0.0};
/// Limits of the passes, as parts of the tolerance: what costs little goes first.
constexpr double kPasses[] = {1e-3, 0.1, 0.3, 1.0};
/// Neighbours lie nearly flat on each other: the cosine between their normals.
constexpr float kFolded = -0.8f;

}  // namespace

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
  findFreedoms(frozen);
}

/// Around what is folded already nothing is taken away: the layers may be as near to each other as can be.
void EdgeCollapser::findFreedoms(std::span<const std::uint8_t> frozen) {
  constexpr std::uint8_t kMany = 3;  // borders
  std::vector<std::uint8_t> borders(freedom_.size(), 0), folded(freedom_.size(), 0);
  forEachBelow(3 * table_.triangles().size(), [&](std::size_t i) {
    const auto h = static_cast<std::uint32_t>(i), t = table_.twin(h) / 3;
    const std::atomic_ref count(borders[table_.from(h)]);
    if (motionOf(h / 3) != motionOf(t) && count.load(std::memory_order_relaxed) < kMany)
      count.fetch_add(1, std::memory_order_relaxed);
    if (normals_[h / 3].dot(normals_[t]) < kFolded)
      std::atomic_ref(folded[table_.from(h)]).store(1, std::memory_order_relaxed);
  });
  forEachBelow(freedom_.size(), [&](std::size_t v) {
    if (table_.gone(static_cast<std::uint32_t>(v)) || (!frozen.empty() && frozen[v] != 0)) return;
    freedom_[v] = borders[v] == 0 ? Freedom::kFree : borders[v] == 2 ? Freedom::kBorder : Freedom::kNone;
  });
  for (std::uint32_t v = 0; v < folded.size(); ++v) {
    if (folded[v] == 0) continue;
    const std::uint32_t first = table_.outOf(v);
    std::uint32_t h = first;
    do {
      freedom_[table_.to(h)] = Freedom::kNone;
      h = table_.turned(h);
    } while (h != first);
  }
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

/// Gives all vertices their blocks; in each round the borders of blocks are elsewhere. Two blocks may have
/// one number, and then are worked on by one thread.
void EdgeCollapser::findBlocks(double size) {
  constexpr double kShift = 0.37;
  constexpr std::uint32_t kBits = 10, kMask = (1u << kBits) - 1;
  std::fill(block_.begin(), block_.end(), 0u);
  if (!(size > 0.0)) return;
  forEachBelow(block_.size(), [&](std::size_t v) {
    for (int k = 0; k < 3; ++k) {
      const auto cell = static_cast<std::int32_t>(std::floor(mesh_.positions[v][k] / size + kShift));
      block_[v] = block_[v] << kBits | (static_cast<std::uint32_t>(cell) & kMask);
    }
  });
  // A collapse within a block leads to no edges out of it: what is off its border now is so until the end.
  forEachBelow(table_.triangles().size(), [&](std::size_t t) {
    const auto& v = table_.triangles()[t];
    if (v[0] == CornerTable::kNone) return;
    const auto blockOf = [&](int i) {
      return std::atomic_ref(block_[v[static_cast<std::size_t>(i)]]).load(std::memory_order_relaxed) %
             kOnBorder;
    };
    if (blockOf(0) == blockOf(1) && blockOf(1) == blockOf(2)) return;
    for (const std::uint32_t corner : v)
      std::atomic_ref(block_[corner]).fetch_or(kOnBorder, std::memory_order_relaxed);
  });
}

/// The vertices off the borders of blocks that may go, block by block.
std::vector<std::uint32_t> EdgeCollapser::candidates() const {
  std::vector<std::uint32_t> all;
  for (std::uint32_t v = 0; v < table_.vertexCount(); ++v) {
    if (freedom_[v] != Freedom::kNone && block_[v] < kOnBorder && !table_.gone(v)) all.push_back(v);
  }
  tbb::parallel_sort(all.begin(), all.end(), [&](std::uint32_t a, std::uint32_t b) {
    return block_[a] != block_[b] ? block_[a] < block_[b] : a < b;
  });
  return all;
}

void EdgeCollapser::simplifyBlocks(double size, std::uint32_t round) {
  findBlocks(size);
  const std::vector<std::uint32_t> all = candidates();
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 0 || block_[all[i]] != block_[all[i - 1]]) first.push_back(i);
  }
  first.push_back(all.size());
  parallelFor(std::size_t{1}, first.size(), [&](std::size_t block) {
    const auto begin = all.begin();
    simplifyBlock({begin + static_cast<std::ptrdiff_t>(first[block - 1]),
                   begin + static_cast<std::ptrdiff_t>(first[block])},
                  round);
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
        if (needs_[v] <= limit && swept_[v] != sweep && tryVertex(v, limit, sweep)) ++joined;
      }
      std::erase_if(vertices, [&](std::uint32_t v) { return table_.gone(v); });
    }
    sweep = last;
  }
}

bool EdgeCollapser::tryVertex(std::uint32_t v, float limit, std::uint32_t sweep) {
  constexpr int kMostTries = 3;
  VertexStar star;
  Ways ways;
  needs_[v] = kNotAgain;
  if (freedom_[v] == Freedom::kBorder && !followBorder(v, limit, ways)) return false;
  if (!star.look(around_, v)) return false;
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

/// The ends of the border and how far it moves. False: it would move too far, or a motion would lose its last
/// triangle.
bool EdgeCollapser::followBorder(std::uint32_t v, float limit, Ways& ways) {
  std::array<int, 2> end{};
  int count = 0, size = 0;
  const std::uint32_t first = table_.outOf(v);
  std::uint32_t h = first, motion = motionOf(table_.twin(h) / 3);
  do {
    const std::uint32_t left = motionOf(h / 3);
    if (left != motion && count < 2) {
      end[count] = size;
      ways.border[count++] = table_.to(h);
    }
    motion = left;
    ++size;
    h = table_.turned(h);
  } while (h != first);
  const int run = end[1] - end[0];
  if (run < 2 || size - run < 2) return false;
  const Eigen::Vector3f& at = mesh_.positions[v];
  const Vec3 p = (mesh_.positions[ways.border[0]] - at).cast<double>();
  const Vec3 along = (mesh_.positions[ways.border[1]] - at).cast<double>() - p;
  const double part = std::clamp(-p.dot(along) / along.squaredNorm(), 0.0, 1.0);
  ways.drift = drift_[v] + static_cast<float>((p + part * along).norm());
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
