#include "io/report/half_section.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/geometry/plane.h"

namespace proveout {
namespace {

constexpr double kOnAxisMm = 1e-6;
/// Deviations that differ by less are the same: meshes have coordinates of single precision.
constexpr double kSameMm = 1e-5;
/// Profiles with more edges are sampled evenly: each edge would take two samples.
constexpr std::size_t kMaxEdgesWithCorners = kMaxProfileSamples / 3;

/// A vertex in the plane counts as in front of it, so that a triangle crosses the plane with two edges or
/// none.
bool inFront(const Eigen::Vector3f& p) { return p.y() >= 0.0F; }

/// Where the edge crosses y = 0, as (x, z). The same for both directions, so that neighbours meet bit for
/// bit.
Vec2 crossing(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const bool swapped = !inFront(a);
  const Vec3 p = (swapped ? b : a).cast<double>(), q = (swapped ? a : b).cast<double>();
  const double t = p.y() / (p.y() - q.y());
  return {p.x() + t * (q.x() - p.x()), p.z() + t * (q.z() - p.z())};
}

using EdgeKey = std::uint64_t;
EdgeKey edgeKey(std::uint32_t a, std::uint32_t b) {
  return static_cast<EdgeKey>(std::min(a, b)) << 32 | std::max(a, b);
}

bool usable(const TriMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) {
    return v < mesh.positions.size() && mesh.positions[v].allFinite();
  });
}

/// Calls found(edge, edge, point, point) for each triangle that crosses the plane, from the edge where its
/// outline enters the front to the one where it leaves.
template <typename Found>
void forEachCut(const TriMesh& mesh, const Found& found) {
  for (const auto& triangle : mesh.triangles) {
    if (!usable(mesh, triangle)) continue;
    std::optional<std::size_t> enters, leaves;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool from = inFront(mesh.positions[triangle[i]]),
                 to = inFront(mesh.positions[triangle[(i + 1) % 3]]);
      if (!from && to) enters = i;
      if (from && !to) leaves = i;
    }
    if (!enters || !leaves) continue;
    const auto key = [&](std::size_t i) { return edgeKey(triangle[i], triangle[(i + 1) % 3]); };
    const auto point = [&](std::size_t i) {
      return crossing(mesh.positions[triangle[i]], mesh.positions[triangle[(i + 1) % 3]]);
    };
    found(key(*enters), key(*leaves), point(*enters), point(*leaves));
  }
}

/// The part of a closed polygon with r >= 0.
std::vector<Vec2> clipAtAxis(const std::vector<Vec2>& loop) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if (a.x() >= 0) kept.push_back(a);
    if ((a.x() >= 0) == (b.x() >= 0)) continue;
    kept.emplace_back(0.0, a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x()));
  }
  return kept;
}

/// Whether a ray from the point away from the axis crosses an odd number of segments.
bool insideOf(const std::vector<SectionSegment>& segments, const Vec2& p) {
  bool inside = false;
  for (const auto& [a, b] : segments) {
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    inside ^= a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) > p.x();
  }
  return inside;
}

bool finite(const SectionSegment& s) { return s[0].allFinite() && s[1].allFinite(); }

std::vector<SectionSegment> edgesOf(const std::vector<std::vector<Vec2>>& loops) {
  std::vector<SectionSegment> edges;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return edges;
}

class ProfileSampler {
 public:
  ProfileSampler(const std::vector<std::vector<Vec2>>& loops, const std::vector<SectionSegment>& nominal,
                 const std::vector<IgnoredRegion>& ignored)
      : loops_(loops), nominal_(nominal), ignored_(ignored), edges_(edgesOf(loops)) {
    for (const SectionSegment& edge : edges_)
      if (isSurface(edge)) length_ += (edge[1] - edge[0]).norm();
    with_corners_ = edges_.size() <= kMaxEdgesWithCorners;
    // Corners take up to two samples an edge; the rest goes between.
    const std::size_t between =
        with_corners_ ? kMaxProfileSamples - 2 * edges_.size() : kMaxProfileSamples - 1;
    step_ = length_ / static_cast<double>(between);
  }

