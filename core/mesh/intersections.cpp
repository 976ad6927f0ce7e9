#include "core/mesh/intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/base/stretches.h"

namespace proveout {

namespace {

using Points = std::array<Vec3, 3>;

/// A triangle whose height is less than this part of its length is none.
constexpr double kFlat = 1e-7;
/// Of the square of a size: what rounding in floats may be.
constexpr float kClearMargin = 1e-5f;
constexpr float kNever = std::numeric_limits<float>::infinity();

/// Volumes of less than this part of what their edges span are rounding.
constexpr double kRounding = 2e-15;

/// Six times the volume of the tetrahedron.
double orient(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool sameSide(double a, double b, double c) {
  return (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0);
}

/// A segment and a triangle of one plane.
bool meetFlat(const Vec3& p, const Vec3& q, const Points& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  int drop = 0;
  n.cwiseAbs().maxCoeff(&drop);
  const auto flat = [&](const Vec3& v) { return Vec2(v[(drop + 1) % 3], v[(drop + 2) % 3]); };
  const Vec2 a = flat(p), b = flat(q);
  const std::array<Vec2, 3> c = {flat(t[0]), flat(t[1]), flat(t[2])};
  if (sameSide(turn(c[0], c[1], a), turn(c[1], c[2], a), turn(c[2], c[0], a))) return true;
  for (int i = 0; i < 3; ++i) {
    const Vec2 &from = c[i], &to = c[(i + 1) % 3];
    const double to_a = turn(from, to, a), to_b = turn(from, to, b);
    if (to_a == 0.0 && to_b == 0.0) continue;  // on one line: told by the other edges, if they overlap
    if (to_a * to_b <= 0.0 && turn(a, b, from) * turn(a, b, to) <= 0.0) return true;
  }
  return false;
}

/// The side of the triangle's plane that a point is on, 0 within rounding.
double sideOf(const Points& t, const Vec3& p) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0], c = p - t[0];
  const double volume = a.cross(b).dot(c);
  const double spanned2 = a.squaredNorm() * b.squaredNorm() * c.squaredNorm();
  return volume * volume <= kRounding * kRounding * spanned2 ? 0.0 : volume;
}

bool segmentMeets(const Vec3& p, const Vec3& q, const Points& t) {
  const double side_p = sideOf(t, p), side_q = sideOf(t, q);
  if (side_p * side_q > 0.0) return false;
  if (side_p == 0.0 && side_q == 0.0) return meetFlat(p, q, t);
  return sameSide(orient(p, q, t[0], t[1]), orient(p, q, t[1], t[2]), orient(p, q, t[2], t[0]));
}

/// Whether the corners of `q`, apart from number `but`, are all off the plane of `t` on one side.
bool apart(const Points& t, const Points& q, int but) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  int above = 0, below = 0;
  for (int i = 0; i < 3; ++i) {
    if (i == but) continue;
    const double side = n.dot(q[i] - t[0]);
    above += side > 0.0;
    below += side < 0.0;
  }
  const int all = but < 0 ? 3 : 2;
  return above == all || below == all;
}

/// Whether the direction from one triangle's middle to the other's keeps them apart but for a common corner
/// (`but_p`, `but_q`; below 0: none). Tells most neighbours apart, and costs little.
bool clear(const Points& p, int but_p, const Points& q, int but_q) {
  const Vec3 way = (q[0] - p[0]) + (q[1] - p[1]) + (q[2] - p[2]);
  double before = -kNever, behind = kNever;
  for (int i = 0; i < 3; ++i) {
    if (i != but_p) before = std::max(before, way.dot(p[i]));
    if (i != but_q) behind = std::min(behind, way.dot(q[i]));
  }
  if (but_p < 0) return before < behind;
  const double between = way.dot(p[but_p]);
  return before < between && between < behind;
}

/// The same in floats for triangles without a common corner, seen from a corner of the first: true only if
/// rounding cannot change it.
bool clearInFloats(const TriMesh& mesh, const std::array<std::uint32_t, 3>& a,
                   const std::array<std::uint32_t, 3>& b) {
  const auto& origin = mesh.positions[a[0]];
  std::array<Eigen::Vector3f, 3> p, q;
  Eigen::Vector3f way = Eigen::Vector3f::Zero();
  float size = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = mesh.positions[a[i]] - origin;
    q[i] = mesh.positions[b[i]] - origin;
    way += q[i] - p[i];
    size = std::max({size, p[i].squaredNorm(), q[i].squaredNorm()});
  }
  const float before = std::max({way.dot(p[0]), way.dot(p[1]), way.dot(p[2])});
  return before + kClearMargin * size < std::min({way.dot(q[0]), way.dot(q[1]), way.dot(q[2])});
}

