#include "removal/surface/surface_sharpen.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/geometry/triangle.h"
#include "core/mesh/intersections.h"
#include "removal/grid/edge_root.h"
#include "removal/surface/cell_faces.h"
#include "removal/surface/vertex_fans.h"

namespace proveout {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// In cells: what counts as off the blank at least, and how exactly a new vertex is on it.
constexpr double kOff = 0.03, kOn = 1e-3;
/// Vertices at which the mesh turns by less than 6 degrees are not looked at.
constexpr float kFlatCos = 0.995f;
/// A change must make the worst of what it touches at least this much better.
constexpr double kBetter = 0.85;
/// In cells: how far from what is off a new place may be, and how near to a vertex.
constexpr double kReach = 2.0, kLeastLength = 0.04;
constexpr int kMeetRounds = 8, kTries = 4;
/// Rounds of changes; in the first of them edges and ridges count that the mesh misses, which may put other
/// parts of it off the blank until the next round.
constexpr int kRounds = 16, kSearchRounds = 12;
/// Triangles on a face of the blank, their middle within 0.01 cells, lean by 60 degrees from it and no more;
/// those that cut across an edge may stand upright on it. They are at least this high for their length.
constexpr double kOnFace = 0.01, kLeastFacing = 0.5, kLeastAcross = 0.0, kLeastHeight = 0.01;
/// Of the faults that are looked at: this many, and one for so many triangles. Grids too coarse for a part
/// have faults everywhere.
constexpr std::size_t kLeastFaults = 4000, kTrianglesPerFault = 20;
constexpr std::size_t kMostFaces = 8;
constexpr std::size_t kChunk = 4096;

/// Something off the blank: a vertex (b is the same) or an edge.
struct Fault {
  double off;
  std::uint32_t a, b;
};

/// A step that can be taken back.
struct Undo {
  std::uint32_t index;
  bool vertex;
  Eigen::Vector3f p = Eigen::Vector3f::Zero();
  Triangle t{};
  std::uint32_t motion;
};

/// As Crossing::face() numbers them.
void addFace(const BlankSample& s, std::vector<std::uint64_t>& faces) {
  const std::uint64_t face = static_cast<std::uint64_t>(s.motion) << 16 | static_cast<std::uint64_t>(s.face);
  if (faces.size() < kMostFaces && std::find(faces.begin(), faces.end(), face) == faces.end())
    faces.push_back(face);
}

class Sharpener {
 public:
  Sharpener(TriMesh& mesh, const BlankField& field, double h, double tolerance, Progress& progress)
      : mesh_(mesh),
        field_(field),
        progress_(progress),
        h_(h),
        limit_(std::max(kOff * h, tolerance)),
        fans_(mesh),
        vertices_(mesh.positions.size()),
        triangles_(mesh.triangles.size()),
        banned_(mesh.positions.size(), 0) {}

  void run();

 private:
  /// An edge ab and its two triangles.
  struct Wing {
    std::uint32_t a, b, c, d;  ///< triangles abc and bad
    std::uint32_t abc, bad;
  };
  /// What a change would leave: how far its parts are off; none if a triangle would be spoilt.
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
  /// How far the changes are.
  struct State {
    std::size_t steps, vertices, triangles, changed;
  };
  State state() const;
  void takeBack(const State& state);
  bool settle(const State& before);
  bool meetsAround(const std::vector<std::uint32_t>& triangles) const;

  void mendVertex(std::uint32_t v);
  void mendEdge(std::uint32_t a, std::uint32_t b);
  bool findWing(std::uint32_t a, std::uint32_t b, Wing& wing) const;
  bool anyBanned(std::span<const std::uint32_t> vertices) const;
  bool turnEdge(const Wing& w);
  Cost triangleCost(const Vec3& a, const Vec3& b, const Vec3& c) const;
  /// None as soon as it is above `limit`, too: what is asked of the blank takes most of the time.
  Cost splitCost(const Wing& w, const Vec3& x, double limit) const;
  Cost moveCost(std::uint32_t v, const Vec3& x, double limit = std::numeric_limits<double>::infinity()) const;
  double distanceTo(const std::vector<std::uint32_t>& triangles, const Vec3& p) const;
  double wingOff(const Wing& w) const;
  void split(const Wing& w, const Vec3& x);
  void move(std::uint32_t v, const Vec3& x);
  void setTriangle(std::uint32_t t, const Triangle& corners);

