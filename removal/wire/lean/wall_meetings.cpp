#include "removal/wire/lean/wall_meetings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/geometry/plane.h"
#include "core/mesh/exact_meeting.h"
#include "core/mesh/intersections.h"
#include "removal/wire/section/order_tree.h"
#include "removal/wire/section/segment_meetings.h"

namespace proveout {
namespace {

/// How many consecutive triangles are compared at once.
constexpr std::size_t kStrip = 16;
/// How many pairs of strips make one task.
constexpr std::size_t kPairsATask = 256;

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

struct Interval {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool touches(const Interval& other) const { return low <= other.high && other.low <= high; }
};

/// A box along a strip: its way from the first triangle to the last, its normal, and across both. Walls
/// beside each other that lean far have boxes along the axes that all overlap.
struct StripBox {
  Vec3 middle = Vec3::Zero();
  std::array<Vec3, 3> axis;
  Vec3 half = Vec3::Zero();

  double reach(const Vec3& along) const {
    return half[0] * std::abs(axis[0].dot(along)) + half[1] * std::abs(axis[1].dot(along)) +
           half[2] * std::abs(axis[2].dot(along));
  }
  /// Along one of its own axes. False where rounding could say so.
  bool apartFrom(const StripBox& other) const {
    constexpr double kRounding = 1e-9;
    const Vec3 way = other.middle - middle;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(way.dot(axis[k])) > half[k] + other.reach(axis[k]) + kRounding) return true;
    }
    return false;
  }
};

class WallSearch {
 public:
  WallSearch(const TriMesh& mesh, std::vector<std::uint32_t> walls) : mesh_(mesh), walls_(std::move(walls)) {
    const std::size_t strips = (walls_.size() + kStrip - 1) / kStrip;
    boxes_.resize(strips);
    std::vector<Box3> bounds(strips);
    parallelFor(std::size_t{0}, strips, [&](std::size_t i) {
      boxes_[i] = boxOf(stripAt(i));
      for (const std::uint32_t t : stripAt(i)) {
        for (const Vec3& p : cornersOf(mesh_, t)) bounds[i].extend(p);
      }
    });
    OrderTree(std::move(bounds)).eachPair([&](std::size_t i, std::size_t k) {
      if (i == k || !(boxes_[i].apartFrom(boxes_[k]) || boxes_[k].apartFrom(boxes_[i])))
        pairs_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
    });
  }

  void find(Pairs& out) const {
    const std::size_t tasks = (pairs_.size() + kPairsATask - 1) / kPairsATask;
    std::vector<Pairs> found(tasks);
    parallelFor(std::size_t{0}, tasks, [&](std::size_t task) {
      for (std::size_t i = task * kPairsATask; i < std::min(pairs_.size(), (task + 1) * kPairsATask); ++i)
        meetings(pairs_[i][0], pairs_[i][1], found[task]);
    });
    for (const Pairs& some : found) std::copy(some.begin(), some.end(), std::back_inserter(out));
  }

 private:
  std::span<const std::uint32_t> stripAt(std::size_t i) const {
    const std::size_t first = i * kStrip;
    return std::span(walls_).subspan(first, std::min(kStrip, walls_.size() - first));
  }

