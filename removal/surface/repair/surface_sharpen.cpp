#include "removal/surface/repair/surface_sharpen.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "core/geometry/triangle.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mesh_editor.h"
#include "removal/surface/cell/blank_features.h"

namespace proveout {

namespace {

constexpr double kOff = 0.03;  ///< in cells: what counts as off the blank at least
/// Vertices at which the mesh turns by less than 6 degrees (cosine) are skipped.
constexpr float kFlatCos = 0.995f;
/// A change must make the worst of what it touches at least this much better.
constexpr double kBetter = 0.85;
constexpr double kLeastLength = 0.04;  ///< in cells: how near to a vertex a new place may be
constexpr int kTries = 4;
/// Rounds of changes. In the first of them feature edges and ridges that the mesh misses count as well;
/// adding them may put other parts of the mesh off the blank until the next round.
constexpr int kChangeRounds = 16, kSearchRounds = 12;
/// Triangles on a face of the blank (their middle within 0.01 cells) lean from it by 60 degrees at most;
/// those that cut across a feature edge may be at right angles to it. Least height of a triangle, as a share
/// of its length.
constexpr double kOnFace = 0.01, kLeastFacing = 0.5, kLeastAcross = 0.0, kLeastHeight = 0.01;
/// How many faults are looked at: this many, and one more for every so many triangles. Grids too coarse for
/// a part have faults everywhere.
constexpr std::size_t kLeastFaults = 4000, kTrianglesPerFault = 20;
constexpr std::size_t kChunk = 4096;

/// Something off the blank: a vertex (b is the same) or an edge.
struct Fault {
  double off;
  std::uint32_t a, b;
};

class Sharpener {
 public:
  Sharpener(TriMesh& mesh, const BlankField& field, double h, double tolerance, Progress& progress)
      : mesh_(mesh),
        field_(field),
        progress_(progress),
        h_(h),
        limit_(std::max(kOff * h, tolerance)),
        edit_(mesh, MeshEditor::FanOrder::kKept),
        features_(mesh, field, h),
        vertices_(mesh.positions.size()),
        triangles_(mesh.triangles.size()),
        banned_(mesh.positions.size(), 0) {}

  void run();

 private:
  using Wing = MeshWing;
  /// How far the parts of a change would be off the blank (mm); none if it would spoil a triangle.
  using Cost = std::optional<double>;

  Vec3 at(std::uint32_t v) const { return mesh_.positions[v].cast<double>(); }
  double off(const Vec3& p) const { return std::abs(field_.value(p)); }
  Vec3 middle(std::uint32_t a, std::uint32_t b) const { return 0.5 * (at(a) + at(b)); }

  std::vector<std::uint32_t> bentTriangles() const;
  void collect(std::uint32_t t, std::vector<Fault>& faults) const;
  std::vector<Fault> findFaults(const std::vector<std::uint32_t>& triangles) const;
  std::vector<std::uint32_t> around(const std::vector<std::uint32_t>& triangles) const;
  void addEdges(const std::vector<std::uint32_t>& triangles, std::vector<Fault>& faults) const;
  void sharpen(std::vector<std::uint32_t> triangles);
  bool banMeeting();
  bool settle(MeshEditor::Mark before);
  bool meetsAround(const std::vector<std::uint32_t>& triangles) const;

  void snapVertex(std::uint32_t v);
  void repairEdge(std::uint32_t a, std::uint32_t b);
  bool anyBanned(std::span<const std::uint32_t> vertices) const;
  bool flipEdge(const Wing& w);
  Cost triangleCost(const Vec3& a, const Vec3& b, const Vec3& c) const;
  /// None as well as soon as it is above `limit`: asking the blank takes most of the time.
  Cost splitCost(const Wing& w, const Vec3& x, double limit) const;
  Cost moveCost(std::uint32_t v, const Vec3& x, double limit = std::numeric_limits<double>::infinity()) const;
  double distanceTo(const std::vector<std::uint32_t>& triangles, const Vec3& p) const;
  double wingOff(const Wing& w) const;
  void split(const Wing& w, const Vec3& x);
  void move(std::uint32_t v, const Vec3& x);
  void noteChange(std::uint32_t t);

