#include "removal/surface/repair/open_steps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/mesh/intersections.h"
#include "core/mesh/vertex_fans.h"

namespace proveout {

namespace {

/// Triangles may turn by this much (60 degrees, cosine) from what they were.
constexpr float kLeastFacing = 0.5f;
/// Rounds in which steps at triangles that intersect are left closed, before all steps are.
constexpr std::uint8_t kOpenRounds = 20;

constexpr std::uint32_t kNoStep = ~std::uint32_t{0};

using Triangle = std::array<std::uint32_t, 3>;

std::size_t placeIn(const Triangle& t, std::uint32_t v) { return t[0] == v ? 0 : t[1] == v ? 1 : 2; }

class StepOpener {
 public:
  StepOpener(TriMesh& mesh, std::span<const StepVertex> steps)
      : mesh_(mesh),
        steps_(steps),
        vertices_(mesh.positions.size()),
        triangles_(mesh.triangles.size()),
        step_at_(stepsOfVertices()),
        near_(trianglesAt()),
        fans_(mesh, near_),
        plans_(steps.size()),
        left_out_(steps.size(), 0) {
    for (const std::uint32_t t : near_) {
      were_.push_back(mesh.triangles[t]);
      faced_.push_back(normalOf(were_.back()));
    }
    makePlans();
  }

  void run();

 private:
  /// How a vertex will be parted.
  struct Plan {
    bool open = false;
    std::vector<std::uint32_t> above;        ///< its triangles that are not of the wall's motion
    std::array<std::uint32_t, 2> ends = {};  ///< the neighbours between which these are
  };
  struct Edge {
    std::uint32_t a, b;  ///< a < b
    std::uint32_t motion;
    auto operator<=>(const Edge&) const = default;
  };

  std::vector<std::uint32_t> stepsOfVertices() const;
  std::vector<std::uint32_t> trianglesAt() const;
  void flipEdges();
  bool flipEdge(std::uint32_t t, std::size_t corner);
  bool makePlans();
  Plan plan(const StepVertex& step) const;
  bool tryAll();
  void open();
  void close();
  bool leftOutNow(const Triangle& t) const;
  bool leaveOutFolded();
  bool leaveOneOut(std::size_t k);
  std::vector<std::uint8_t> suspects() const;
  bool leaveOutMeeting();
  bool leaveOut(std::uint32_t vertex);
  void fill(const Edge& edge);
  Eigen::Vector3f normalOf(const Triangle& t) const {
    const Eigen::Vector3f &a = mesh_.positions[t[0]], &b = mesh_.positions[t[1]], &c = mesh_.positions[t[2]];
    return (b - a).cross(c - a).normalized();
  }
  /// Number in the list of steps; none where there is no step.
  std::optional<std::size_t> anyStepAt(std::uint32_t vertex) const {
    const std::uint32_t step = step_at_[vertex];
    return step == kNoStep ? std::nullopt : std::optional<std::size_t>(step);
  }
  /// None where it is left closed, too.
  std::optional<std::size_t> stepAt(std::uint32_t vertex) const {
    const std::optional<std::size_t> step = anyStepAt(vertex);
    return step && left_out_[*step] == 0 ? step : std::nullopt;
  }