/// And for triangles with one common corner, number `at_a` and `at_b`, seen from there.
bool clearAtCorner(const TriMesh& mesh, const std::array<std::uint32_t, 3>& a, int at_a,
                   const std::array<std::uint32_t, 3>& b, int at_b) {
  constexpr std::array<std::uint8_t, 5> kNext = {0, 1, 2, 0, 1};
  const auto& origin = mesh.positions[a[static_cast<std::size_t>(at_a)]];
  const auto from = [&](const std::array<std::uint32_t, 3>& t, int at, int step) -> Eigen::Vector3f {
    return mesh.positions[t[kNext[static_cast<std::size_t>(at + step)]]] - origin;
  };
  const Eigen::Vector3f p = from(a, at_a, 1), r = from(a, at_a, 2), q = from(b, at_b, 1),
                        s = from(b, at_b, 2);
  const Eigen::Vector3f way = (q + s) - (p + r);
  const float margin =
      kClearMargin * std::max({p.squaredNorm(), r.squaredNorm(), q.squaredNorm(), s.squaredNorm()});
  return std::max(way.dot(p), way.dot(r)) < -margin && std::min(way.dot(q), way.dot(s)) > margin;
}

/// Whether two triangles with a common edge, seen from both in the same direction, are so by their normals.
bool unfoldedInFloats(const TriMesh& mesh, const std::array<std::uint32_t, 3>& a,
                      const std::array<std::uint32_t, 3>& b) {
  constexpr float kMargin = 1e-3f;
  const auto normal = [&](const std::array<std::uint32_t, 3>& t) {
    const auto& p = mesh.positions;
    return Eigen::Vector3f((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]));
  };
  const Eigen::Vector3f n = normal(a), m = normal(b);
  const float along = n.dot(m);
  return along > 0.0f && along * along > kMargin * n.squaredNorm() * m.squaredNorm();
}

/// Corners that two triangles have in common.
struct CommonCorners {
  int count = 0, at_a = -1, at_b = -1;  ///< of the last one, below 0: none
  int sum_b = 0;                        ///< of its places in the second triangle
};

/// Whether two triangles with at most two common corners meet elsewhere.
[[gnu::noinline]] bool meetInDoubles(const Points& p, const Points& q, const CommonCorners& common) {
  const int at_a = common.at_a, at_b = common.at_b;
  if (common.count == 2) {  // folded flat onto each other
    if (orient(p[0], p[1], p[2], q[static_cast<std::size_t>(3 - common.sum_b)]) != 0.0) return false;
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]), m = (q[1] - q[0]).cross(q[2] - q[0]);
    return n.dot(m) < 0.0 && n.squaredNorm() > 0.0;
  }
  if (clear(p, at_a, q, at_b) || apart(p, q, at_b) || apart(q, p, at_a)) return false;
  if (common.count == 1) {
    return segmentMeets(p[(at_a + 1) % 3], p[(at_a + 2) % 3], q) ||
           segmentMeets(q[(at_b + 1) % 3], q[(at_b + 2) % 3], p);
  }
  for (int i = 0; i < 3; ++i) {
    if (segmentMeets(p[i], p[(i + 1) % 3], q) || segmentMeets(q[i], q[(i + 1) % 3], p)) return true;
  }
  return false;
}

struct Span {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(kNever), high = Eigen::Vector3f::Constant(-kNever);

  void add(const Span& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};

/// Eight spans side by side, so that one pass over plain arrays compares all of them.
struct Spans {
  static constexpr int kCount = 8;
  std::array<std::array<float, kCount>, 3> low, high;