  std::vector<Vec3> placesNear(const Vec3& m, const std::vector<std::uint32_t>& patch) const;
  std::vector<std::uint64_t> facesOf(const std::vector<std::uint32_t>& triangles) const;
  bool meet(std::span<const std::uint64_t> faces, const Vec3& m, Vec3& x) const;
  Vec3 onWay(const Vec3& m, const Vec3& x) const;
  void addHidden(const Vec3& m, std::vector<std::uint64_t>& faces) const;

  TriMesh& mesh_;
  const BlankField& field_;
  Progress& progress_;
  double h_, limit_;  ///< mm: the grid spacing, and what counts as off the blank
  VertexFans fans_;
  std::size_t vertices_, triangles_;  ///< before any change
  std::vector<std::uint8_t> banned_;  ///< vertices around which nothing is changed
  std::vector<Undo> done_;
  std::vector<std::uint32_t> changed_;  ///< triangles, in this round
  std::size_t left_ = 0;                ///< faults that are still looked at
  bool searching_ = false;              ///< for parts of the blank that the mesh misses
};

/// Triangles whose corners all are where the mesh turns.
std::vector<std::uint32_t> Sharpener::bentTriangles() const {
  std::vector<Eigen::Vector3f> normal(triangles_);
  const auto chunks = [](std::size_t count, auto&& body) {
    parallelFor(std::size_t{0}, (count + kChunk - 1) / kChunk, [&](std::size_t c) {
      for (std::size_t i = c * kChunk; i < std::min(count, (c + 1) * kChunk); ++i) body(i);
    });
  };
  chunks(triangles_, [&](std::size_t t) {
    const Triangle& v = mesh_.triangles[t];
    const Eigen::Vector3f &a = mesh_.positions[v[0]], &b = mesh_.positions[v[1]], &c = mesh_.positions[v[2]];
    normal[t] = (b - a).cross(c - a).normalized();
  });
  std::vector<std::uint8_t> bent(vertices_, 0);
  chunks(vertices_, [&](std::size_t v) {
    const auto fan = fans_[static_cast<std::uint32_t>(v)];
    bent[v] = std::any_of(fan.begin(), fan.end(),
                          [&](std::uint32_t t) { return normal[t].dot(normal[fan.front()]) < kFlatCos; });
  });
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < triangles_; ++t) {
    const Triangle& v = mesh_.triangles[t];
    if (bent[v[0]] && bent[v[1]] && bent[v[2]]) out.push_back(t);
  }
  return out;
}

/// Each edge is looked at in one of its triangles, each vertex in its first.
void Sharpener::collect(std::uint32_t t, std::vector<Fault>& faults) const {
  const Triangle& v = mesh_.triangles[t];
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
    for (const std::uint32_t v : mesh_.triangles[t]) out.insert(out.end(), fans_[v].begin(), fans_[v].end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Edges that are not faults themselves. Beside what was changed a sharp ridge may stick out of the mesh
/// without any part of the mesh being off the blank.
void Sharpener::addEdges(const std::vector<std::uint32_t>& triangles, std::vector<Fault>& faults) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::uint32_t t : triangles) {
    const Triangle& v = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(v[i], v[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) faults.push_back({0.0, a, b});
}

void Sharpener::sharpen(std::vector<std::uint32_t> triangles) {
  for (int round = 0; round < kRounds && !triangles.empty(); ++round) {
    changed_.clear();
    std::vector<Fault> faults = findFaults(triangles);
    searching_ = round < kSearchRounds && 4 * faults.size() < left_;
    if (searching_ && round > 0) addEdges(triangles, faults);
    for (const Fault& f : faults) {
      if (progress_.cancelled() || left_-- == 0) return;
      if (f.a == f.b) {
        mendVertex(f.a);
      } else {
        mendEdge(f.a, f.b);
      }
    }
    triangles = around(changed_);
  }
}

bool Sharpener::anyBanned(std::span<const std::uint32_t> vertices) const {
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](std::uint32_t v) { return v < vertices_ && banned_[v] != 0; });
}

