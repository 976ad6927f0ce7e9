// Half-edges are collapsed, each only if the distance to the mesh as it was stays within the tolerance. Every
// triangle carries a bound of it: going from the surface before a collapse to that after it moves no point by
// more than VertexStar::join tells, so that the sum of what it was moved by bounds the distance both ways.
// (Bounds added up along a chain of maps: J. Cohen, D. Manocha, M. Olano, "Simplifying polygonal models using
// successive mappings", 1997.)
//
// Blocks of space are worked on side by side; a collapse needs all of its surroundings in one block. Larger
// blocks follow, and in the end all of it at once, for what lay on the borders of blocks.
#include "core/mesh/mesh_simplifier.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/mesh/corner_table.h"
#include "core/mesh/intersections.h"
#include "core/mesh/vertex_star.h"

namespace proveout {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
/// Needs of a vertex whose surroundings are in several blocks.
constexpr float kNextRound = -1.0f;
/// Edges of the blocks of a round, in edges of triangles; 0: all is one block.
constexpr double kBlocks[] = {48.0, 190.0, 0.0};
/// Limits of the passes, as parts of the tolerance: what costs little goes first.
constexpr double kPasses[] = {1e-3, 0.1, 0.3, 1.0};
constexpr std::size_t kStretch = 2048;

/// Calls body(i) for each i below count, stretches of them side by side.
template <typename Body>
void forEachOf(std::size_t count, const Body& body) {
  parallelFor(std::size_t{0}, (count + kStretch - 1) / kStretch, [&](std::size_t stretch) {
    for (std::size_t i = stretch * kStretch; i < std::min(count, (stretch + 1) * kStretch); ++i) body(i);
  });
}

/// Mean length of some of the edges, mm.
double meanEdge(const TriMesh& mesh) {
  constexpr std::size_t kEach = 64;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += kEach, ++count)
    sum += (mesh.positions[mesh.triangles[t][0]] - mesh.positions[mesh.triangles[t][1]]).norm();
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

/// Where a vertex may go: anywhere, along the border of two motions, nowhere.
enum class Freedom : std::uint8_t { kFree, kBorder, kNone };

class Simplifier {
 public:
  /// `mesh` must outlive this. Vertices with a flag in `frozen` stay; empty: none has one.
  Simplifier(const TriMesh& mesh, double tolerance, std::span<const std::uint8_t> frozen);

  /// False: cancelled.
  bool run(const Progress& progress);
  TriMesh result() const;
  double distance() const;

 private:
  struct Placed {
    std::uint64_t block;
    std::uint32_t vertex;
    bool operator<(const Placed& o) const { return block != o.block ? block < o.block : vertex < o.vertex; }
  };
  /// A neighbour that a vertex may be joined with; what seems cheapest first.
  struct Way {
    double rank;
    int to;
    bool operator<(const Way& o) const { return rank != o.rank ? rank < o.rank : to < o.to; }
  };
  struct Ways {
    std::array<Way, VertexStar::kMost> all;
    int count = 0;
    std::array<std::uint32_t, 2> border{};  ///< neighbours along it
    float drift = 0.0f;                     ///< of the border, if the vertex goes
  };

  std::uint32_t motionOf(std::uint32_t t) const { return mesh_.motion.empty() ? kNoBorder : mesh_.motion[t]; }
  Freedom freedomOf(std::uint32_t v) const;
  std::vector<Placed> placed(double size) const;
  void simplifyBlocks(double size, std::uint32_t round);
  void simplifyBlock(std::vector<std::uint32_t> vertices, std::uint32_t round);
  bool tryVertex(std::uint32_t v, float limit, std::uint32_t sweep);
  bool isInside(const VertexStar& star, std::uint32_t v) const;
  bool findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool followBorder(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool staysManifold(const VertexStar& star, int to) const;
  void collapse(const VertexStar& star, int to, const VertexStar::Change& change, std::uint32_t sweep);

  static constexpr std::uint32_t kNoBorder = 0;
  const TriMesh& mesh_;
  const double tolerance_;
  CornerTable table_;
  std::vector<Eigen::Vector3f> normals_;  ///< of the triangles
  std::vector<float> error_;              ///< of the triangles, mm
  std::vector<float> drift_;              ///< vertices: of the borders there, mm
  std::vector<float> needs_;              ///< vertices: limit under which it is worth to try again, mm
  std::vector<Freedom> freedom_;
  std::vector<std::uint32_t> block_,
      swept_;  ///< vertices: its block, the last sweep that changed a triangle there
  StarSurroundings around_;
};

Simplifier::Simplifier(const TriMesh& mesh, double tolerance, std::span<const std::uint8_t> frozen)
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
  forEachOf(mesh.triangles.size(), [&](std::size_t t) {
    const auto [a, b, c] = cornersOf(mesh, static_cast<std::uint32_t>(t));
    normals_[t] = (b - a).cross(c - a).normalized().cast<float>();
  });
  forEachOf(mesh.positions.size(), [&](std::size_t v) {
    if (frozen.empty() || frozen[v] == 0) freedom_[v] = freedomOf(static_cast<std::uint32_t>(v));
  });
}

Freedom Simplifier::freedomOf(std::uint32_t v) const {
  if (table_.gone(v)) return Freedom::kNone;
  int borders = 0;
  const std::uint32_t first = table_.outOf(v);
  std::uint32_t h = first;
  do {
    const std::uint32_t after = table_.turned(h);
    borders += motionOf(h / 3) != motionOf(after / 3) ? 1 : 0;
    h = after;
  } while (h != first);
  return borders == 0 ? Freedom::kFree : borders == 2 ? Freedom::kBorder : Freedom::kNone;
}

bool Simplifier::run(const Progress& progress) {
  const double edge = meanEdge(mesh_);
  std::uint32_t round = 0;
  for (const double size : kBlocks) {
    if (progress.cancelled()) return false;
    simplifyBlocks(size * edge, round++);
  }
  return true;
}

/// The vertices that are left, block by block; in each round the borders of blocks are elsewhere.
std::vector<Simplifier::Placed> Simplifier::placed(double size) const {
  constexpr double kShift = 0.37;
  std::vector<Placed> all;
  for (std::uint32_t v = 0; v < table_.vertexCount(); ++v) {
    if (!table_.gone(v)) all.push_back({0, v});
  }
  if (size <= 0.0) return all;
  forEachOf(all.size(), [&](std::size_t i) {
    for (int k = 0; k < 3; ++k) {
      const double cell = std::floor(mesh_.positions[all[i].vertex][k] / size + kShift);
      all[i].block =
          all[i].block << 21 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(cell)) & 0x1FFFFF);
    }
  });
  tbb::parallel_sort(all.begin(), all.end());
  return all;
}