  Spans() {
    for (auto& l : low) l.fill(kNever);
    for (auto& h : high) h.fill(-kNever);
  }
  void set(std::size_t i, const Span& span) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis][i] = span.low[axis];
      high[axis][i] = span.high[axis];
    }
  }
  Span at(std::size_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }
  Span all() const {
    Span span;
    for (int axis = 0; axis < 3; ++axis) {
      span.low[axis] = *std::min_element(low[axis].begin(), low[axis].end());
      span.high[axis] = *std::max_element(high[axis].begin(), high[axis].end());
    }
    return span;
  }
  /// Bit i: the i-th span touches `span`.
  unsigned touching(const Span& span) const;
};

inline unsigned Spans::touching(const Span& span) const {
#if defined(__SSE2__)
  unsigned bits = 0;
  for (int half = 0; half < kCount; half += 4) {
    __m128 in = _mm_castsi128_ps(_mm_set1_epi32(-1));
    for (int axis = 0; axis < 3; ++axis) {
      in = _mm_and_ps(in, _mm_cmple_ps(_mm_loadu_ps(&low[axis][half]), _mm_set1_ps(span.high[axis])));
      in = _mm_and_ps(in, _mm_cmpge_ps(_mm_loadu_ps(&high[axis][half]), _mm_set1_ps(span.low[axis])));
    }
    bits |= static_cast<unsigned>(_mm_movemask_ps(in)) << half;
  }
  return bits;
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < kCount; ++i) {
    bool in = true;
    for (int axis = 0; axis < 3; ++axis)
      in = in && low[axis][i] <= span.high[axis] && high[axis][i] >= span.low[axis];
    bits |= static_cast<unsigned>(in) << i;
  }
  return bits;
#endif
}

/// Triangles stand leaf by leaf, so that those with following numbers are close together: a tree of boxes
/// over groups of them, in their order, finds neighbours without sorting. Groups with suspects ask it for the
/// groups that they touch.
class Finder {
 public:
  Finder(const TriMesh& mesh, std::span<const std::uint8_t> suspect)
      : mesh_(mesh),
        suspect_(suspect),
        count_(mesh.triangles.size()),
        groups_((count_ + Spans::kCount - 1) / Spans::kCount) {}
  /// Looks at these triangles alone, all of them suspects.
  Finder(const TriMesh& mesh, std::span<const std::uint32_t> chosen)
      : mesh_(mesh),
        chosen_(chosen),
        count_(chosen.size()),
        groups_((count_ + Spans::kCount - 1) / Spans::kCount) {}

  std::vector<std::array<std::uint32_t, 2>> find();

 private:
  using Pairs = std::vector<std::array<std::uint32_t, 2>>;
  /// The suspects among the triangles of a group; empty spans at the others.
  struct Group {
    Spans spans;
    unsigned suspects = 0;
  };
  /// Spans of groups that were looked at last: each is near many others.
  struct SpanCache {
    static constexpr std::size_t kEntries = 256;
    struct Entry {
      std::size_t group = SIZE_MAX;
      Spans spans;
    };
    std::vector<Entry> entries = std::vector<Entry>(kEntries);
  };
  /// The number in the mesh of the i-th triangle that is looked at.
  std::uint32_t numberOf(std::size_t i) const {
    return chosen_.empty() ? static_cast<std::uint32_t>(i) : chosen_[i];
  }
  [[gnu::always_inline]] Span spanOf(std::size_t i) const {
    const auto& v = mesh_.triangles[numberOf(i)];
    const auto &a = mesh_.positions[v[0]], &b = mesh_.positions[v[1]], &c = mesh_.positions[v[2]];
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
  }
  bool isSuspect(std::size_t i) const { return suspect_.empty() || suspect_[i] != 0; }
  std::size_t endOf(std::size_t group) const { return std::min(count_, (group + 1) * Spans::kCount); }
  Group suspectsOf(std::size_t group) const;
  Spans spansOf(std::size_t group) const {
    Spans spans;
    const std::size_t first = group * Spans::kCount;
    for (std::size_t t = first; t < endOf(group); ++t) spans.set(t - first, spanOf(t));
    return spans;
  }
  void buildTree();
  template <typename Body>
  void eachTouching(const Span& span, std::size_t level, std::size_t at, Body&& body) const;
  void compare(std::size_t own, const Group& group, std::size_t other, const Spans& there,
               Pairs& found) const;
  Pairs findOf(std::size_t first, std::size_t last) const;