  TriMesh& mesh_;
  std::span<const StepVertex> steps_;
  std::size_t vertices_, triangles_;    ///< before
  std::vector<std::uint32_t> step_at_;  ///< number in the list of steps of each vertex
  std::vector<std::uint32_t> near_;     ///< triangles at steps
  VertexFans fans_;                     ///< of these, before triangles are parted
  std::vector<Plan> plans_;
  std::vector<std::uint8_t> left_out_;      ///< the round that did so, or 0
  std::uint8_t round_ = 1;                  ///< the first is before any is opened
  std::uint8_t asked_ = 0;                  ///< the last in which it was asked what runs through others
  bool flipped_ = false;                    ///< edges are, in this round
  std::vector<Triangle> were_, parted_;     ///< those triangles, before, and before they are parted
  std::vector<Eigen::Vector3f> faced_;      ///< their normals
  std::vector<std::uint32_t> step_of_new_;  ///< of vertices that were added
};

std::vector<std::uint32_t> StepOpener::stepsOfVertices() const {
  std::vector<std::uint32_t> out(vertices_, kNoStep);
  for (std::size_t i = 0; i < steps_.size(); ++i) out[steps_[i].vertex] = static_cast<std::uint32_t>(i);
  return out;
}

std::vector<std::uint32_t> StepOpener::trianglesAt() const {
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < triangles_; ++t) {
    if (std::ranges::any_of(mesh_.triangles[t], [&](std::uint32_t v) { return step_at_[v] != kNoStep; }))
      out.push_back(t);
  }
  return out;
}

/// Flips the edge opposite to a corner, so that it joins the corner with the one beyond. False: that one is
/// another step, or of another motion, or they are joined already.
bool StepOpener::flipEdge(std::uint32_t t, std::size_t corner) {
  const Triangle v = mesh_.triangles[t];
  const std::uint32_t a = v[corner], b = v[(corner + 1) % 3], c = v[(corner + 2) % 3];
  for (const std::uint32_t beyond : fans_[b]) {
    const Triangle& w = mesh_.triangles[beyond];
    const std::size_t at = placeIn(w, b);
    if (w[(at + 2) % 3] != c) continue;
    const std::uint32_t d = w[(at + 1) % 3];
    if (mesh_.motion[beyond] != mesh_.motion[t] || stepAt(d)) return false;
    for (const std::uint32_t other : fans_[a]) {
      if (std::ranges::find(mesh_.triangles[other], d) != mesh_.triangles[other].end()) return false;
    }
    flipped_ = true;
    mesh_.triangles[t] = {a, b, d};
    mesh_.triangles[beyond] = {a, d, c};
    std::erase(fans_.change(b), beyond);
    std::erase(fans_.change(c), t);
    fans_.change(a).push_back(beyond);
    fans_.change(d).push_back(t);
    return true;
  }
  return false;
}

/// A triangle of three steps would become degenerate: one of its corners is joined with what is beyond the
/// opposite edge.
void StepOpener::flipEdges() {
  for (const std::uint32_t t : near_) {
    const Triangle v = mesh_.triangles[t];
    if (!stepAt(v[0]) || !stepAt(v[1]) || !stepAt(v[2])) continue;
    const auto across = [&](std::size_t i) {
      return (mesh_.positions[v[(i + 1) % 3]] - mesh_.positions[v[(i + 2) % 3]]).squaredNorm();
    };
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return across(i) > across(j); });
    for (const std::size_t corner : order) {
      if (flipEdge(t, corner)) break;
    }
  }
}

/// False: some step cannot be opened, and is left out.
bool StepOpener::makePlans() {
  bool all = true;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (left_out_[i] != 0) continue;
    plans_[i] = plan(steps_[i]);
    if (plans_[i].open) continue;
    left_out_[i] = round_;
    all = false;
  }
  return all;
}

/// A step can be opened where the triangles of the wall's motion form one run around the vertex, and the
/// others another.
StepOpener::Plan StepOpener::plan(const StepVertex& step) const {
  Plan out;
  const auto fan = fans_[step.vertex];
  // The triangle from each neighbour on.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> next;
  for (const std::uint32_t t : fan) {
    const Triangle& v = mesh_.triangles[t];
    next.emplace_back(v[(placeIn(v, step.vertex) + 1) % 3], t);
  }
  std::ranges::sort(next);
  const auto isAbove = [&](std::uint32_t t) { return mesh_.motion[t] != step.motion; };
  const auto following = [&](std::uint32_t t) {
    const Triangle& v = mesh_.triangles[t];
    const std::uint32_t end = v[(placeIn(v, step.vertex) + 2) % 3];
    const auto at = std::ranges::lower_bound(next, std::pair(end, 0u));
    return at != next.end() && at->first == end ? at->second : t;
  };
  std::uint32_t first = 0;
  int begins = 0;
  for (const std::uint32_t t : fan) {
    if (isAbove(t) || !isAbove(following(t))) continue;
    first = following(t);
    ++begins;
  }
  if (begins != 1) return out;
  const auto corner = [&](std::uint32_t t, std::size_t steps) {
    const Triangle& v = mesh_.triangles[t];
    return v[(placeIn(v, step.vertex) + steps) % 3];
  };
  std::uint32_t last = first;
  out.above.push_back(first);
  while (isAbove(following(last)) && out.above.size() < fan.size())
    out.above.push_back(last = following(last));
  out.ends = {corner(first, 1), corner(last, 2)};
  out.open = out.above.size() < fan.size() && out.ends[0] != out.ends[1];
  return out;
}

