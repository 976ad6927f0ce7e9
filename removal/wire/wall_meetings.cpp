#include "removal/wire/wall_meetings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/geometry/plane.h"
#include "core/mesh/intersections.h"
#include "removal/wire/order_tree.h"
#include "removal/wire/segment_meetings.h"

namespace proveout {
namespace {

/// Triangles that follow each other, compared at once.
constexpr std::size_t kStrip = 16;
/// Pairs of strips that are one task.
constexpr std::size_t kPairsATask = 256;

struct Interval {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool touches(const Interval& other) const { return low <= other.high && other.low <= high; }
};

/// Where a strip is: a box along the axes and one along itself.
struct StripSpan {
  Box3 box;

  void add(const StripSpan& other) { box.extend(other.box); }
  bool touches(const StripSpan& other) const { return box.overlaps(other.box); }
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
    std::vector<StripSpan> spans(strips);
    parallelFor(std::size_t{0}, strips, [&](std::size_t i) {
      boxes_[i] = boxOf(stripAt(i));
      for (const std::uint32_t t : stripAt(i)) {
        for (const Vec3& p : cornersOf(mesh_, t)) spans[i].box.extend(p);
      }
    });
    OrderTree<StripSpan>(std::move(spans)).eachPair([&](std::size_t i, std::size_t k) {
      if (i == k || !(boxes_[i].apartFrom(boxes_[k]) || boxes_[k].apartFrom(boxes_[i])))
        pairs_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
    });
  }

  std::size_t count() const {
    const std::size_t tasks = (pairs_.size() + kPairsATask - 1) / kPairsATask;
    std::vector<std::size_t> found(tasks, 0);
    parallelFor(std::size_t{0}, tasks, [&](std::size_t task) {
      for (std::size_t i = task * kPairsATask; i < std::min(pairs_.size(), (task + 1) * kPairsATask); ++i)
        found[task] += meetings(pairs_[i][0], pairs_[i][1]);
    });
    return std::accumulate(found.begin(), found.end(), std::size_t{0});
  }

 private:
  std::span<const std::uint32_t> stripAt(std::size_t i) const {
    const std::size_t first = i * kStrip;
    return std::span(walls_).subspan(first, std::min(kStrip, walls_.size() - first));
  }

  StripBox boxOf(std::span<const std::uint32_t> strip) const {
    Vec3 normal = Vec3::Zero();
    for (const std::uint32_t t : strip) {
      const std::array<Vec3, 3> p = cornersOf(mesh_, t);
      normal += (p[1] - p[0]).cross(p[2] - p[0]);
    }
    if (normal.squaredNorm() == 0.0) normal = Vec3::UnitX();
    normal.normalize();
    const Vec3 up = std::abs(normal.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
    StripBox box;
    // Level along the wall: rungs stand across.
    box.axis = {up.cross(normal).normalized(), normal, Vec3::Zero()};
    box.axis[2] = box.axis[0].cross(normal);
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

  /// Of the triangles of a strip, along the way of one of the two that are compared and along its normal.
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

  std::size_t meetings(std::size_t a, std::size_t b) const {
    const std::span<const std::uint32_t> in_a = stripAt(a), in_b = stripAt(b);
    const Ranges range_a = rangesOf(in_a, boxes_[a]);
    const Ranges range_b = a == b ? range_a : rangesOf(in_b, boxes_[a]);
    std::size_t found = 0;
    for (std::size_t i = 0; i < in_a.size(); ++i) {
      for (std::size_t k = a == b ? i + 1 : 0; k < in_b.size(); ++k) {
        const auto &r = range_a.of[i], &s = range_b.of[k];
        if (r[0].touches(s[0]) && r[1].touches(s[1]) && trianglesMeet(mesh_, in_a[i], in_b[k])) ++found;
      }
    }
    return found;
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
        turned_ += twice(t) * (isAt(t, high_) ? 1.0 : -1.0) <= 0.0 ? 1 : 0;
        continue;
      }
      walls_.push_back(t);
      upright_ = upright_ && twice(t) == 0.0 && endsAtFaces(t);
    }
  }

  std::size_t count() const {
    const std::size_t below = turned_ + meetingSegments(bordersAt(low_)).size();
    if (upright_) return below;
    return below + meetingSegments(bordersAt(high_)).size() + WallSearch(mesh_, walls_).count();
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

  /// Where walls meet the faces at a height.
  std::vector<PlaneSegment> bordersAt(float z) const {
    std::vector<PlaneSegment> out;
    for (const std::uint32_t t : walls_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        if (heightOf(a) == z && heightOf(b) == z) out.push_back({placeOf(a), placeOf(b), a, b});
      }
    }
    return out;
  }

  const TriMesh& mesh_;
  float low_ = std::numeric_limits<float>::infinity(), high_ = -low_;
  std::size_t turned_ = 0;  ///< triangles of faces
  bool upright_ = true;
  std::vector<std::uint32_t> walls_;  ///< all other triangles
};

}  // namespace

std::size_t wallMeetings(const TriMesh& mesh) { return LevelFaces(mesh).count(); }

}  // namespace proveout
