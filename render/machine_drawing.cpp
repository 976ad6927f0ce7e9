#include "render/machine_drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/to_float.h"

namespace proveout {

namespace {

constexpr int kAround = 48;

/// A closed outline in the half-plane (radius, height) turned about an axis. Points of radius 0 are on it.
void addTurned(TriMesh& mesh, const Vec3& base, const Vec3& axis, const std::vector<Vec2>& outline) {
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (int k = 0; k < kAround; ++k) {
    const double angle = 2.0 * kPi * k / kAround;
    for (const Vec2& p : outline)
      mesh.positions.push_back(
          toFloat(Vec3(base + axis * p.y() + p.x() * (std::cos(angle) * u + std::sin(angle) * v))));
  }
  for (std::uint32_t k = 0; k < kAround; ++k) {
    const std::uint32_t here = first + k * count, next = first + (k + 1) % kAround * count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t j = (i + 1) % count;
      if (outline[i].x() > 0.0) mesh.triangles.push_back({here + i, next + i, here + j});
      if (outline[j].x() > 0.0) mesh.triangles.push_back({next + i, next + j, here + j});
    }
  }
}

void addRod(TriMesh& mesh, const Vec3& from, const Vec3& to, double radius) {
  const double length = (to - from).norm();
  if (!(length > 0.0)) return;
  addTurned(mesh, from, (to - from) / length, {{0, 0}, {radius, 0}, {radius, length}, {0, length}});
}

void addRing(TriMesh& mesh, const Vec3& center, const Vec3& axis, double radius, double thick) {
  addTurned(
      mesh, center, axis,
      {{radius - thick, -thick}, {radius + thick, -thick}, {radius + thick, thick}, {radius - thick, thick}});
}

/// About as large as the machine is.
double sizeOf(const MachineModel& model) {
  double size = 200.0;
  for (const MachineAxis& axis : model.axes) {
    if (axis.kind == AxisKind::kLinear && axis.travel)
      size = std::max(size, axis.travel->max - axis.travel->min);
    if (axis.kind == AxisKind::kRotary) size = std::max(size, axis.point.norm());
  }
  return std::min(size, 1e5);
}

}  // namespace

TriMesh machineDrawing(const MachineModel& model) {
  const double size = sizeOf(model), thin = 0.006 * size;
  TriMesh mesh;
  for (const MachineAxis& axis : model.axes) {
    if (axis.side == AxisSide::kNothing) continue;
    if (axis.kind == AxisKind::kRotary) {
      const double radius = (axis.side == AxisSide::kPart ? 0.2 : 0.1) * size;
      addRing(mesh, axis.point, axis.direction, radius, 2.0 * thin);
      addRod(mesh, axis.point - radius * axis.direction, axis.point + radius * axis.direction, thin);
      continue;
    }
    const double low = axis.travel ? axis.travel->min : 0.0,
                 high = axis.travel ? axis.travel->max : 0.3 * size;
    addRod(mesh, low * axis.direction, high * axis.direction, thin);
    addTurned(mesh, high * axis.direction, axis.direction, {{0, 0}, {3 * thin, 0}, {0, 8 * thin}});
  }
  const Vec3 gauge = model.spindle.gauge, tool = model.spindle.direction;
  addRod(mesh, gauge - 0.15 * size * tool, gauge, 1.5 * thin);
  addRod(mesh, gauge, gauge + 0.1 * size * tool, 6.0 * thin);
  return mesh;
}

}  // namespace proveout