/// Sets the wall in along an edge whose two sides have parted.
void StepOpener::fill(const Edge& edge) {
  // The corner that stands for a vertex in one of the two triangles that had the edge.
  const auto now = [&](std::uint32_t t, std::uint32_t v) {
    const std::size_t at = static_cast<std::size_t>(std::ranges::lower_bound(near_, t) - near_.begin());
    return mesh_.triangles[t][placeIn(parted_[at], v)];
  };
  std::array<std::uint32_t, 2> sides{};  // the one that goes from a to b, and the one back
  for (const std::uint32_t t : fans_[edge.a]) {
    const std::size_t at = static_cast<std::size_t>(std::ranges::lower_bound(near_, t) - near_.begin());
    const Triangle& v = parted_[at];
    const std::size_t i = placeIn(v, edge.a);
    if (v[(i + 1) % 3] == edge.b) sides[0] = t;
    if (v[(i + 2) % 3] == edge.b) sides[1] = t;
  }
  const std::array<std::uint32_t, 4> ring = {now(sides[0], edge.b), now(sides[0], edge.a),
                                             now(sides[1], edge.a), now(sides[1], edge.b)};
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    mesh_.triangles.push_back({a, b, c});
    mesh_.motion.push_back(edge.motion);
  };
  const auto& p = mesh_.positions;
  if ((p[ring[0]] - p[ring[2]]).squaredNorm() <= (p[ring[1]] - p[ring[3]]).squaredNorm()) {
    add(ring[0], ring[1], ring[2]);
    add(ring[0], ring[2], ring[3]);
  } else {
    add(ring[0], ring[1], ring[3]);
    add(ring[1], ring[2], ring[3]);
  }
}

void StepOpener::open() {
  step_of_new_.clear();
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const StepVertex& step = steps_[i];
    if (left_out_[i] != 0) continue;
    const auto above = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(step.high);
    step_of_new_.push_back(static_cast<std::uint32_t>(i));
    mesh_.positions[step.vertex] = step.low;
    for (const std::uint32_t t : plans_[i].above)
      mesh_.triangles[t][placeIn(mesh_.triangles[t], step.vertex)] = above;
    for (const std::uint32_t end : plans_[i].ends)
      edges.push_back({std::min(end, step.vertex), std::max(end, step.vertex), step.motion});
  }
  std::ranges::sort(edges);
  const auto same = [](const Edge& x, const Edge& y) { return x.a == y.a && x.b == y.b; };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
  for (const Edge& edge : edges) fill(edge);
}

/// Restores the mesh as it was.
void StepOpener::close() {
  mesh_.positions.resize(vertices_);
  mesh_.triangles.resize(triangles_);
  mesh_.motion.resize(triangles_);
  for (std::size_t k = 0; k < near_.size(); ++k) mesh_.triangles[near_[k]] = were_[k];
  for (std::size_t i = 0; i < steps_.size(); ++i) mesh_.positions[steps_[i].vertex] = steps_[i].at;
  if (flipped_) fans_ = VertexFans(mesh_, near_);
  flipped_ = false;
}