  ProfileDeviations sample() {
    if (!(length_ > 0) || !std::isfinite(length_)) return {};
    for (const auto& loop : loops_) {
      broken_ = true;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const SectionSegment edge{loop[i], loop[(i + 1) % loop.size()]};
        if (isSurface(edge)) {
          sampleEdge(edge);
        } else if (edge[0] != edge[1]) {
          broken_ = true;
        }
      }
    }
    findLargest(-1.0, result_.largest_gouge_mm, result_.gouge_at);
    findLargest(1.0, result_.largest_excess_mm, result_.excess_at);
    return std::move(result_);
  }

 private:
  static bool isSurface(const SectionSegment& edge) {
    return edge[0] != edge[1] && std::max(edge[0].x(), edge[1].x()) > kOnAxisMm;
  }

  void sampleEdge(const SectionSegment& edge) {
    const Vec2 along = edge[1] - edge[0];
    const double length = along.norm();
    if (with_corners_) {
      const auto parts = static_cast<std::size_t>(std::floor(length / step_)) + 1;
      for (std::size_t i = 0; i <= parts; ++i)
        add(edge[0] + along * (static_cast<double>(i) / static_cast<double>(parts)));
      return;
    }
    for (; next_ <= length; next_ += step_) add(edge[0] + along * (next_ / length));
    next_ -= length;
  }

  void add(const Vec2& at) {
    const Vec3 place(at.x(), 0.0, at.y());
    if (std::any_of(ignored_.begin(), ignored_.end(),
                    [&](const IgnoredRegion& r) { return r.contains(place); })) {
      broken_ = true;
      return;
    }
    Vec2 nearest = nominal_.front()[0];
    for (const SectionSegment& segment : nominal_) {
      const Vec2 p = nearestOnSegment(at, segment[0], segment[1]);
      if ((p - at).squaredNorm() < (nearest - at).squaredNorm()) nearest = p;
    }
    double distance = (at - nearest).norm();
    if (insideOf(nominal_, at)) distance = -distance;
    result_.samples.push_back({at, nearest, distance, broken_});
    broken_ = false;
  }

  /// The largest of sign * deviation, >= 0; its place is the middle of the stretch that is as far off.
  void findLargest(double sign, double& largest, Vec2& place) const {
    const auto& samples = result_.samples;
    std::size_t first = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (sign * samples[i].deviation_mm <= largest) continue;
      largest = sign * samples[i].deviation_mm;
      first = i;
    }
    if (largest == 0.0) return;
    const auto isSame = [&](std::size_t i) { return sign * samples[i].deviation_mm >= largest - kSameMm; };
    std::size_t last = first;
    while (last + 1 < samples.size() && !samples[last + 1].starts_stretch && isSame(last + 1)) ++last;
    while (first > 0 && !samples[first].starts_stretch && isSame(first - 1)) --first;
    place = samples[(first + last) / 2].at;
  }

  const std::vector<std::vector<Vec2>>& loops_;
  const std::vector<SectionSegment>& nominal_;
  const std::vector<IgnoredRegion>& ignored_;
  std::vector<SectionSegment> edges_;
  double length_ = 0.0, step_ = 0.0, next_ = 0.0;
  bool with_corners_ = false, broken_ = true;
  ProfileDeviations result_;
};

}  // namespace

std::vector<SectionSegment> halfSection(const TriMesh& mesh) {
  std::vector<SectionSegment> segments;
  forEachCut(mesh, [&](EdgeKey, EdgeKey, Vec2 a, Vec2 b) {
    if (a.x() < 0 && b.x() < 0) return;
    const auto onAxis = [&] { return Vec2(0.0, a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x())); };
    if ((a.x() < 0) != (b.x() < 0)) (a.x() < 0 ? a : b) = onAxis();
    if (a != b) segments.push_back({a, b});
  });
  return segments;
}

std::vector<std::vector<Vec2>> halfSectionLoops(const TriMesh& mesh) {
  struct Link {
    EdgeKey to = 0;
    Vec2 at = Vec2::Zero();
    bool used = false;
  };
  std::vector<EdgeKey> order;  // as met in the mesh: the result does not depend on the table's
  std::unordered_map<EdgeKey, Link> links;
  forEachCut(mesh, [&](EdgeKey from, EdgeKey to, const Vec2& a, const Vec2&) {
    if (links.emplace(from, Link{to, a}).second) order.push_back(from);
  });
  std::vector<std::vector<Vec2>> loops;
  for (const EdgeKey start : order) {
    std::vector<Vec2> loop;
    for (auto it = links.find(start); it != links.end() && !it->second.used; it = links.find(it->second.to)) {
      it->second.used = true;
      if (loop.empty() || loop.back() != it->second.at) loop.push_back(it->second.at);
    }
    loop = clipAtAxis(loop);
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

ProfileDeviations profileDeviations(const std::vector<std::vector<Vec2>>& machined,
                                    const std::vector<SectionSegment>& nominal,
                                    const std::vector<IgnoredRegion>& ignored) {
  const auto allFinite = [](const std::vector<Vec2>& loop) {
    return std::all_of(loop.begin(), loop.end(), [](const Vec2& p) { return p.allFinite(); });
  };
  if (nominal.empty() || !std::all_of(nominal.begin(), nominal.end(), finite) ||
      !std::all_of(machined.begin(), machined.end(), allFinite)) {
    return {};
  }
  return ProfileSampler(machined, nominal, ignored).sample();
}

}  // namespace proveout
