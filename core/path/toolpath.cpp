#include "core/path/toolpath.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout {

std::string_view motionKindName(MotionKind kind) {
  switch (kind) {
    case MotionKind::kRapid:
      return "rapid";
    case MotionKind::kFeed:
      return "feed";
    case MotionKind::kThread:
      return "thread";
  }
  return "feed";
}

ArcFrame arcFrame(const Vec3& from, const Vec3& to, const ArcGeometry& arc) {
  ArcFrame f;
  f.n = arc.normal;
  const auto radial = [&](const Vec3& p) -> Vec3 {
    const Vec3 d = p - arc.center;
    return d - f.n * f.n.dot(d);
  };
  const Vec3 start = radial(from);
  const Vec3 end = radial(to);
  f.radius_start = start.norm();
  f.radius_end = end.norm();
  f.rise = f.n.dot(to - from);
  // A spiral may start on its axis: its end then gives the direction.
  if (f.radius_start > 0.0) {
    f.u = start / f.radius_start;
  } else if (f.radius_end > 0.0) {
    f.u = Eigen::AngleAxisd(-arc.sweep_rad, f.n) * (end / f.radius_end);
  } else {
    f.u = f.n.unitOrthogonal();
  }
  f.v = f.n.cross(f.u);
  return f;
}

Vec3 arcPoint(const ArcFrame& f, const ArcGeometry& arc, double t) {
  const double angle = t * arc.sweep_rad;
  const double radius = f.radius_start + t * (f.radius_end - f.radius_start);
  return arc.center + f.u * (radius * std::cos(angle)) + f.v * (radius * std::sin(angle)) + f.n * (t * f.rise);
}

Vec3 Toolpath::pointAt(const Motion& m, double u) const {
  if (m.arc < 0) return m.from + u * (m.to - m.from);
  const ArcGeometry& arc = arcs[m.arc];
  return arcPoint(arcFrame(m.from, m.to, arc), arc, u);
}

Box3 Toolpath::bounds(const Motion& m) const {
  Box3 box;
  box.extend(m.from);
  box.extend(m.to);
  if (m.arc < 0) return box;
  const ArcGeometry& arc = arcs[m.arc];
  const ArcFrame f = arcFrame(m.from, m.to, arc);
  // Per coordinate the path is center + rho(t) * A cos(a - phi) + rise * t. The circle of the larger radius at every
  // angle where the cosine has its extreme bounds it; exact for plane circles and axis-aligned helices.
  for (int axis = 0; axis < 3; ++axis) {
    const double phi = std::atan2(f.v[axis], f.u[axis]);
    const double lo = std::min(0.0, arc.sweep_rad), hi = std::max(0.0, arc.sweep_rad);
    for (int k = static_cast<int>(std::ceil((lo - phi) / kPi)); phi + k * kPi <= hi; ++k) {
      const double t = arc.sweep_rad != 0.0 ? (phi + k * kPi) / arc.sweep_rad : 0.0;
      box.extend(arcPoint(f, arc, std::clamp(t, 0.0, 1.0)));
    }
  }
  const bool spiral = std::abs(f.radius_end - f.radius_start) > 1e-12;
  const bool tilted = std::abs(f.rise) > 0.0 && f.n.cwiseAbs().maxCoeff() < 1.0 - 1e-12;
  if (spiral || tilted) {  // extremes move away from the cosine's: grow by the bound of one turn's change
    const double turns = std::max(std::abs(arc.sweep_rad) / (2 * kPi), 1e-9);
    const double slack = std::abs(f.radius_end - f.radius_start) / std::max(turns, 0.25) +
                         (tilted ? std::abs(f.rise) / std::max(turns, 0.25) : 0.0);
    return box.inflated(std::min(slack, std::max(f.radius_start, f.radius_end) + std::abs(f.rise)));
  }
  return box;
}

double Toolpath::length(const Motion& m) const {
  if (m.arc < 0) return (m.to - m.from).norm();
  const ArcGeometry& arc = arcs[m.arc];
  const ArcFrame f = arcFrame(m.from, m.to, arc);
  const double dr = f.radius_end - f.radius_start;
  const auto speed = [&](double t) {
    const double r = f.radius_start + t * dr;
    return std::sqrt(r * r * arc.sweep_rad * arc.sweep_rad + dr * dr + f.rise * f.rise);
  };
  if (dr == 0.0) return speed(0.0);
  const int n = 64;  // even; the integrand is smooth, so Simpson's error is far below 1e-9
  double sum = speed(0.0) + speed(1.0);
  for (int i = 1; i < n; ++i) sum += speed(static_cast<double>(i) / n) * (i % 2 ? 4.0 : 2.0);
  return sum / (3.0 * n);
}

void ToolpathBuilder::file(std::uint32_t index, const std::string& name) {
  if (path_.files.size() <= index) path_.files.resize(index + 1);
  path_.files[index] = name;
}

void ToolpathBuilder::motion(const Motion& motion, const ArcGeometry* arc) {
  path_.motions.push_back(motion);
  Motion& kept = path_.motions.back();
  kept.arc = -1;
  if (arc != nullptr) {
    kept.arc = static_cast<std::int32_t>(path_.arcs.size());
    path_.arcs.push_back(*arc);
  }
}

void ToolpathBuilder::event(const PathEvent& event) {
  path_.events.push_back({static_cast<MotionId>(path_.motions.size()), event});
}

void ToolpathBuilder::diagnostic(const Diagnostic& diagnostic) { path_.diagnostics.add(diagnostic); }

}  // namespace proveout
