#include "core/mesh/mesh_editor.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

namespace proveout {

namespace {

/// In place of the motion of a triangle, in meshes without.
constexpr std::uint32_t kUnmarked = 0;

bool contains(const std::array<std::uint32_t, 3>& corners, std::uint32_t v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
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

}  // namespace

std::uint32_t MeshEditor::following(std::uint32_t t, std::uint32_t v, std::size_t steps) const {
  const Triangle& corners = mesh_.triangles[t];
  const auto at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
  return corners[(at + steps) % 3];
}

std::optional<MeshWing> MeshEditor::wing(std::uint32_t a, std::uint32_t b) const {
  MeshWing w;
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
  if (!ab || !ba || w.c == w.d) return std::nullopt;
  return w;
}

bool MeshEditor::canFlip(const MeshWing& w) const {
  if (fans_[w.a].size() < 4 || fans_[w.b].size() < 4) return false;
  const auto at_c = fans_[w.c];
  return std::none_of(at_c.begin(), at_c.end(),
                      [&](std::uint32_t t) { return contains(mesh_.triangles[t], w.d); });
}

bool MeshEditor::canCollapse(const MeshWing& w) const {
  const auto at_a = fans_[w.a], at_b = fans_[w.b];
  if (at_a.size() + at_b.size() < 8 || fans_[w.c].size() < 4 || fans_[w.d].size() < 4) return false;
  const auto joinsBoth = [&](std::uint32_t t) {
    const std::uint32_t v = following(t, w.a, 1);
    return v != w.c && v != w.d && std::any_of(at_b.begin(), at_b.end(), [&](std::uint32_t u) {
             return v != w.b && contains(mesh_.triangles[u], v);
           });
  };
  return std::none_of(at_a.begin(), at_a.end(), joinsBoth);
}

void MeshEditor::save(std::uint32_t t) {
  const std::uint32_t motion = mesh_.motion.empty() ? kUnmarked : mesh_.motion[t];
  done_.push_back({Step::kTriangle, t, motion, 0, mesh_.triangles[t]});
}

void MeshEditor::leaveFan(std::uint32_t v, std::uint32_t t) {
  auto& fan = fans_.change(v);
  const auto at = std::find(fan.begin(), fan.end(), t);
  PROVEOUT_ASSERT(at != fan.end());
  done_.push_back({Step::kLeftFan, v, t, static_cast<std::uint32_t>(at - fan.begin())});
  fan.erase(at);
}

void MeshEditor::joinFan(std::uint32_t v, std::uint32_t t) {
  fans_.change(v).push_back(t);
  done_.push_back({Step::kJoinedFan, v});
}

void MeshEditor::replaceInFan(std::uint32_t v, std::uint32_t t, std::uint32_t by) {
  auto& fan = fans_.change(v);
  const auto at = std::find(fan.begin(), fan.end(), t);
  PROVEOUT_ASSERT(at != fan.end());
  done_.push_back({Step::kReplaced, v, t, static_cast<std::uint32_t>(at - fan.begin())});
  *at = by;
}

/// Gives triangles other corners.
void MeshEditor::reshape(std::span<const Shape> shapes) {
  const bool renewed = order_ == FanOrder::kRenewed;
  for (const auto& [t, corners] : shapes) {
    for (const std::uint32_t v : mesh_.triangles[t]) {
      if (renewed || !contains(corners, v)) leaveFan(v, t);
    }
  }
  for (const auto& [t, corners] : shapes) {
    if (corners[0] == kGone) continue;
    for (const std::uint32_t v : corners) {
      if (renewed || !contains(mesh_.triangles[t], v)) joinFan(v, t);
    }
  }
  for (const auto& [t, corners] : shapes) {
    save(t);
    mesh_.triangles[t] = corners;
  }
}

std::uint32_t MeshEditor::addTriangle(const Triangle& corners, std::uint32_t motion) {
  const auto t = static_cast<std::uint32_t>(mesh_.triangles.size());
  mesh_.triangles.push_back(corners);
  if (!mesh_.motion.empty()) mesh_.motion.push_back(motion);
  done_.push_back({Step::kNewTriangle, t});
  return t;
}

void MeshEditor::flip(const MeshWing& w) {
  std::array<Shape, 2> shapes{{{w.abc, {w.a, w.d, w.c}}, {w.bad, {w.d, w.b, w.c}}}};
  // Those that are renewed go to the end in the order that they have now.
  const auto at_a = fans_[w.a];
  if (*std::ranges::find_if(at_a, [&](std::uint32_t t) { return t == w.abc || t == w.bad; }) == w.bad)
    std::swap(shapes[0], shapes[1]);
  reshape(shapes);
}

std::uint32_t MeshEditor::split(const MeshWing& w, const Eigen::Vector3f& p) {
  const auto x = static_cast<std::uint32_t>(mesh_.positions.size());
  mesh_.positions.push_back(p);
  done_.push_back({Step::kNewVertex, x});
  save(w.abc);
  save(w.bad);
  mesh_.triangles[w.abc] = {w.a, x, w.c};
  mesh_.triangles[w.bad] = {w.b, x, w.d};
  const auto motionOf = [&](std::uint32_t t) { return mesh_.motion.empty() ? kUnmarked : mesh_.motion[t]; };
  const std::uint32_t xbc = addTriangle({x, w.b, w.c}, motionOf(w.abc)),
                      xad = addTriangle({x, w.a, w.d}, motionOf(w.bad));
  for (const std::uint32_t t : {w.abc, w.bad, xbc, xad}) joinFan(x, t);
  joinFan(w.c, xbc);
  joinFan(w.d, xad);
  replaceInFan(w.b, w.abc, xbc);
  replaceInFan(w.a, w.bad, xad);
  return x;
}

void MeshEditor::collapse(const MeshWing& w) {
  std::vector<Shape> shapes;
  for (const std::uint32_t t : fans_[w.a]) {
    Triangle corners = mesh_.triangles[t];
    if (contains(corners, w.b)) {
      corners.fill(kGone);
    } else {
      *std::find(corners.begin(), corners.end(), w.a) = w.b;
    }
    shapes.push_back({t, corners});
  }
  reshape(shapes);
}

void MeshEditor::move(std::uint32_t v, const Eigen::Vector3f& p) {
  done_.push_back({Step::kMoved, v, 0, 0, {}, mesh_.positions[v]});
  mesh_.positions[v] = p;
}

void MeshEditor::rotate(std::uint32_t t, int steps) {
  save(t);
  Triangle& corners = mesh_.triangles[t];
  std::rotate(corners.begin(), corners.begin() + steps, corners.end());
}

void MeshEditor::setMotion(std::uint32_t t, std::uint32_t motion) {
  PROVEOUT_ASSERT(t < mesh_.motion.size());
  save(t);
  mesh_.motion[t] = motion;
}

void MeshEditor::takeBack(const Step& step) {
  switch (step.kind) {
    case Step::kMoved:
      mesh_.positions[step.index] = step.p;
      break;
    case Step::kNewVertex:
      mesh_.positions.pop_back();
      break;
    case Step::kTriangle:
      mesh_.triangles[step.index] = step.corners;
      if (!mesh_.motion.empty()) mesh_.motion[step.index] = step.other;
      break;
    case Step::kNewTriangle:
      mesh_.triangles.pop_back();
      if (!mesh_.motion.empty()) mesh_.motion.pop_back();
      break;
    case Step::kLeftFan: {
      auto& fan = fans_.change(step.index);
      fan.insert(fan.begin() + step.place, step.other);
      break;
    }
    case Step::kJoinedFan:
      fans_.change(step.index).pop_back();
      break;
    case Step::kReplaced:
      fans_.change(step.index)[step.place] = step.other;
      break;
  }
}

void MeshEditor::takeBack(Mark mark) {
  PROVEOUT_ASSERT(mark <= done_.size());
  for (; done_.size() > mark; done_.pop_back()) takeBack(done_.back());
}

std::vector<std::uint8_t> MeshEditor::touched() const {
  std::vector<std::uint8_t> flags(mesh_.positions.size(), 0);
  for (const Step& step : done_) {
    if (step.kind == Step::kMoved || step.kind == Step::kNewVertex) flags[step.index] = 1;
    if (step.kind != Step::kTriangle || gone(step.index)) continue;
    for (const std::uint32_t v : mesh_.triangles[step.index]) flags[v] = 1;
  }
  return flags;
}

bool MeshEditor::isConsistent() const {
  std::size_t corners = 0, in_fans = 0;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) corners += gone(t) ? 0 : 3;
  for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) {
    const auto fan = fans_[v];
    in_fans += fan.size();
    for (std::size_t i = 0; i < fan.size(); ++i) {
      if (!contains(mesh_.triangles[fan[i]], v)) return false;
      if (std::find(fan.begin(), fan.begin() + static_cast<std::ptrdiff_t>(i), fan[i]) !=
          fan.begin() + static_cast<std::ptrdiff_t>(i))
        return false;
    }
  }
  return corners == in_fans;
}

void takeOut(TriMesh& mesh, LostParts lost) {
  constexpr std::size_t kPart = 8192;  // triangles that one task looks at
  std::sort(lost.triangles.begin(), lost.triangles.end());
  std::sort(lost.vertices.begin(), lost.vertices.end());
  PROVEOUT_ASSERT(lost.triangles.empty() || lost.triangles.back() < mesh.triangles.size());
  PROVEOUT_ASSERT(lost.vertices.empty() || lost.vertices.back() < mesh.positions.size());
  eraseAt(mesh.triangles, lost.triangles);
  if (!mesh.motion.empty()) eraseAt(mesh.motion, lost.triangles);
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

}  // namespace proveout