  const TriMesh& mesh_;
  std::span<const std::uint8_t> suspect_;  ///< a flag a triangle; empty: all are
  std::span<const std::uint32_t> chosen_;  ///< what is looked at; empty: all
  std::size_t count_, groups_;
  std::vector<std::vector<Spans>> levels_;  ///< spans of groups; of the spans below; ...; one at the top
};

Finder::Group Finder::suspectsOf(std::size_t group) const {
  Group out;
  const std::size_t first = group * Spans::kCount;
  for (std::size_t t = first; t < endOf(group); ++t) {
    if (!isSuspect(t)) continue;
    out.suspects |= 1u << (t - first);
    out.spans.set(t - first, spanOf(t));
  }
  return out;
}

void Finder::buildTree() {
  levels_.emplace_back((groups_ + Spans::kCount - 1) / Spans::kCount);
  parallelFor(std::size_t{0}, levels_[0].size(), [&](std::size_t i) {
    for (std::size_t k = 0; k < Spans::kCount && i * Spans::kCount + k < groups_; ++k) {
      const std::size_t group = i * Spans::kCount + k;
      Span all;
      for (std::size_t t = group * Spans::kCount; t < endOf(group); ++t) all.add(spanOf(t));
      levels_[0][i].set(k, all);
    }
  });
  while (levels_.back().size() > 1) {
    const std::vector<Spans>& below = levels_.back();
    std::vector<Spans> level((below.size() + Spans::kCount - 1) / Spans::kCount);
    for (std::size_t i = 0; i < below.size(); ++i)
      level[i / Spans::kCount].set(i % Spans::kCount, below[i].all());
    levels_.push_back(std::move(level));
  }
}

/// Calls body(group) for the groups that the span touches.
template <typename Body>
void Finder::eachTouching(const Span& span, std::size_t level, std::size_t at, Body&& body) const {
  for (unsigned rest = levels_[level][at].touching(span); rest != 0; rest &= rest - 1) {
    const std::size_t below = at * Spans::kCount + static_cast<std::size_t>(std::countr_zero(rest));
    if (level == 0) {
      body(below);
    } else {
      eachTouching(span, level - 1, below, body);
    }
  }
}

/// Pairs of a suspect of the group `own` and a triangle of the group `other`, whose spans are given. Of two
/// suspects the lower one finds the other.
void Finder::compare(std::size_t own, const Group& group, std::size_t other, const Spans& there,
                     Pairs& found) const {
  const Span all = levels_[0][other / Spans::kCount].at(other % Spans::kCount);
  for (unsigned left = group.suspects & group.spans.touching(all); left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const std::size_t s = own * Spans::kCount + k;
    for (unsigned rest = there.touching(group.spans.at(k)); rest != 0; rest &= rest - 1) {
      const std::size_t t = other * Spans::kCount + static_cast<std::size_t>(std::countr_zero(rest));
      if (s == t || (s > t && isSuspect(t))) continue;
      const auto [low, high] = std::minmax({numberOf(s), numberOf(t)});
      if (trianglesMeet(mesh_, low, high)) found.push_back({low, high});
    }
  }
}

/// Pairs of the suspects of groups first..last-1.
Finder::Pairs Finder::findOf(std::size_t first, std::size_t last) const {
  Pairs found;
  SpanCache cache;
  for (std::size_t own = first; own < last; ++own) {
    const Group group = suspectsOf(own);
    if (group.suspects == 0) continue;
    for (unsigned rest = group.suspects; rest != 0; rest &= rest - 1) {
      const std::uint32_t t =
          numberOf(own * Spans::kCount + static_cast<std::size_t>(std::countr_zero(rest)));
      if (isNeedle(mesh_, t)) found.push_back({t, t});
    }
    eachTouching(group.spans.all(), levels_.size() - 1, 0, [&](std::size_t other) {
      if (suspect_.empty() && other < own) return;  // found from there
      SpanCache::Entry& entry = cache.entries[other % SpanCache::kEntries];
      if (entry.group != other) entry = {other, spansOf(other)};
      compare(own, group, other, entry.spans, found);
    });
  }
  return found;
}