  const TriMesh& mesh_;
  const BlankField& field_;
  Progress& progress_;
  double h_, limit_;  ///< mm: the grid spacing, and what counts as off the blank
  MeshEditor edit_;
  BlankFeatures features_;
  std::size_t vertices_, triangles_;    ///< before any change
  std::vector<std::uint8_t> banned_;    ///< vertices around which nothing is changed
  std::vector<std::uint32_t> changed_;  ///< triangles, in this round
  std::size_t settled_ = 0;             ///< of them: those that stay
  std::size_t left_ = 0;                ///< faults that are still looked at
  bool searching_ = false;              ///< for parts of the blank that the mesh misses
};

/// Triangles all of whose corners are where the mesh turns.
std::vector<std::uint32_t> Sharpener::bentTriangles() const {
  std::vector<Eigen::Vector3f> normal(triangles_);
  const auto chunks = [](std::size_t count, auto&& body) {
    parallelFor(std::size_t{0}, (count + kChunk - 1) / kChunk, [&](std::size_t c) {
      for (std::size_t i = c * kChunk; i < std::min(count, (c + 1) * kChunk); ++i) body(i);
    });
  };
  chunks(triangles_, [&](std::size_t t) {
    const auto& v = mesh_.triangles[t];
    const Eigen::Vector3f &a = mesh_.positions[v[0]], &b = mesh_.positions[v[1]], &c = mesh_.positions[v[2]];
    normal[t] = (b - a).cross(c - a).normalized();
  });
  std::vector<std::uint8_t> bent(vertices_, 0);
  chunks(vertices_, [&](std::size_t v) {
    const auto fan = edit_.fan(static_cast<std::uint32_t>(v));
    bent[v] = std::any_of(fan.begin(), fan.end(),
                          [&](std::uint32_t t) { return normal[t].dot(normal[fan.front()]) < kFlatCos; });
  });
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < triangles_; ++t) {
    const auto& v = mesh_.triangles[t];
    if (bent[v[0]] && bent[v[1]] && bent[v[2]]) out.push_back(t);
  }
  return out;
}

/// Adds the faults at a triangle.
void Sharpener::collect(std::uint32_t t, std::vector<Fault>& faults) const {
  const auto& v = mesh_.triangles[t];
  const double center = off((at(v[0]) + at(v[1]) + at(v[2])) / 3.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = v[i], b = v[(i + 1) % 3];
    const double vertex = off(at(a)), edge = off(middle(a, b));
    if (vertex > limit_) faults.push_back({vertex, a, a});
    if (std::max(edge, center) > limit_)
      faults.push_back({std::max(edge, center), std::min(a, b), std::max(a, b)});
  }
}

/// The worst first.
std::vector<Fault> Sharpener::findFaults(const std::vector<std::uint32_t>& triangles) const {
  std::vector<std::vector<Fault>> parts((triangles.size() + kChunk - 1) / kChunk);
  parallelFor(std::size_t{0}, parts.size(), [&](std::size_t c) {
    for (std::size_t i = c * kChunk; i < std::min(triangles.size(), (c + 1) * kChunk); ++i)
      collect(triangles[i], parts[c]);
  });
  std::vector<Fault> faults;
  for (const auto& part : parts) faults.insert(faults.end(), part.begin(), part.end());
  std::sort(faults.begin(), faults.end(), [](const Fault& x, const Fault& y) {
    return x.off != y.off ? x.off > y.off : std::pair(x.a, x.b) < std::pair(y.a, y.b);
  });
  return faults;
}

std::vector<std::uint32_t> Sharpener::around(const std::vector<std::uint32_t>& triangles) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : triangles) {
    for (const std::uint32_t v : mesh_.triangles[t]) {
      const auto fan = edit_.fan(v);
      out.insert(out.end(), fan.begin(), fan.end());
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Adds edges that are not faults themselves: beside a change the blank may have a sharp ridge outside the
/// mesh although no part of the mesh is off the blank.
void Sharpener::addEdges(const std::vector<std::uint32_t>& triangles, std::vector<Fault>& faults) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::uint32_t t : triangles) {
    const auto& v = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(v[i], v[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) faults.push_back({0.0, a, b});
}

void Sharpener::sharpen(std::vector<std::uint32_t> triangles) {
  for (int round = 0; round < kChangeRounds && !triangles.empty(); ++round) {
    changed_.clear();
    settled_ = 0;
    std::vector<Fault> faults = findFaults(triangles);
    searching_ = round < kSearchRounds && 4 * faults.size() < left_;
    if (searching_ && round > 0) addEdges(triangles, faults);
    for (const Fault& f : faults) {
      if (progress_.cancelled() || left_-- == 0) return;
      if (f.a == f.b) {
        snapVertex(f.a);
      } else {
        repairEdge(f.a, f.b);
      }
    }
    triangles = around(changed_);
  }
}

bool Sharpener::anyBanned(std::span<const std::uint32_t> vertices) const {
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](std::uint32_t v) { return v < vertices_ && banned_[v] != 0; });
}

