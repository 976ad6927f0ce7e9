#include "core/nc/iso/stages/virtual_stage.h"

#include <algorithm>
#include <cmath>

#include "core/nc/services/virtual_plane.h"

namespace proveout::nc {
namespace {

/// Nearer to the centre there is no direction, mm.
constexpr double kCenterMm = 1e-9;

}  // namespace

void VirtualStage::begin(const AxisModal& modal, const AxisPoint& position, const AxisPoint& machine) {
  modal_ = modal;
  plane_.linear = modal.linear;
  plane_.rotary = modal.rotary;
  place(chain_.workOf(position));
  plane_.sign = machine[plane_.linear] < plane_.zero ? -1.0 : 1.0;
  pipe_.link(*this);
}

void VirtualStage::end() { pipe_.unlink(*this); }

/// Finds the plane's origin for motions in the frames in force.
void VirtualStage::place(const AxisPoint& work) {
  work_zero_ = frames_.shift52[plane_.linear] + frames_.shift92[plane_.linear];
  work_zero_deg_ = frames_.shift52[plane_.rotary] + frames_.shift92[plane_.rotary];
  AxisPoint origin = work;
  origin[plane_.linear] = work_zero_;
  origin[plane_.rotary] = work_zero_deg_;
  chain_.moveToMachine(origin);
  plane_.zero = origin[plane_.linear];
  plane_.zero_deg = origin[plane_.rotary];
}

AxisPoint VirtualStage::shown(const AxisPoint& machine) const {
  AxisPoint shown = machine;
  if (modal_.mode == VirtualMode::kPolar) {
    const Vec2 p = plane_.of(machine);
    shown[plane_.linear] = plane_.zero + p.x();
    shown[plane_.rotary] = plane_.zero_deg + p.y();
  } else {
    shown[plane_.rotary] =
        plane_.zero_deg + (machine[plane_.rotary] - plane_.zero_deg) * modal_.mmPerDegree();
  }
  return shown;
}

AxisPoint VirtualStage::adopt(const AxisPoint& machine) {
  machine_ = machine;
  const AxisPoint counted = shown(machine);
  last_ = chain_.workOf(chain_.programOf(counted));
  return counted;
}

bool VirtualStage::push(PathItem& item) {
  const bool motion = item.kind == PathItem::Kind::kLine || item.kind == PathItem::Kind::kArc;
  if (!motion || item.space != PathItem::Space::kWork) return pass(item);
  place(item.to);
  return modal_.mode == VirtualMode::kPolar ? pushPolar(item) : pushCylinder(item);
}

bool VirtualStage::pushPolar(PathItem& item) {
  const Vec2 zero(work_zero_, work_zero_deg_);
  const Vec2 from = Vec2(last_[plane_.linear], last_[plane_.rotary]) - zero;
  const Vec2 to = Vec2(item.to[plane_.linear], item.to[plane_.rotary]) - zero;
  last_ = item.to;
  const bool arc = item.kind == PathItem::Kind::kArc;
  if (arc) item.center.head<2>() -= zero;
  double angle = machine_[plane_.rotary] - plane_.zero_deg;
  angle += radToDeg(arc ? turnOfArc(from, to, item.center.head<2>(), item.sweep) : turnOfLine(from, to));
  if (to.norm() > kCenterMm) {
    const double exact = radToDeg(std::atan2(plane_.sign * to.y(), plane_.sign * to.x()));
    angle += std::remainder(exact - angle, 360.0);
  }
  item.to[plane_.linear] = work_zero_ + plane_.sign * to.norm();
  item.to[plane_.rotary] = work_zero_deg_ + angle;
  chain_.moveToMachine(item.to);
  item.space = PathItem::Space::kMachine;
  item.in_polar = true;
  item.polar = plane_;
  machine_ = item.to;
  return pass(item);
}

bool VirtualStage::pushCylinder(PathItem& item) {
  const AxisPoint from = last_, to = item.to;
  last_ = to;
  const auto distance = [&](const AxisPoint& a, const AxisPoint& b) {
    double sum = 0.0;
    for (int k = 0; k < axes_.count(); ++k) sum += (b[k] - a[k]) * (b[k] - a[k]);
    return std::sqrt(sum);
  };
  if (item.kind == PathItem::Kind::kLine) return sendUnrolled(item, distance(from, to));
  const WorkPlane plane = item.plane;
  const Vec2 center = item.center.head<2>(), p0 = plane.of(from).head<2>(), p1 = plane.of(to).head<2>();
  const auto at = [&](double t) -> Vec3 {
    const Vec2 p = pointOfArc(p0, p1, center, item.sweep, t);
    return {p.x(), p.y(), 0.0};
  };
  AxisPoint last = from;
  bool good = true;
  const auto chord = [&](double t) {
    AxisPoint point = to;
    if (t < 1.0) {
      for (int k = 0; k < axes_.count(); ++k) point[k] = from[k] + (to[k] - from[k]) * t;
      const Vec3 p = at(t);
      point[plane.u] = p.x();
      point[plane.v] = p.y();
    }
    PathItem line = item.copyMotion();
    line.kind = PathItem::Kind::kLine;
    line.to = point;
    good = good && sendUnrolled(line, distance(last, point));
    last = point;
  };
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(item.sweep) / kCurvePieceRad)));
  divideCurve(at, pieces, kCurveChordMm, chord);
  return good;
}

bool VirtualStage::sendUnrolled(PathItem& item, double paced) {
  item.to[plane_.rotary] = work_zero_deg_ + (item.to[plane_.rotary] - work_zero_deg_) / modal_.mmPerDegree();
  item.feed.paced_mm = paced;
  chain_.moveToMachine(item.to);
  item.space = PathItem::Space::kMachine;
  machine_ = item.to;
  return pass(item);
}

}  // namespace proveout::nc
