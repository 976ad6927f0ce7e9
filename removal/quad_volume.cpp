#include "removal/quad_volume.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace proveout {

namespace {

/// Heights below this part of the distance come from the rounding of the stored normal.
constexpr double kFlatSlope = 6e-5;
/// Corners of a parallelogram leave one curvature open (which then does not matter); this, by the mean square
/// of the equations' terms, keeps it at zero.
constexpr double kOpen = 1e-4;
/// A surface that bends more than this inside a cell is not smooth there; rather no bulge than a wrong one.
constexpr double kSteepest = 0.7;

}  // namespace

double quadVolume(const std::array<Vec3, 4>& corners, const Vec3& crossing, const Vec3& normal,
                  const Vec3& apex) {
  std::array<Vec3, 4> d;
  std::array<double, 4> height;
  bool flat = true, steep = false;
  for (int i = 0; i < 4; ++i) {
    d[i] = corners[i] - crossing;
    height[i] = normal.dot(d[i]);
    const double length2 = d[i].squaredNorm(), height2 = height[i] * height[i];
    flat = flat && height2 <= kFlatSlope * kFlatSlope * length2;
    steep = steep || height2 > kSteepest * kSteepest * length2;
  }
  const Vec3 from = crossing - apex;
  Vec3 area = Vec3::Zero();
  double cones = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Vec3 c = d[i].cross(d[(i + 1) % 4]);
    area += c;
  }
  cones = from.dot(area) / 6.0;
  if (flat || steep) return cones;

  // q = (xx, xy, yy) of twice the height, from the four corners by least squares.
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  std::array<Vec2, 4> t;
  for (int i = 0; i < 4; ++i) {
    t[i] = {e1.dot(d[i]), e2.dot(d[i])};
    const Vec3 row(t[i].x() * t[i].x(), 2.0 * t[i].x() * t[i].y(), t[i].y() * t[i].y());
    m += row * row.transpose();
    right += row * (2.0 * height[i]);
  }
  m.diagonal().array() += kOpen * m.trace() / 3.0 + 1e-30;
  const Vec3 q = m.inverse() * right;
  const auto bend = [&](const Vec2& a) {
    return q[0] * a.x() * a.x() + 2.0 * q[1] * a.x() * a.y() + q[2] * a.y() * a.y();
  };
  // A quadratic less its linear interpolation integrates to -area/24 * (sum over the edges of its bend).
  double bulge = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Vec2 &a = t[i], &b = t[(i + 1) % 4];
    const double twice_area = a.x() * b.y() - a.y() * b.x();
    bulge -= 0.5 * twice_area * (bend(a) + bend(b) + bend(b - a)) / 24.0;
  }
  return cones + bulge;
}

}  // namespace proveout