bool Sharpener::findWing(std::uint32_t a, std::uint32_t b, Wing& w) const {
  w.a = a;
  w.b = b;
  bool ab = false, ba = false;
  for (const std::uint32_t t : fans_[a]) {
    const Triangle& v = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      if (v[i] != a) continue;
      if (v[(i + 1) % 3] == b) {
        ab = true;
        w.abc = t;
        w.c = v[(i + 2) % 3];
      }
      if (v[(i + 2) % 3] == b) {
        ba = true;
        w.bad = t;
        w.d = v[(i + 1) % 3];
      }
    }
  }
  const std::array<std::uint32_t, 4> all{w.a, w.b, w.c, w.d};
  return ab && ba && w.c != w.d && !anyBanned(all);
}

/// Of its middle; none if it is a sliver or does not face as the blank does.
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
  for (const std::uint32_t t : fans_[v]) {
    const Triangle& c = mesh_.triangles[t];
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

void Sharpener::setTriangle(std::uint32_t t, const Triangle& corners) {
  if (t == mesh_.triangles.size()) {
    mesh_.triangles.push_back(corners);
    mesh_.motion.push_back(kNoMotion);
  } else {
    done_.push_back({t, false, Eigen::Vector3f::Zero(), mesh_.triangles[t], mesh_.motion[t]});
    mesh_.triangles[t] = corners;
  }
  mesh_.motion[t] = field_.sample((at(corners[0]) + at(corners[1]) + at(corners[2])) / 3.0).motion;
  changed_.push_back(t);
}

void Sharpener::split(const Wing& w, const Vec3& p) {
  const auto x = static_cast<std::uint32_t>(mesh_.positions.size());
  mesh_.positions.push_back(p.cast<float>());
  const auto xbc = static_cast<std::uint32_t>(mesh_.triangles.size()), xad = xbc + 1;
  setTriangle(w.abc, {w.a, x, w.c});
  setTriangle(w.bad, {w.b, x, w.d});
  setTriangle(xbc, {x, w.b, w.c});
  setTriangle(xad, {x, w.a, w.d});
  fans_.change(x) = {w.abc, w.bad, xbc, xad};
  fans_.change(w.c).push_back(xbc);
  fans_.change(w.d).push_back(xad);
  std::replace(fans_.change(w.b).begin(), fans_.change(w.b).end(), w.abc, xbc);
  std::replace(fans_.change(w.a).begin(), fans_.change(w.a).end(), w.bad, xad);
}

void Sharpener::move(std::uint32_t v, const Vec3& x) {
  done_.push_back({v, true, mesh_.positions[v], {}, 0});
  mesh_.positions[v] = x.cast<float>();
  for (const std::uint32_t t : fans_[v]) setTriangle(t, mesh_.triangles[t]);
}

/// Joins c and d in place of a and b where that follows the blank better.
bool Sharpener::turnEdge(const Wing& w) {
  const auto meets = [&](std::uint32_t t) {
    const Triangle& v = mesh_.triangles[t];
    return v[0] == w.d || v[1] == w.d || v[2] == w.d;
  };
  if (std::any_of(fans_[w.c].begin(), fans_[w.c].end(), meets)) return false;
  if (fans_[w.a].size() < 4 || fans_[w.b].size() < 4) return false;
  const Cost at_a = triangleCost(at(w.a), at(w.d), at(w.c)), at_b = triangleCost(at(w.b), at(w.c), at(w.d));
  if (!at_a || !at_b) return false;
  const double after = std::max({*at_a, *at_b, off(middle(w.c, w.d))});
  if (after > kBetter * wingOff(w)) return false;
  const State now = state();
  setTriangle(w.abc, {w.a, w.d, w.c});
  setTriangle(w.bad, {w.b, w.c, w.d});
  std::erase(fans_.change(w.a), w.bad);
  std::erase(fans_.change(w.b), w.abc);
  fans_.change(w.d).push_back(w.abc);
  fans_.change(w.c).push_back(w.bad);
  return settle(now);
}

void Sharpener::mendVertex(std::uint32_t v) {
  const std::array<std::uint32_t, 1> all{v};
  if (anyBanned(all)) return;
  const Cost before = moveCost(v, at(v));
  double least = before ? kBetter * *before : h_;
  Vec3 best = at(v);
  for (const Vec3& x : placesNear(at(v), {fans_[v].begin(), fans_[v].end()})) {
    const Cost cost = moveCost(v, x, least);
    if (!cost || *cost >= least) continue;
    least = *cost;
    best = x;
  }
  const State now = state();
  if (best == at(v)) return;
  move(v, best);
  settle(now);
}

/// The best of moving an end to a point of the blank and of splitting the edge there. Points that the mesh
/// misses count for as much as what is off the blank.
void Sharpener::mendEdge(std::uint32_t a, std::uint32_t b) {
  Wing w{};
  if (!findWing(a, b, w)) return;
  const double before = wingOff(w);
  const bool is_off = before > limit_;
  if ((!is_off && !searching_) || (is_off && turnEdge(w))) return;
  const std::array<std::uint32_t, 2> ends{a, b};
  std::array<double, 3> off_before{0.0, 0.0, before};
  for (std::size_t i = 0; i < 2; ++i) off_before[i] = moveCost(ends[i], at(ends[i])).value_or(before);
  const std::vector<std::uint32_t> patch = around({w.abc, w.bad});
  double most = 0.0;
  std::size_t which = 3;
  Vec3 best = at(a);
  for (const Vec3& x : placesNear(middle(a, b), patch)) {
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
  const State now = state();
  if (which == 2) split(w, best);
  if (which < 2) move(ends[which], best);
  settle(now);
}

/// The blank's faces at these triangles.
std::vector<std::uint64_t> Sharpener::facesOf(const std::vector<std::uint32_t>& triangles) const {
  std::vector<std::uint64_t> faces;
  for (const std::uint32_t t : triangles) {
    const Triangle& c = mesh_.triangles[t];
    addFace(field_.sample((at(c[0]) + at(c[1]) + at(c[2])) / 3.0), faces);
  }
  return faces;
}

/// Where faces meet near `m`, by Newton's method, on the blank's surface or not. False: not near.
bool Sharpener::meet(std::span<const std::uint64_t> faces, const Vec3& m, Vec3& x) const {
  x = m;
  std::array<Plane, 3> planes;
  for (int round = 0; round < kMeetRounds; ++round) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto foot = field_.facePoint(faces[i], x, 3.0 * h_);
      if (!foot) return false;
      planes[i] = {foot->normal, foot->normal.dot(foot->p - x)};
    }
    const Vec3 step = meetPlanes({planes.data(), faces.size()});
    x += step;
    if (!((x - m).norm() < kReach * h_)) return false;
    if (step.norm() < 1e-2 * kOn * h_) break;
  }
  return true;
}

