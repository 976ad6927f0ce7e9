#include "core/mesh/vertex_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

bool VertexStar::look(const StarSurroundings& around, std::uint32_t middle) {
  around_ = &around;
  size_ = 0;
  largest_error_ = 0.0;
  planes_ = {};
  const Vec3 at = around.positions[middle].cast<double>();
  const std::uint32_t first = around.table.outOf(middle);
  std::uint32_t h = first;
  do {
    if (size_ == kMost) return false;
    half_edge_[size_] = h;
    ring_[size_] = around.table.to(h);
    arm_[size_] = around.positions[ring_[size_]].cast<double>() - at;
    const TriangleState& triangle = around.triangles[CornerTable::triangleOf(h)];
    const Vec3 n = normal_[size_] = triangle.normal.cast<double>();
    planes_[0] += n.x() * n.x();
    planes_[1] += n.x() * n.y();
    planes_[2] += n.x() * n.z();
    planes_[3] += n.y() * n.y();
    planes_[4] += n.y() * n.z();
    planes_[5] += n.z() * n.z();
    error_[size_] = triangle.error;
    largest_error_ = std::max(largest_error_, error_[size_]);
    ++size_;
    h = around.table.turned(h);
  } while (h != first);
  return true;
}

bool VertexStar::findView() {
  Vec3 sum = Vec3::Zero();
  for (int j = 0; j < size_; ++j) sum += normal_[j];
  const double length = sum.norm();
  if (length < kSeen) return false;
  const Vec3 view = sum / length;
  for (int j = 0; j < size_; ++j) {
    if (normal_[j].dot(view) < kSeen) return false;
  }
  int least = 0;
  view.cwiseAbs().minCoeff(&least);
  const Vec3 u = view.cross(Vec3::Unit(least)).normalized(), v = view.cross(u);
  for (int j = 0; j < size_; ++j) {
    flat_[j] = {arm_[j].dot(u), arm_[j].dot(v)};
    height_[j] = arm_[j].dot(view);
  }
  int rounds = 0;
  for (int j = 0; j < size_; ++j) rounds += flat_[j].y() < 0.0 && flat_[after(j)].y() >= 0.0 ? 1 : 0;
  return rounds == 1;
}

bool VertexStar::facesViewer(int b) const {
  for (int j = after(b); after(j) != b; j = after(j)) {
    if (cross(flat_[j] - flat_[b], flat_[after(j)] - flat_[b]) <= 0.0) return false;
  }
  return true;
}

bool VertexStar::hasShape(int b) const {
  for (int j = after(b); after(j) != b; j = after(j)) {
    const Vec3 p = arm_[j] - arm_[b], q = arm_[after(j)] - arm_[b];
    const Vec3 area = p.cross(q);
    const double twice2 = area.squaredNorm();
    const double longest2 = std::max({p.squaredNorm(), q.squaredNorm(), (q - p).squaredNorm()});
    const double least2 = around_->least_height * around_->least_height;
    if (twice2 < std::max(kNeedle * kNeedle * longest2, least2) * longest2) return false;
    const double facing = area.dot(normal_[j]);
    if (facing < 0.0 || facing * facing < kMostLean * kMostLean * twice2) return false;
  }
  return true;
}

Eigen::Vector3f VertexStar::newNormal(int b, int j) const {
  return (arm_[j] - arm_[b]).cross(arm_[after(j)] - arm_[b]).normalized().cast<float>();
}

/// The middle is seen in front of or behind one of the new triangles. Returns by how much.
double VertexStar::addMiddle(int b, Values& moved, Values& before) const {
  const Vec2 to_middle = -flat_[b];
  double most = 0.0;
  for (int j = after(b); after(j) != b; j = after(j)) {
    const int k = after(j);
    const Vec2 p = flat_[j] - flat_[b], q = flat_[k] - flat_[b];
    const bool first = j == after(b), last = after(k) == b;
    if ((!first && cross(p, to_middle) < 0.0) || (!last && cross(to_middle, q) < 0.0)) continue;
    const double area = cross(p, q);
    const double s = cross(to_middle, q) / area, t = cross(p, to_middle) / area;
    const double height = height_[b] + s * (height_[j] - height_[b]) + t * (height_[k] - height_[b]);
    moved[j] = std::max(moved[j], std::abs(height));
    before[j] = largest_error_;
    most = std::max(most, moved[j]);
  }
  return most;
}

/// A new edge divides the star in two; the old edges to the ring on the side where the middle is not cross
/// it.
void VertexStar::addCrossings(int b, Values& moved, Values& before) const {
  for (int d = after(after(b)); after(d) != b; d = after(d)) {
    const Vec2 along = flat_[d] - flat_[b];
    const double side = cross(along, -flat_[b]), length2 = along.squaredNorm();
    for (int i = after(b); i != b; i = after(i)) {
      if (i == d) continue;
      const double other = cross(along, flat_[i] - flat_[b]);
      if (side * other >= 0.0) continue;
      const double part = side / (side - other);
      const double at = along.dot(part * flat_[i] - flat_[b]) / length2;
      const double off = std::abs(part * height_[i] - (height_[b] + at * (height_[d] - height_[b])));
      const double old = std::max(error_[i], error_[this->before(i)]);
      for (const int j : {this->before(d), d}) {
        moved[j] = std::max(moved[j], off);
        before[j] = std::max(before[j], old);
      }
    }
  }
}

bool VertexStar::join(int b, double most, Change& change) const {
  if (!facesViewer(b)) return false;
  Values moved, before;
  // Errors of the old triangles that a new one takes the place of: the one at its outer edge, and others.
  for (int j = 0; j < size_; ++j) {
    moved[j] = 0.0;
    before[j] = error_[j];
  }
  if (addMiddle(b, moved, before) + largest_error_ > most || !hasShape(b)) return false;
  addCrossings(b, moved, before);
  change.moved = 0.0f;
  bool within = true;
  for (int j = after(b); after(j) != b; j = after(j)) {
    change.error[j] = static_cast<float>(moved[j] + before[j]);
    change.moved = std::max(change.moved, static_cast<float>(moved[j]));
    within = within && change.error[j] <= static_cast<float>(most);
  }
  return within;
}

}  // namespace proveout