  /// From below to above, about along the rungs of a strip; level faces: anywhere along them.
  Vec3 rise(std::span<const std::uint32_t> strip) const {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t t : strip) {
      const std::array<Vec3, 3> p = cornersOf(mesh_, t);
      Vec3 steepest = p[1] - p[0];
      for (const Vec3& edge : {Vec3(p[2] - p[1]), Vec3(p[0] - p[2])}) {
        if (std::abs(edge.z()) > std::abs(steepest.z())) steepest = edge;
      }
      sum += steepest.z() < 0.0 ? Vec3(-steepest) : steepest;
    }
    return sum;
  }

  StripBox boxOf(std::span<const std::uint32_t> strip) const {
    Vec3 normal = Vec3::Zero();
    for (const std::uint32_t t : strip) {
      const std::array<Vec3, 3> p = cornersOf(mesh_, t);
      normal += (p[1] - p[0]).cross(p[2] - p[0]);
    }
    StripBox box;
    const Vec3 across = rise(strip).cross(normal);
    if (across.squaredNorm() > 0.0)
      box.axis = {across.normalized(), normal.normalized(), Vec3::Zero()};
    else
      box.axis = {Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero()};
    box.axis[2] = box.axis[0].cross(box.axis[1]);
    std::array<Interval, 3> range;
    for (const std::uint32_t t : strip) {
      for (const Vec3& p : cornersOf(mesh_, t)) {
        for (std::size_t k = 0; k < 3; ++k) range[k].add(box.axis[k].dot(p));
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      box.middle += 0.5 * (range[k].low + range[k].high) * box.axis[k];
      box.half[static_cast<int>(k)] = 0.5 * (range[k].high - range[k].low);
    }
    return box;
  }

  /// Of the triangles of a strip, across the rungs of one of the two that are compared and along its normal.
  struct Ranges {
    std::array<std::array<Interval, 2>, kStrip> of;
  };
  Ranges rangesOf(std::span<const std::uint32_t> strip, const StripBox& frame) const {
    Ranges out;
    for (std::size_t i = 0; i < strip.size(); ++i) {
      for (const std::uint32_t v : mesh_.triangles[strip[i]]) {
        const Vec3 p = mesh_.positions[v].cast<double>();
        for (std::size_t k = 0; k < 2; ++k) out.of[i][k].add(frame.axis[k].dot(p));
      }
    }
    return out;
  }

  float heightOf(std::uint32_t vertex) const { return mesh_.positions[vertex].z(); }
  /// Whether triangles have an edge in common that goes from one height to another.
  bool shareRung(std::uint32_t s, std::uint32_t t) const {
    const auto &a = mesh_.triangles[s], &b = mesh_.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = a[k], to = a[(k + 1) % 3];
      if (heightOf(from) != heightOf(to) && std::ranges::count(b, from) + std::ranges::count(b, to) == 2)
        return true;
    }
    return false;
  }
  /// Whether triangles that follow each other lie side by side: all go from one height to another, each is
  /// joined to the next by a rung, and at every height each goes ahead.
  bool inOrder(std::span<const std::uint32_t> triangles, const Vec3& ahead) const {
    const auto& first = mesh_.triangles[triangles.front()];
    const auto [low, high] = std::minmax({heightOf(first[0]), heightOf(first[1]), heightOf(first[2])});
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      bool goes_ahead = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = mesh_.triangles[triangles[i]][k],
                            to = mesh_.triangles[triangles[i]][(k + 1) % 3];
        if (heightOf(from) != low && heightOf(from) != high) return false;
        if (heightOf(from) != heightOf(to)) continue;
        const double step = ahead.dot((mesh_.positions[to] - mesh_.positions[from]).cast<double>());
        goes_ahead = (heightOf(from) == low ? step : -step) > 0.0;
      }
      if (!goes_ahead) return false;
      if (i + 1 < triangles.size() && !shareRung(triangles[i], triangles[i + 1])) return false;
    }
    return low < high;
  }

  void meetings(std::size_t a, std::size_t b, Pairs& found) const {
    const std::span<const std::uint32_t> in_a = stripAt(a), in_b = stripAt(b);
    if (a == b) {
      for (const std::uint32_t t : in_a)
        if (isNeedle(mesh_, t) && isFlat(mesh_, t)) found.push_back({t, t});
    }
    if (b <= a + 1 &&
        inOrder(std::span(walls_).subspan(a * kStrip, b == a ? in_a.size() : kStrip + in_b.size()),
                boxes_[a].axis[0]))
      return;
    const Ranges range_a = rangesOf(in_a, boxes_[a]);
    const Ranges range_b = a == b ? range_a : rangesOf(in_b, boxes_[a]);
    for (std::size_t i = 0; i < in_a.size(); ++i) {
      for (std::size_t k = a == b ? i + 1 : 0; k < in_b.size(); ++k) {
        const auto &r = range_a.of[i], &s = range_b.of[k];
        if (r[0].touches(s[0]) && r[1].touches(s[1]) && trianglesMeet(mesh_, in_a[i], in_b[k]) &&
            meetExactly(mesh_, in_a[i], in_b[k]))
          found.push_back({in_a[i], in_b[k]});
      }
    }
  }

  const TriMesh& mesh_;
  std::vector<std::uint32_t> walls_;  ///< numbers of triangles
  std::vector<StripBox> boxes_;
  std::vector<std::array<std::uint32_t, 2>> pairs_;  ///< strips that may meet
};

