#include "core/nc/iso/stages/transform_stage.h"

#include <cmath>

#include "core/nc/services/arcs.h"

namespace proveout::nc {
namespace {

/// (u, v, w) in work space of a point of the item's plane, (u, v, w) in program space.
Vec3 planeToWork(const CoordinateChain& chain, const PathItem& item, const Vec3& uvw) {
  AxisPoint p = item.to;
  p[item.plane.u] = uvw[0];
  p[item.plane.v] = uvw[1];
  p[item.plane.w] = uvw[2];
  chain.moveToWork(p);
  return item.plane.of(p);
}

/// Radii of an arc that differ by more make it a spiral, mm.
constexpr double kSameRadius = 0.01;

}  // namespace

bool TransformStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kProgram) {
    if (item.kind == PathItem::Kind::kArc) {
      if (!transformArc(item)) return false;
    } else if (item.join != PathItem::Join::kSharp) {
      item.start = planeToWork(chain_, item, {item.start.x(), item.start.y(), 0.0}).head<2>();
    }
    if (!map_.identity) transform(item);
    chain_.moveToWork(item.to);
    item.space = PathItem::Space::kWork;
  }
  return pass(item);
}

void TransformStage::transform(PathItem& item) const {
  if (item.comp_on) item.offset *= map_.sense(item.plane);
  item.join_size *= map_.joinFactor(item.plane);
  if (item.direction) {
    AxisPoint tip;
    tip[item.plane.u] = item.direction->x();
    tip[item.plane.v] = item.direction->y();
    const AxisPoint turned = map_.turned(tip);
    item.direction = Vec2(turned[item.plane.u], turned[item.plane.v]);
  }
}

bool TransformStage::transformArc(PathItem& item) {
  const Vec3 center = planeToWork(chain_, item, item.center);
  const double radius = (item.start - item.center.head<2>()).norm();
  item.start = planeToWork(chain_, item, {item.start.x(), item.start.y(), item.center.z()}).head<2>();
  item.sweep *= map_.sense(item.plane);
  if (map_.unequal(item.plane)) {
    if (!scales_centres_ || item.by_radius) return rebuildArc(item, radius, center);
    scaleCentre(item, center);
    return true;
  }
  item.center = center;
  return true;
}

/// The arc between its scaled ends about its scaled centre; its radius may change on the way.
void TransformStage::scaleCentre(PathItem& item, const Vec3& center) const {
  constexpr double kTurn = 2.0 * kPi;
  const Vec2 end = planeToWork(chain_, item, item.plane.of(item.to)).head<2>();
  const Vec2 from = item.start - center.head<2>(), to = end - center.head<2>();
  const double sense = item.sweep < 0.0 ? -1.0 : 1.0;
  const double turns = std::floor(std::abs(item.sweep) / kTurn + 1e-9);
  double part = sense * std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const bool whole = std::abs(std::abs(item.sweep) - turns * kTurn) < 1e-9;
  if (whole) {
    part = 0.0;
  } else if (part <= 0.0) {
    part += kTurn;
  }
  item.sweep = sense * (turns * kTurn + part);
  item.center = center;
}

bool TransformStage::rebuildArc(PathItem& item, double radius, const Vec3& center) {
  const Vec3 programmed = item.plane.of(item.to);
  const Vec2 end = planeToWork(chain_, item, programmed).head<2>();
  const double end_radius = (programmed.head<2>() - item.center.head<2>()).norm();
  const double turns = std::abs(item.sweep) / (2.0 * kPi);
  if (std::abs(radius - end_radius) > kSameRadius || turns > 1.0 + 1e-9) {
    return alarms_.fail("unequal-scaling",
                        "spirals and arcs of more than a turn cannot be scaled by unequal factors");
  }
  radius *= scales_centres_ ? map_.largestFactor(item.plane) : map_.radiusFactor(item.plane);
  if (turns > 1.0 - 1e-9) {  // a full circle has no chord: it keeps the direction of its centre
    const Vec2 to_center = center.head<2>() - item.start;
    item.center = center;
    item.center.head<2>() = item.start + radius * to_center.normalized();
    return true;
  }
  ArcRequest request;
  request.start = {item.start.x(), item.start.y(), 0.0};
  request.end = {end.x(), end.y(), 0.0};
  request.has_plane_end = true;
  request.counter_clockwise = item.sweep > 0.0;
  request.radius = turns > 0.5 ? -radius : radius;
  const ArcResolution arc = resolveArc(request);
  if (!arc.ok() || arc.no_motion) {
    return alarms_.fail("unequal-scaling",
                        "the scaled arc has no solution: its radius does not fit its ends");
  }
  item.center = {arc.arc.center.x(), arc.arc.center.y(), center.z()};
  item.sweep = arc.arc.sweep_rad;
  return true;
}

}  // namespace proveout::nc
