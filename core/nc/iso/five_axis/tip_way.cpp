#include "core/nc/iso/five_axis/tip_way.h"

#include "core/nc/services/virtual_plane.h"

namespace proveout::nc {

AxisPoint TipWay::programAt(double share) const {
  AxisPoint p = between(from_, plan_.motion.target, share);
  if (share >= 1.0) return p;
  if (plan_.motion.pivot_mm != 0.0) p.xyz = pivoted(p);
  if (!plan_.motion.is_arc) return p;
  const PlaneArc& arc = plan_.motion.arc;
  const Vec2 uv = pointOfArc(arc.start.head<2>(), arc.end.head<2>(), arc.center, arc.sweep_rad, share);
  p[plane_.u] = uv.x();
  p[plane_.v] = uv.y();
  return p;
}

/// Of the tool where the rotary axes are those of a programmed point, in programmed coordinates.
Vec3 TipWay::directionAt(const AxisPoint& program) const {
  const CoordinateChain chain = c_.chainOf(plan_.next, kTablesAtZero);  // the direction's frame
  const Vec3 t = c_.five_axes.toolVector(c_.five_axes.at(c_.chain.machineOf(program)));
  return chain.toProgram(t) - chain.toProgram(Vec3::Zero());
}

Vec3 TipWay::pivoted(const AxisPoint& to) const {
  return from_.xyz + plan_.motion.pivot_mm * (directionAt(to) - directionAt(from_));
}

AxisPoint TipWay::machineAt(double share) const {
  const AxisPoint p = programAt(share);
  return machineOf(p, c_.chain.machineOf(p));
}

AxisPoint TipWay::machineAt(double share, const RotaryAngles& angles) const {
  AxisPoint p = programAt(share), there = c_.chain.machineOf(p);
  setAngles(c_.five_axes, angles, there);
  p.more = c_.chain.programOf(there).more;
  return machineOf(p, there);
}

double TipWay::length() const {
  const AxisPoint& end = plan_.motion.target;
  if (plan_.motion.pivot_mm != 0.0) {
    constexpr int kChords = 64;
    double sum = 0.0;
    for (int i = 0; i < kChords; ++i)
      sum += (programAt((i + 1.0) / kChords).xyz - programAt(static_cast<double>(i) / kChords).xyz).norm();
    return scale() * sum;
  }
  if (!plan_.motion.is_arc) return (c_.chain.workOf(end).xyz - c_.chain.workOf(from_).xyz).norm();
  const PlaneArc& arc = plan_.motion.arc;
  return scale() * arcLength(arc.startRadius(), arc.endRadius(), arc.sweep_rad, arc.end.z() - arc.start.z());
}

/// Of the program's scaling: arcs keep to the same factor in all directions.
double TipWay::scale() const {
  return (c_.chain.toWork(Vec3::UnitX()) - c_.chain.toWork(Vec3::Zero())).norm();
}

PoseTrack::Arc TipWay::arc(const AxisPoint& angles) const {
  const PlaneArc& arc = plan_.motion.arc;
  AxisPoint center = from_;
  center[plane_.u] = arc.center.x();
  center[plane_.v] = arc.center.y();
  AxisPoint along_u = center, along_v = center;
  along_u[plane_.u] += 1.0;
  along_v[plane_.v] += 1.0;
  PoseTrack::Arc out;
  out.center = out.above = machineOf(center, angles);
  // The normal about which the sweep is right-handed, mirrored or not.
  const Vec3 u = machineOf(along_u, angles).xyz - out.center.xyz,
             v = machineOf(along_v, angles).xyz - out.center.xyz;
  out.above.xyz += u.cross(v).normalized();
  out.sweep_rad = arc.sweep_rad;
  return out;
}

}  // namespace proveout::nc