class LevelFaces {
 public:
  explicit LevelFaces(const TriMesh& mesh) : mesh_(mesh) {
    for (const Eigen::Vector3f& p : mesh.positions) {
      low_ = std::min(low_, p.z());
      high_ = std::max(high_, p.z());
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (isAt(t, low_) || isAt(t, high_)) {
        if (isTurned(t)) found_.push_back({t, t});
        continue;
      }
      walls_.push_back(t);
      upright_ = upright_ && twice(t) == 0.0 && endsAtFaces(t);
    }
  }

  Pairs find() {
    findBorders(low_);
    if (upright_) return std::move(found_);
    findBorders(high_);
    WallSearch(mesh_, walls_).find(found_);
    return std::move(found_);
  }

 private:
  float heightOf(std::uint32_t vertex) const { return mesh_.positions[vertex].z(); }
  bool isAt(std::uint32_t t, float z) const {
    return std::ranges::all_of(mesh_.triangles[t], [&](std::uint32_t v) { return heightOf(v) == z; });
  }
  bool endsAtFaces(std::uint32_t t) const {
    return std::ranges::all_of(mesh_.triangles[t],
                               [&](std::uint32_t v) { return heightOf(v) == low_ || heightOf(v) == high_; });
  }
  Vec2 placeOf(std::uint32_t vertex) const { return mesh_.positions[vertex].head<2>().cast<double>(); }
  /// Its area, seen from above.
  double twice(std::uint32_t t) const {
    const auto& v = mesh_.triangles[t];
    const Vec2 a = placeOf(v[0]);
    return cross2(placeOf(v[1]) - a, placeOf(v[2]) - a);
  }

  /// A triangle of a face that looks to the wrong side, or to none.
  bool isTurned(std::uint32_t t) const {
    constexpr double kSure = 1e-9;  // of the square of its size: farther off than rounding
    const double up = isAt(t, high_) ? 1.0 : -1.0, twice_up = up * twice(t);
    const auto& v = mesh_.triangles[t];
    const double size =
        (placeOf(v[1]) - placeOf(v[0])).squaredNorm() + (placeOf(v[2]) - placeOf(v[0])).squaredNorm();
    return twice_up <= kSure * size && up * turnFromAbove(mesh_, t) <= 0.0;
  }

  /// Where walls meet the faces at a height: those whose edges there cross.
  void findBorders(float z) {
    std::vector<PlaneSegment> edges;
    std::vector<std::uint32_t> wall;  // by edge
    for (const std::uint32_t t : walls_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        if (heightOf(a) != z || heightOf(b) != z) continue;
        edges.push_back({placeOf(a), placeOf(b), a, b});
        wall.push_back(t);
      }
    }
    for (const auto& [i, k] : meetingSegments(edges))
      if (meetExactly(mesh_, wall[i], wall[k])) found_.push_back({wall[i], wall[k]});
  }

  const TriMesh& mesh_;
  float low_ = std::numeric_limits<float>::infinity(), high_ = -low_;
  Pairs found_;
  bool upright_ = true;
  std::vector<std::uint32_t> walls_;  ///< all other triangles
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> wallMeetings(const TriMesh& mesh) {
  return LevelFaces(mesh).find();
}

}  // namespace proveout