void Simplifier::simplifyBlocks(double size, std::uint32_t round) {
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
void Simplifier::simplifyBlock(std::vector<std::uint32_t> vertices, std::uint32_t round) {
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

bool Simplifier::tryVertex(std::uint32_t v, float limit, std::uint32_t sweep) {
  constexpr int kMostTries = 3;
  VertexStar star;
  needs_[v] = kNever;
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
    if (change->largest <= limit && staysManifold(star, ways.all[i].to)) {
      for (const std::uint32_t end : ways.border) {
        if (freedom_[v] == Freedom::kBorder) drift_[end] = std::max(drift_[end], ways.drift);
      }
      needs_[v] = kNever;
      collapse(star, ways.all[i].to, *change, sweep);
      return true;
    }
    if (change->largest > limit && change->largest <= tolerance_)
      needs_[v] = std::min(needs_[v], change->largest);
  }
  return false;
}

bool Simplifier::isInside(const VertexStar& star, std::uint32_t v) const {
  for (int j = 0; j < star.size(); ++j) {
    if (block_[star.ring(j)] != block_[v]) return false;
  }
  return true;
}

/// The ends of the border and how far it moves. False: it would move too far, or a motion would lose its last
/// triangle.
bool Simplifier::followBorder(const VertexStar& star, std::uint32_t v, float limit, Ways& ways) {
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
bool Simplifier::findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways) {
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

bool Simplifier::staysManifold(const VertexStar& star, int to) const {
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

void Simplifier::collapse(const VertexStar& star, int to, const VertexStar::Change& change,
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
double Simplifier::distance() const {
  double most = 0.0;
  for (std::size_t t = 0; t < error_.size(); ++t) {
    if (table_.triangles()[t][0] != CornerTable::kNone) most = std::max(most, static_cast<double>(error_[t]));
  }
  return most;
}

TriMesh Simplifier::result() const {
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

/// Places where triangles run through each other, with their surroundings.
std::vector<Box3> meetingPlaces(const TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                double reach) {
  std::vector<Box3> places;
  for (const auto& pair : pairs) {
    std::array<Box3, 2> box;
    for (int i = 0; i < 2; ++i) {
      for (const Vec3& corner : cornersOf(mesh, pair[i])) box[i].extend(corner);
    }
    places.push_back(Box3{box[0].min.cwiseMax(box[1].min), box[0].max.cwiseMin(box[1].max)}.inflated(reach));
  }
  return places;
}

/// Flags the vertices that are there. False: all had a flag.
bool freeze(const TriMesh& mesh, const std::vector<Box3>& places, std::vector<std::uint8_t>& frozen) {
  frozen.resize(mesh.positions.size(), 0);
  const auto before = std::count(frozen.begin(), frozen.end(), 1);
  forEachOf(mesh.positions.size(), [&](std::size_t v) {
    const Vec3 p = mesh.positions[v].cast<double>();
    if (std::ranges::any_of(places, [&](const Box3& place) { return place.overlaps({p, p}); })) frozen[v] = 1;
  });
  return std::count(frozen.begin(), frozen.end(), 1) > before;
}

}  // namespace

std::optional<Simplification> simplifyMesh(TriMesh& mesh, double tolerance_mm, const Progress& progress) {
  Simplification out;
  if (!(tolerance_mm > 0.0) || mesh.triangles.empty()) return out;
  constexpr int kMostRuns = 6;
  const double reach = std::max(2.0 * tolerance_mm, meanEdge(mesh));
  std::vector<std::uint8_t> frozen;
  TriMesh simplified;
  for (int run = 0; run < kMostRuns; ++run) {
    Simplifier simplifier(mesh, tolerance_mm, frozen);
    if (!simplifier.run(progress)) return std::nullopt;
    simplified = simplifier.result();
    out.distance_mm = simplifier.distance();
    const std::vector<std::uint8_t> all(simplified.positions.size(), 1);
    const auto pairs = findIntersections(simplified, all);
    out.self_intersections = pairs.size();
    // What runs through itself where nothing was simplified did so before.
    if (pairs.empty() || !freeze(mesh, meetingPlaces(simplified, pairs, reach), frozen)) break;
  }
  mesh = std::move(simplified);
  return out;
}

}  // namespace proveout
