#include "removal/turning/section/revolve.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "core/geometry/to_float.h"

namespace proveout {

namespace {

/// Rings of a mesh have at least and at most so many corners.
constexpr int kFewest = 24, kMost = 4096;
/// A border between motions stays where what both of them made is longer than this, in tolerances; and no
/// more of them than these, those of the longest. Programs of many short lines would make as many rings.
constexpr double kRunLengths = 100.0;
constexpr std::size_t kMostBorders = 200;

/// Edges of a loop that one motion made in a row.
struct Run {
  std::size_t first;  ///< point that it begins at
  double length = 0.0;
};

std::vector<Run> runsOf(const SectionLoop& loop) {
  std::vector<Run> runs;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (runs.empty() || loop.motion[i] != loop.motion[i - 1]) runs.push_back({i});
    runs.back().length += (loop.points[(i + 1) % n] - loop.points[i]).norm();
  }
  if (runs.size() > 1 && loop.motion.front() == loop.motion.back()) {  // it goes on over the first point
    runs.back().length += runs.front().length;
    runs.erase(runs.begin());
  }
  return runs;
}

/// Points at which borders between motions stay, in no order.
std::vector<std::size_t> keptBorders(const SectionLoop& loop, double tolerance) {
  const std::vector<Run> runs = runsOf(loop);
  std::vector<std::pair<double, std::size_t>> borders;  // by the shorter of the runs that meet there
  for (std::size_t k = 0; k < runs.size() && runs.size() > 1; ++k) {
    const double shorter = std::min(runs[k].length, runs[(k + runs.size() - 1) % runs.size()].length);
    if (shorter > kRunLengths * tolerance) borders.emplace_back(shorter, runs[k].first);
  }
  std::sort(borders.begin(), borders.end(), std::greater<>());
  borders.resize(std::min(borders.size(), kMostBorders));
  std::vector<std::size_t> points;
  for (const auto& border : borders) points.push_back(border.second);
  return points;
}

/// Which motion made most of the edges from point `first` up to `last`, which may be beyond the end.
MotionId mainMotion(const SectionLoop& loop, std::size_t first, std::size_t last) {
  PROVEOUT_ASSERT(first < last && loop.motion.size() == loop.points.size());
  const std::size_t n = loop.points.size();
  std::map<MotionId, double> lengths;
  for (std::size_t i = first; i < last; ++i)
    lengths[loop.motion[i % n]] += (loop.points[(i + 1) % n] - loop.points[i % n]).norm();
  const auto shorter = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(lengths.begin(), lengths.end(), shorter)->first;
}

/// Marks what of points first..last has to stay, its ends being kept.
void keepFar(const std::vector<Vec2>& points, std::size_t first, std::size_t last, double tolerance,
             std::vector<char>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  const std::size_t n = points.size();
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = 0;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double d = distanceToSegment(points[i % n], points[a % n], points[b % n]);
      if (d <= worst) continue;
      worst = d;
      at = i;
    }
    if (at == 0) continue;
    keep[at % n] = 1;
    open.emplace_back(a, at);
    open.emplace_back(at, b);
  }
}

class Rings {
 public:
  Rings(TriMesh& mesh, int count) : mesh_(mesh), count_(count) {
    for (int j = 0; j < count; ++j) {
      const double angle = 2.0 * kPi * j / count;
      circle_.emplace_back(std::cos(angle), std::sin(angle));
    }
  }

  void add(const SectionLoop& loop) {
    std::vector<std::uint32_t> first;
    for (const Vec2& p : loop.points) first.push_back(ring(p));
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const std::size_t k = (i + 1) % loop.points.size();
      band(first[i], loop.points[i].x() <= 0.0, first[k], loop.points[k].x() <= 0.0, loop.motion[i]);
    }
  }

 private:
  std::uint32_t ring(const Vec2& p) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto z = toFloat(p.y());
    if (p.x() <= 0.0) {
      mesh_.positions.emplace_back(0.0f, 0.0f, z);
      return first;
    }
    for (const Vec2& c : circle_)
      mesh_.positions.emplace_back(toFloat(p.x() * c.x()), toFloat(p.x() * c.y()), z);
    return first;
  }

  void band(std::uint32_t a, bool a_on_axis, std::uint32_t b, bool b_on_axis, MotionId motion) {
    if (a_on_axis && b_on_axis) return;
    const auto n = static_cast<std::uint32_t>(count_);
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t k = (j + 1) % n;
      if (!a_on_axis) add(a + j, a + k, b_on_axis ? b : b + k, motion);
      if (!b_on_axis) add(a_on_axis ? a : a + j, b + k, b + j, motion);
    }
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, MotionId motion) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.motion.push_back(motion);
  }

  TriMesh& mesh_;
  int count_;
  std::vector<Vec2> circle_;
};

}  // namespace

std::vector<std::size_t> keptPoints(const SectionLoop& loop, double tolerance) {
  const std::size_t n = loop.points.size();
  PROVEOUT_ASSERT(n >= 3 && loop.motion.size() == n);
  std::vector<std::size_t> fixed = keptBorders(loop, tolerance);
  for (std::size_t i = 0; i < n; ++i) {
    if (loop.points[i].x() <= 0.0) fixed.push_back(i);
  }
  if (fixed.size() < 2) {  // hardly a border: its ends along Z stay
    const auto byHeight = [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); };
    const auto [low, high] = std::minmax_element(loop.points.begin(), loop.points.end(), byHeight);
    fixed.push_back(static_cast<std::size_t>(low - loop.points.begin()));
    fixed.push_back(static_cast<std::size_t>(high - loop.points.begin()));
  }
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  std::vector<char> keep(n, 0);
  for (std::size_t f = 0; f < fixed.size(); ++f) {
    keep[fixed[f]] = 1;
    const std::size_t next = f + 1 < fixed.size() ? fixed[f + 1] : fixed[0] + n;
    keepFar(loop.points, fixed[f], next, tolerance, keep);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < n; ++i) {
    if (keep[i]) kept.push_back(i);
  }
  if (kept.size() >= 3) return kept;
  kept.resize(n);
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  return kept;
}

SectionLoop simplified(const SectionLoop& loop, double tolerance) {
  return simplified(loop, keptPoints(loop, tolerance));
}

SectionLoop simplified(const SectionLoop& loop, const std::vector<std::size_t>& kept) {
  const std::size_t n = loop.points.size();
  PROVEOUT_ASSERT(kept.size() >= 3 && std::is_sorted(kept.begin(), kept.end()) && kept.back() < n);
  SectionLoop out;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    out.points.push_back(loop.points[kept[k]]);
    out.motion.push_back(mainMotion(loop, kept[k], k + 1 < kept.size() ? kept[k + 1] : kept[0] + n));
  }
  return out;
}

TriMesh revolved(const std::vector<SectionBody>& bodies, double tolerance) {
  double radius = 0.0;
  for (const SectionBody& body : bodies) {
    for (const Vec2& p : body.loops.front().points) radius = std::max(radius, p.x());
  }
  TriMesh mesh;
  if (!(radius > 0.0)) return mesh;
  Rings rings(mesh, std::clamp(circleSteps(radius, tolerance), kFewest, kMost));
  for (const SectionBody& body : bodies) {
    for (const SectionLoop& loop : body.loops) rings.add(simplified(loop, tolerance));
  }
  return mesh;
}

}  // namespace proveout