std::vector<std::array<std::uint32_t, 2>> Finder::find() {
  if (count_ == 0) return {};
  buildTree();
  constexpr std::size_t kPart = 256;
  std::vector<Pairs> found((groups_ + kPart - 1) / kPart);
  parallelFor(std::size_t{0}, found.size(), [&](std::size_t part) {
    found[part] = findOf(part * kPart, std::min(groups_, (part + 1) * kPart));
  });
  Pairs out;
  for (const Pairs& list : found) out.insert(out.end(), list.begin(), list.end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

std::array<Vec3, 3> cornersOf(const TriMesh& mesh, std::uint32_t t) {
  const auto& v = mesh.triangles[t];
  return {mesh.positions[v[0]].cast<double>(), mesh.positions[v[1]].cast<double>(),
          mesh.positions[v[2]].cast<double>()};
}

bool trianglesMeet(const TriMesh& mesh, std::uint32_t s, std::uint32_t t) {
  const auto &a = mesh.triangles[s], &b = mesh.triangles[t];
  CommonCorners common;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t v = a[static_cast<std::size_t>(i)];
    const int j = v == b[0] ? 0 : v == b[1] ? 1 : v == b[2] ? 2 : -1;
    if (j < 0) continue;
    ++common.count;
    common.at_a = i;
    common.at_b = j;
    common.sum_b += j;
  }
  if (common.count >= 3) return true;
  const bool far = common.count == 2   ? unfoldedInFloats(mesh, a, b)
                   : common.count == 1 ? clearAtCorner(mesh, a, common.at_a, b, common.at_b)
                                       : clearInFloats(mesh, a, b);
  if (far) return false;
  return meetInDoubles(cornersOf(mesh, s), cornersOf(mesh, t), common);
}

bool isNeedle(const TriMesh& mesh, std::uint32_t t) {
  const Points p = cornersOf(mesh, t);
  const Vec3 a = p[1] - p[0], b = p[2] - p[0];
  const double size2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  return a.cross(b).squaredNorm() <= kFlat * kFlat * size2 * size2;
}

std::vector<std::array<std::uint32_t, 2>> findIntersections(const TriMesh& mesh,
                                                            std::span<const std::uint8_t> suspect) {
  PROVEOUT_ASSERT(suspect.size() >= mesh.positions.size());
  std::vector<std::uint8_t> triangles(mesh.triangles.size());
  forEachBelow(triangles.size(), [&](std::size_t t) {
    const auto& v = mesh.triangles[t];
    triangles[t] = suspect[v[0]] | suspect[v[1]] | suspect[v[2]];
  });
  return findIntersectionsOf(mesh, triangles);
}

std::vector<std::array<std::uint32_t, 2>> findIntersectionsOf(const TriMesh& mesh,
                                                              std::span<const std::uint8_t> triangles) {
  PROVEOUT_ASSERT(triangles.size() == mesh.triangles.size());
  const auto isOne = [](std::uint8_t s) { return s != 0; };
  if (std::ranges::none_of(triangles, isOne)) return {};
  if (std::ranges::all_of(triangles, isOne)) triangles = {};
  return Finder(mesh, triangles).find();
}

std::vector<std::array<std::uint32_t, 2>> findIntersectionsAmong(const TriMesh& mesh,
                                                                 std::span<const std::uint32_t> triangles) {
  if (triangles.empty()) return {};
  PROVEOUT_ASSERT_DEAR(
      std::ranges::all_of(triangles, [&](std::uint32_t t) { return t < mesh.triangles.size(); }));
  return Finder(mesh, triangles).find();
}

std::vector<Box3> meetingPlaces(const TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                double reach) {
  std::vector<Box3> places;
  for (const auto& pair : pairs) {
    std::array<Box3, 2> box;
    for (std::size_t i = 0; i < 2; ++i) {
      for (const Vec3& corner : cornersOf(mesh, pair[i])) box[i].extend(corner);
    }
    places.push_back(Box3{box[0].min.cwiseMax(box[1].min), box[0].max.cwiseMin(box[1].max)}.inflated(reach));
  }
  return places;
}

void flagInside(const TriMesh& mesh, const std::vector<Box3>& boxes, std::vector<std::uint8_t>& flags) {
  PROVEOUT_ASSERT(flags.size() >= mesh.positions.size());
  forEachBelow(mesh.positions.size(), [&](std::size_t v) {
    const Vec3 p = mesh.positions[v].cast<double>();
    if (std::ranges::any_of(boxes, [&](const Box3& box) { return box.overlaps({p, p}); })) flags[v] = 1;
  });
}

}  // namespace proveout
