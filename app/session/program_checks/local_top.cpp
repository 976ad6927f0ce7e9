#include "app/session/program_checks/local_top.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace proveout {
namespace {

/// The part of a convex polygon on the side of a plane across `axis` where sign * (p - at) >= 0.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, int axis, double at, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
    if (da >= 0.0) kept.push_back(a);
    if ((da < 0.0) != (db < 0.0)) kept.emplace_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

std::optional<double> topOf(const Box3& box, const Vec2& place, double reach) {
  const Vec2 low = box.min.head<2>(), high = box.max.head<2>();
  const Vec2 nearest = place.cwiseMax(low).cwiseMin(high);
  if ((place - nearest).cwiseAbs().maxCoeff() > reach) return std::nullopt;
  return box.max.z();
}

std::optional<double> topOf(const CylinderShape& cylinder, const Vec2& place, double reach) {
  const Vec2 at = place - cylinder.base.head<2>();
  if (cylinder.axis == 2) {
    if (at.norm() > cylinder.radius + reach) return std::nullopt;
    return cylinder.base.z() + cylinder.length;
  }
  const double along = at[cylinder.axis], across = std::abs(at[1 - cylinder.axis]);
  if (along < -reach || along > cylinder.length + reach) return std::nullopt;
  const double beside = std::max(0.0, across - reach);
  if (beside > cylinder.radius) return std::nullopt;
  return cylinder.base.z() + std::sqrt(cylinder.radius * cylinder.radius - beside * beside);
}

}  // namespace

std::optional<double> topNear(const TriMesh& mesh, const Vec2& place, double reach) {
  std::optional<double> top;
  const Vec2 low = place - Vec2::Constant(reach), high = place + Vec2::Constant(reach);
  for (const auto& triangle : mesh.triangles) {
    std::vector<Vec3> polygon;
    Box3 bounds;
    for (const auto corner : triangle) {
      polygon.emplace_back(mesh.positions[corner].cast<double>());
      bounds.extend(polygon.back());
    }
    const bool beside = (bounds.max.head<2>().array() < low.array()).any() ||
                        (bounds.min.head<2>().array() > high.array()).any();
    if (beside || (top && bounds.max.z() <= *top)) continue;
    for (const int axis : {0, 1}) {
      polygon = clipped(polygon, axis, low[axis], 1.0);
      polygon = clipped(polygon, axis, high[axis], -1.0);
    }
    for (const Vec3& p : polygon) top = std::max(top.value_or(p.z()), p.z());
  }
  return top;
}

std::optional<double> topNear(const StockShape& shape, const Vec2& place, double reach) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return topOf(Box3{box->min, box->max}, place, reach);
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return topOf(*cylinder, place, reach);
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return topNear(mesh->mesh, place, reach);
  const Box3 bounds = shapeBounds(shape);
  return bounds.empty() ? std::nullopt : topOf(bounds, place, reach);
}

}  // namespace proveout