/// The point on the way from `m` to `x` where the blank ends or begins; `x` if both are on one side.
Vec3 Sharpener::onWay(const Vec3& m, const Vec3& x) const {
  const auto value = [&](double s) { return field_.value(m + s * (x - m)); };
  const double at_m = value(0.0), at_x = value(1.0);
  if ((at_m < 0.0) == (at_x < 0.0)) return x;
  const double at =
      at_m < 0.0 ? edgeRoot(value, 1.0, at_x, 0.0, at_m, kOn) : edgeRoot(value, 0.0, at_m, 1.0, at_x, kOn);
  return m + at * (x - m);
}

/// Faces that cut off the edges of those which are known: too narrow to have triangles.
void Sharpener::addHidden(const Vec3& m, std::vector<std::uint64_t>& faces) const {
  for (std::size_t i = 1; i < faces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 x;
      if (!meet(std::array{faces[i], faces[j]}, m, x)) continue;
      if (off(x) >= kOn * h_) addFace(field_.sample(onWay(m, x)), faces);
    }
  }
}

/// Points of the blank near `m`: on its faces, their edges and corners.
std::vector<Vec3> Sharpener::placesNear(const Vec3& m, const std::vector<std::uint32_t>& patch) const {
  std::vector<std::uint64_t> faces = facesOf(patch);
  addHidden(m, faces);
  std::vector<Vec3> out;
  const auto add = [&](std::span<const std::uint64_t> some) {
    Vec3 x;
    if (meet(some, m, x) && off(x) < kOn * h_) out.push_back(x);
  };
  for (std::size_t i = 0; i < faces.size(); ++i) {
    add(std::array{faces[i]});
    for (std::size_t j = 0; j < i; ++j) {
      add(std::array{faces[i], faces[j]});
      for (std::size_t k = 0; k < j; ++k) add(std::array{faces[i], faces[j], faces[k]});
    }
  }
  return out;
}