/// How far the middle of a triangle is off; none if it is a sliver or does not face as the blank does.
Sharpener::Cost Sharpener::triangleCost(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const Vec3 area = (b - a).cross(c - a);
  const double size = area.norm(),
               length2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (!(size > kLeastHeight * length2)) return std::nullopt;
  const BlankSample s = field_.sample((a + b + c) / 3.0);
  const double off = std::abs(s.value);
  if (s.normal.dot(area) < (off < kOnFace * h_ ? kLeastFacing : kLeastAcross) * size) return std::nullopt;
  return off;
}

double Sharpener::distanceTo(const std::vector<std::uint32_t>& triangles, const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : triangles) least = std::min(least, squaredDistance(p, cornersOf(mesh_, t)));
  return std::sqrt(least);
}

double Sharpener::wingOff(const Wing& w) const {
  const Vec3 ends = at(w.a) + at(w.b);
  return std::max({off(0.5 * ends), off((ends + at(w.c)) / 3.0), off((ends + at(w.d)) / 3.0)});
}

Sharpener::Cost Sharpener::splitCost(const Wing& w, const Vec3& x, double limit) const {
  const std::array<Vec3, 4> ring{at(w.a), at(w.d), at(w.b), at(w.c)};
  double most = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((ring[i] - x).squaredNorm() < kLeastLength * kLeastLength * h_ * h_) return std::nullopt;
    const Cost cost = triangleCost(ring[i], ring[(i + 1) % 4], x);
    if (!cost) return std::nullopt;
    most = std::max({most, *cost, off(0.5 * (ring[i] + x))});
    if (most > limit) return std::nullopt;
  }
  return most;
}

Sharpener::Cost Sharpener::moveCost(std::uint32_t v, const Vec3& x, double limit) const {
  double most = off(x);
  for (const std::uint32_t t : edit_.fan(v)) {
    const auto& c = mesh_.triangles[t];
    const std::size_t i = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    const Vec3 b = at(c[(i + 1) % 3]), d = at(c[(i + 2) % 3]);
    if ((b - x).squaredNorm() < kLeastLength * kLeastLength * h_ * h_) return std::nullopt;
    const Cost cost = triangleCost(x, b, d);
    if (!cost) return std::nullopt;
    most = std::max({most, *cost, off(0.5 * (x + b))});
    if (most > limit) return std::nullopt;
  }
  return most;
}

/// To be called for each triangle that is new or has other corners or a corner elsewhere.
void Sharpener::noteChange(std::uint32_t t) {
  const auto& v = mesh_.triangles[t];
  edit_.setMotion(t, field_.sample((at(v[0]) + at(v[1]) + at(v[2])) / 3.0).motion);
  changed_.push_back(t);
}

void Sharpener::split(const Wing& w, const Vec3& p) {
  const auto added = static_cast<std::uint32_t>(mesh_.triangles.size());
  edit_.split(w, toFloat(p));
  for (const std::uint32_t t : {w.abc, w.bad, added, added + 1}) noteChange(t);
}

void Sharpener::move(std::uint32_t v, const Vec3& x) {
  edit_.move(v, toFloat(x));
  for (const std::uint32_t t : edit_.fan(v)) noteChange(t);
}

/// Flips the edge from a and b to c and d where that follows the blank better.
bool Sharpener::flipEdge(const Wing& w) {
  if (!edit_.canFlip(w)) return false;
  const Cost at_a = triangleCost(at(w.a), at(w.d), at(w.c)), at_b = triangleCost(at(w.b), at(w.c), at(w.d));
  if (!at_a || !at_b) return false;
  const double after = std::max({*at_a, *at_b, off(middle(w.c, w.d))});
  if (after > kBetter * wingOff(w)) return false;
  const MeshEditor::Mark now = edit_.mark();
  edit_.flip(w);
  edit_.rotate(w.bad, 1);  // b first, as the middle is summed up from there
  noteChange(w.abc);
  noteChange(w.bad);
  return settle(now);
}

