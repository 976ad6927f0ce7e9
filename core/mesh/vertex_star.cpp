#include "core/mesh/vertex_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/to_float.h"

namespace proveout {
namespace {

/// Triangles of less height than this part of their longest edge are needles.
constexpr double kNeedle = 1e-4;
/// Cosine of the largest angle between a new triangle and the old one at its outer edge.
constexpr double kMostLean = 0.8;
/// The same between an old one and the view: what is seen flatter than this is hardly seen.
constexpr double kSeen = 0.2;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

bool VertexStar::walk(const CornerTable& table, std::uint32_t middle) {
  size_ = borders_ = 0;
  names_ = 0;
  const std::uint32_t first = table.outOf(middle);
  std::uint32_t h = first, label = table.labelAt(table.twin(h));
  do {
    if (size_ == kMost) return false;
    const std::uint32_t end = table.to(h), left = table.labelAt(h);
    half_edge_[size_] = h;
    ring_[size_] = end;
    names_ |= std::uint64_t{1} << (end & 63);
    if (left != label) {
      if (borders_ < 2) border_at_[borders_] = size_;
      ++borders_;
      label = left;
    }
    ++size_;
    h = table.turned(h);
  } while (h != first);
  middle_ = middle;
  return true;
}

void VertexStar::look(const StarSurroundings& around) {
  around_ = &around;
  largest_error_ = 0.0;
  planes_ = {};
  const Vec3 at = around.positions[middle_].cast<double>();
  for (int j = 0; j < size_; ++j) {
    arm_[j] = around.positions[ring_[j]].cast<double>() - at;
    const TriangleState& triangle = around.triangles[CornerTable::triangleOf(half_edge_[j])];
    const Vec3 n = normal_[j] = triangle.normal.cast<double>();
    planes_[0] += n.x() * n.x();
    planes_[1] += n.x() * n.y();
    planes_[2] += n.x() * n.z();
    planes_[3] += n.y() * n.y();
    planes_[4] += n.y() * n.z();
    planes_[5] += n.z() * n.z();
    error_[j] = triangle.error;
    largest_error_ = std::max(largest_error_, error_[j]);
  }
}

bool VertexStar::findView() {
  Vec3 view = Vec3::Zero();
  for (int j = 0; j < size_; ++j) view += normal_[j];
  const double length = view.norm();
  double least = length;
  for (int j = 0; j < size_; ++j) least = std::min(least, normal_[j].dot(view));
  if (length < kSeen || least < kSeen * length) return false;
  // Seen along the view, on the plane of two axes: places and crossings are the same parts of lines and
  // triangles as on the one across the view.
  int drop = 0;
  view.cwiseAbs().maxCoeff(&drop);
  const int x = (drop + (view[drop] > 0.0 ? 1 : 2)) % 3, y = 3 - drop - x;
  const double over_drop = 1.0 / view[drop], over_length = 1.0 / length;
  const double along_x = view[x] * over_drop, along_y = view[y] * over_drop;
  for (int j = 0; j < size_; ++j) {
    const Vec3& arm = arm_[j];
    flat_[j] = {arm[x] - arm[drop] * along_x, arm[y] - arm[drop] * along_y};
    height_[j] = arm.dot(view) * over_length;
  }
  int rounds = 0;
  for (int j = 0; j < size_; ++j) rounds += flat_[j].y() < 0.0 && flat_[after(j)].y() >= 0.0 ? 1 : 0;
  return rounds == 1;
}

/// False: a new triangle would face away.
bool VertexStar::openFan(int b, Fan& fan) const {
  fan.base = b;
  fan.corners = size_ - 1;
  const Vec2 from = flat_[b];
  for (int k = 0, j = b; k < fan.corners; ++k) {
    j = after(j);
    fan.j[k] = j;
    fan.p[k] = flat_[j] - from;
    fan.side[k] = cross(from, fan.p[k]);
  }
  double least = 1.0;
  for (int k = 0; k + 1 < fan.corners; ++k) least = std::min(least, cross(fan.p[k], fan.p[k + 1]));
  return least > 0.0;
}

/// The normals of the new triangles. False: they are needles or lean.
bool VertexStar::shape(const Fan& fan, Change& change) const {
  const double least2 = around_->least_height * around_->least_height;
  Vec3 p = arm_[fan.j[0]] - arm_[fan.base];
  double p2 = p.squaredNorm();
  for (int k = 0; k + 1 < fan.corners; ++k) {
    const int j = fan.j[k];
    const Vec3 q = arm_[fan.j[k + 1]] - arm_[fan.base];
    const double q2 = q.squaredNorm();
    const Vec3 area = p.cross(q);
    const double twice2 = area.squaredNorm();
    const double longest2 = std::max({p2, q2, (q - p).squaredNorm()});
    if (twice2 < std::max(kNeedle * kNeedle * longest2, least2) * longest2) return false;
    const double facing = area.dot(normal_[j]);
    if (facing < 0.0 || facing * facing < kMostLean * kMostLean * twice2) return false;
    change.triangle[j].normal = toFloat(area * (1.0 / std::sqrt(twice2)));
    p = q;
    p2 = q2;
  }
  return true;
}

/// The middle is seen in front of or behind one of the new triangles, or two, on their edge: `first` to
/// `last`. Returns by how much.
double VertexStar::addMiddle(Fan& fan, int& first, int& last) const {
  const double base = height_[fan.base];
  const int triangles = fan.corners - 1;
  double most = 0.0;
  first = triangles;
  last = -1;
  for (int k = 0; k < triangles; ++k) {
    if ((k > 0 && fan.side[k] < 0.0) || (k + 1 < triangles && fan.side[k + 1] > 0.0)) continue;
    const double each = 1.0 / cross(fan.p[k], fan.p[k + 1]);
    const double s = -fan.side[k + 1] * each, t = fan.side[k] * each;
    const double height = base + s * (height_[fan.j[k]] - base) + t * (height_[fan.j[k + 1]] - base);
    fan.moved[k] = std::abs(height);
    fan.before[k] = largest_error_;
    most = std::max(most, fan.moved[k]);
    first = std::min(first, k);
    last = k;
  }
  return most;
}

/// A new edge divides the star in two; the old edges to the ring on the side where the middle is not cross
/// it. The middle is in the new triangles `first` to `last`.
void VertexStar::addCrossings(Fan& fan, int first, int last) const {
  for (int d = 1; d + 1 < fan.corners; ++d) {
    const double over_length2 = 1.0 / fan.p[d].squaredNorm();
    if (d <= last) {
      for (int k = 0; k < d; ++k) addCrossing(fan, d, over_length2, k);
    }
    if (d > first) {
      for (int k = d + 1; k < fan.corners; ++k) addCrossing(fan, d, over_length2, k);
    }
  }
}

/// The old edge to corner k crosses the new one to corner d.
void VertexStar::addCrossing(Fan& fan, int d, double over_length2, int k) const {
  const int i = fan.j[k];
  const double side = fan.side[d], other = cross(fan.p[d], fan.p[k]);
  if (side * other >= 0.0) return;
  const double part = side / (side - other), base = height_[fan.base];
  const double at = fan.p[d].dot(part * flat_[i] - flat_[fan.base]) * over_length2;
  const double off = std::abs(part * height_[i] - (base + at * (height_[fan.j[d]] - base)));
  const double old = std::max(error_[i], error_[before(i)]);
  for (const int t : {d - 1, d}) {
    fan.moved[t] = std::max(fan.moved[t], off);
    fan.before[t] = std::max(fan.before[t], old);
  }
}

bool VertexStar::join(int b, double most, Change& change) const {
  Fan fan;
  if (!openFan(b, fan)) return false;
  // Errors of the old triangles that a new one takes the place of: the one at its outer edge, and others.
  for (int k = 0; k + 1 < fan.corners; ++k) {
    fan.moved[k] = 0.0;
    fan.before[k] = error_[fan.j[k]];
  }
  int first = 0, last = 0;
  if (addMiddle(fan, first, last) + largest_error_ > most || !shape(fan, change)) return false;
  addCrossings(fan, first, last);
  float largest = 0.0f, moved = 0.0f;
  for (int k = 0; k + 1 < fan.corners; ++k) {
    const auto error = toFloat(fan.moved[k] + fan.before[k]);
    change.triangle[fan.j[k]].error = error;
    largest = std::max(largest, error);
    moved = std::max(moved, toFloat(fan.moved[k]));
  }
  change.moved = moved;
  return largest <= toFloat(most);
}

}  // namespace proveout