Sharpener::State Sharpener::state() const {
  return {done_.size(), mesh_.positions.size(), mesh_.triangles.size(), changed_.size()};
}

void Sharpener::takeBack(const State& state) {
  for (; done_.size() > state.steps; done_.pop_back()) {
    const Undo& undo = done_.back();
    if (undo.vertex) {
      mesh_.positions[undo.index] = undo.p;
    } else {
      mesh_.triangles[undo.index] = undo.t;
      mesh_.motion[undo.index] = undo.motion;
    }
  }
  mesh_.positions.resize(state.vertices);
  mesh_.triangles.resize(state.triangles);
  mesh_.motion.resize(state.triangles);
  changed_.resize(state.changed);
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

/// Keeps what was changed since `before`, or takes it back where triangles meet.
bool Sharpener::settle(const State& before) {
  const std::vector<std::uint32_t> made(changed_.begin() + static_cast<std::ptrdiff_t>(before.changed),
                                        changed_.end());
  const bool sound = !meetsAround(made);
  if (sound) {
    fans_.keep();
  } else {
    fans_.takeBack();
    takeBack(before);
  }
  return sound;
}

/// False if no triangles meet that should not.
bool Sharpener::banMeeting() {
  std::vector<std::uint8_t> suspect(mesh_.positions.size(), 0);
  for (std::size_t v = vertices_; v < suspect.size(); ++v) suspect[v] = 1;
  for (const Undo& undo : done_) {
    if (undo.vertex) suspect[undo.index] = 1;
    if (undo.vertex) continue;
    for (const std::uint32_t v : mesh_.triangles[undo.index]) suspect[v] = 1;
  }
  const auto pairs = findIntersections(mesh_, suspect);
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
  const State before = state();
  for (int attempt = 0; attempt < kTries; ++attempt) {
    left_ = kLeastFaults + triangles_ / kTrianglesPerFault;
    sharpen(triangles);
    if (done_.empty() || progress_.cancelled() || !banMeeting()) return;
    changed_.clear();
    takeBack(before);
    fans_.reset();
  }
}

}  // namespace

void sharpenMesh(TriMesh& mesh, const BlankField& field, double cell_mm, double tolerance_mm,
                 Progress& progress) {
  Sharpener(mesh, field, cell_mm, tolerance_mm, progress).run();
}

}  // namespace proveout