void Sharpener::snapVertex(std::uint32_t v) {
  const std::array<std::uint32_t, 1> all{v};
  if (anyBanned(all)) return;
  const Cost before = moveCost(v, at(v));
  double least = before ? kBetter * *before : h_;
  Vec3 best = at(v);
  for (const Vec3& x : features_.near(at(v), edit_.fan(v))) {
    const Cost cost = moveCost(v, x, least);
    if (!cost || *cost >= least) continue;
    least = *cost;
    best = x;
  }
  if (best == at(v)) return;
  const MeshEditor::Mark now = edit_.mark();
  move(v, best);
  settle(now);
}

/// Repairs an edge by the better of moving an end to a point of the blank and splitting the edge there.
/// Points of the blank that the mesh misses count as much as parts of the mesh that are off it.
void Sharpener::repairEdge(std::uint32_t a, std::uint32_t b) {
  const auto wing = edit_.wing(a, b);
  if (!wing || anyBanned(std::array{wing->a, wing->b, wing->c, wing->d})) return;
  const Wing& w = *wing;
  const double before = wingOff(w);
  const bool is_off = before > limit_;
  if ((!is_off && !searching_) || (is_off && flipEdge(w))) return;
  const std::array<std::uint32_t, 2> ends{a, b};
  std::array<double, 3> off_before{0.0, 0.0, before};
  for (std::size_t i = 0; i < 2; ++i) off_before[i] = moveCost(ends[i], at(ends[i])).value_or(before);
  const std::vector<std::uint32_t> patch = around({w.abc, w.bad});
  double most = 0.0;
  std::size_t which = 3;
  Vec3 best = at(a);
  for (const Vec3& x : features_.near(middle(a, b), patch)) {
    const double missed = searching_ ? distanceTo(patch, x) : 0.0;
    if (!is_off && missed <= limit_) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double worst = std::max(missed, off_before[i]), limit = std::min(kBetter * worst, worst - most);
      const Cost cost = i < 2 ? moveCost(ends[i], x, limit) : splitCost(w, x, limit);
      if (!cost || *cost > kBetter * worst || worst - *cost <= most) continue;
      most = worst - *cost;
      which = i;
      best = x;
    }
  }
  if (which == 3) return;
  const MeshEditor::Mark now = edit_.mark();
  if (which == 2) split(w, best);
  if (which < 2) move(ends[which], best);
  settle(now);
}

/// Whether these triangles run through others nearby.
bool Sharpener::meetsAround(const std::vector<std::uint32_t>& triangles) const {
  const std::vector<std::uint32_t> near = around(around(triangles));
  return std::any_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t other) {
      return other != t && trianglesMeet(mesh_, std::min(t, other), std::max(t, other));
    });
  });
}

/// Keeps what was changed since `before`, or takes it back where triangles intersect.
bool Sharpener::settle(MeshEditor::Mark before) {
  const std::vector<std::uint32_t> made(changed_.begin() + static_cast<std::ptrdiff_t>(settled_),
                                        changed_.end());
  const bool sound = !meetsAround(made);
  if (!sound) {
    edit_.takeBack(before);
    changed_.resize(settled_);
  }
  settled_ = changed_.size();
  return sound;
}

/// Bans the vertices of triangles that intersect. False if there are none.
bool Sharpener::banMeeting() {
  const auto pairs = findIntersections(mesh_, edit_.touched());
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        if (v < vertices_) banned_[v] = 1;
      }
    }
  }
  return !pairs.empty();
}

void Sharpener::run() {
  const std::vector<std::uint32_t> triangles = bentTriangles();
  const MeshEditor::Mark before = edit_.mark();
  for (int attempt = 0; attempt < kTries; ++attempt) {
    left_ = kLeastFaults + triangles_ / kTrianglesPerFault;
    sharpen(triangles);
    if (edit_.mark() == before || progress_.cancelled() || !banMeeting()) return;
    edit_.takeBack(before);
  }
}

}  // namespace

void sharpenMesh(TriMesh& mesh, const BlankField& field, double cell_mm, double tolerance_mm,
                 Progress& progress) {
  Sharpener(mesh, field, cell_mm, tolerance_mm, progress).run();
}

}  // namespace proveout
