#include "core/nc/kinematics/rotary_kinematics.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

/// Angles closer than this are one: far below any increment (1e-6 deg), above rounding noise.
constexpr double kSameAngleDeg = 1e-9;

/// Rotation by an angle in degrees, exact for quarter turns.
Eigen::Matrix3d rotation(const Vec3& direction, double degrees) {
  const auto [s, c] = sinCosDegrees(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -direction.z(), direction.y(), direction.z(), 0, -direction.x(), -direction.y(), direction.x(),
      0;
  return Eigen::Matrix3d::Identity() * c + cross * s + direction * direction.transpose() * (1.0 - c);
}

}  // namespace

RotaryKinematics::RotaryKinematics(const AxisTable& axes, const Vec3& origin) {
  for (int k = 0; k < axes.count(); ++k) {
    const AxisInfo& axis = axes.at(k);
    if (!axis.mount) continue;
    tables_.push_back({k, axis.mount->direction.normalized(), axis.mount->center.value_or(origin) - origin});
  }
}

bool RotaryKinematics::turns(const AxisPoint& a, const AxisPoint& b) const {
  for (const Table& t : tables_) {
    if (std::abs(a[t.axis] - b[t.axis]) > kSameAngleDeg) return true;
  }
  return false;
}

bool RotaryKinematics::atZero(const AxisPoint& machine) const {
  for (const Table& t : tables_) {
    if (std::abs(std::remainder(machine[t.axis], 360.0)) > kSameAngleDeg) return false;
  }
  return true;
}

double RotaryKinematics::turned(const AxisPoint& a, const AxisPoint& b) const {
  double sum = 0.0;
  for (const Table& t : tables_) sum += std::abs(b[t.axis] - a[t.axis]);
  return degToRad(sum);
}

bool RotaryKinematics::carries(int axis) const {
  for (const Table& t : tables_) {
    if (t.axis == axis) return true;
  }
  return false;
}

Vec3 RotaryKinematics::point(const AxisPoint& machine, const Vec3& p) const {
  Vec3 q = p;
  for (const Table& t : tables_) {
    if (machine[t.axis] != 0.0) q = t.center + rotation(t.direction, machine[t.axis]) * (q - t.center);
  }
  return q;
}

Vec3 RotaryKinematics::direction(const AxisPoint& machine, const Vec3& d) const {
  Vec3 q = d;
  for (const Table& t : tables_) {
    if (machine[t.axis] != 0.0) q = rotation(t.direction, machine[t.axis]) * q;
  }
  // Upright is upright, whatever the last digit says: much depends on it.
  if ((q - Vec3::UnitZ()).norm() < 1e-12) return Vec3::UnitZ();
  return q;
}

int RotaryKinematics::turningTable(const AxisPoint& a, const AxisPoint& b) const {
  int found = -1;
  for (std::size_t k = 0; k < tables_.size(); ++k) {
    if (std::abs(a[tables_[k].axis] - b[tables_[k].axis]) <= kSameAngleDeg) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(k);
  }
  return found;
}

void RotaryKinematics::tableAxis(int table, const AxisPoint& machine, Vec3& point, Vec3& direction) const {
  const auto first = static_cast<std::size_t>(table);
  PROVEOUT_ASSERT(table >= 0 && first < tables_.size());
  point = tables_[first].center;
  direction = tables_[first].direction;
  // What lies nearer to the part turns the axis of what lies below it.
  for (std::size_t k = first + 1; k < tables_.size(); ++k) {
    const Table& t = tables_[k];
    const Eigen::Matrix3d r = rotation(t.direction, machine[t.axis]);
    point = t.center + r * (point - t.center);
    direction = r * direction;
  }
}

}  // namespace proveout::nc