/// False: there is no such step, or it is left out.
bool StepOpener::leaveOut(std::uint32_t vertex) {
  const std::uint32_t of = vertex < vertices_ ? vertex : steps_[step_of_new_[vertex - vertices_]].vertex;
  const std::optional<std::size_t> step = stepAt(of);
  if (step) left_out_[*step] = round_;
  return step.has_value();
}

/// Whether a corner of it will be closed in the next round: what else is wrong with it shows then.
bool StepOpener::leftOutNow(const Triangle& t) const {
  return std::ranges::any_of(t, [&](std::uint32_t v) {
    const std::optional<std::size_t> step = anyStepAt(v);
    return step && left_out_[*step] == round_;
  });
}

/// Leaves out the steps at triangles that the opening folds: one of them where that is enough. False: there
/// are no such triangles.
bool StepOpener::leaveOutFolded() {
  bool any = false;
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const Triangle& t = mesh_.triangles[near_[k]];
    if (leftOutNow(parted_[k]) || normalOf(t).dot(faced_[k]) > kLeastFacing) continue;
    if (leaveOneOut(k)) {
      any = true;
      continue;
    }
    for (const std::uint32_t v : t) any = leaveOut(v) || any;
  }
  return any;
}

/// The step without which the triangle would face as before.
bool StepOpener::leaveOneOut(std::size_t k) {
  const Triangle now = mesh_.triangles[near_[k]];
  std::array<Eigen::Vector3f, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = mesh_.positions[now[i]];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<std::size_t> step = stepAt(parted_[k][i]);
    if (!step) continue;
    const Eigen::Vector3f from = steps_[*step].at, u = p[(i + 1) % 3] - from, v = p[(i + 2) % 3] - from;
    if (u.cross(v).normalized().dot(faced_[k]) > kLeastFacing) return leaveOut(now[i]);
  }
  return false;
}

/// What may run through others: all at first, then what changed since that was asked.
std::vector<std::uint8_t> StepOpener::suspects() const {
  std::vector<std::uint8_t> out(mesh_.positions.size(), 0);
  if (asked_ == 0) {
    for (std::size_t i = 0; i < steps_.size(); ++i) out[steps_[i].vertex] = left_out_[i] == 0;
  } else {
    for (const Triangle& t : were_) {
      const bool changed = std::ranges::any_of(t, [&](std::uint32_t v) {
        const std::optional<std::size_t> step = anyStepAt(v);
        return step && left_out_[*step] >= asked_;
      });
      for (const std::uint32_t v : t) out[v] |= changed ? 1 : 0;
    }
  }
  for (std::size_t k = 0; k < step_of_new_.size(); ++k)
    out[vertices_ + k] = out[steps_[step_of_new_[k]].vertex];
  return out;
}

/// Leaves out the steps at triangles that run through others. False: there are none.
bool StepOpener::leaveOutMeeting() {
  const auto pairs = findIntersections(mesh_, suspects());
  asked_ = round_;
  bool any = false;
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) {
      for (const std::uint32_t v : mesh_.triangles[t]) any = leaveOut(v) || any;
    }
  }
  return any;
}

/// Opens all steps that are not left out. False: more of them must be left out.
bool StepOpener::tryAll() {
  flipEdges();
  if (!makePlans()) return false;
  for (std::size_t k = 0; k < near_.size(); ++k) parted_[k] = mesh_.triangles[near_[k]];
  open();
  return !leaveOutFolded() && !leaveOutMeeting();
}

void StepOpener::run() {
  parted_.resize(near_.size());
  while (++round_ <= kOpenRounds) {
    if (std::ranges::find(left_out_, 0) == left_out_.end() || tryAll()) return;
    close();
  }
}

}  // namespace

void openSteps(TriMesh& mesh, std::span<const StepVertex> steps, std::vector<std::uint8_t>& merged) {
  if (steps.empty()) return;
  StepOpener(mesh, steps).run();
  if (!merged.empty()) merged.resize(mesh.positions.size(), 0);
}

}  // namespace proveout
