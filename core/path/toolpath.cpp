#include "core/path/toolpath.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/path/posed_way.h"

namespace proveout {

std::string_view motionKindName(MotionKind kind) {
  switch (kind) {
    case MotionKind::kRapid:
      return "rapid";
    case MotionKind::kFeed:
      return "feed";
    case MotionKind::kThread:
      return "thread";
    case MotionKind::kProbe:
      return "probe";
  }
  return "feed";
}

std::string_view poseLawName(PoseLaw law) {
  switch (law) {
    case PoseLaw::kVector:
      return "vector";
    case PoseLaw::kTip:
      return "tip";
    case PoseLaw::kCone:
      return "cone";
    case PoseLaw::kAxes:
      return "axes";
  }
  return "vector";
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
  // A spiral may start on its axis, where rounding leaves no direction: its end then gives it.
  constexpr double kDirectionLost = 1e-6;
  if (f.radius_start > kDirectionLost * f.radius_end) {
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
  return arc.center + f.u * (radius * std::cos(angle)) + f.v * (radius * std::sin(angle)) +
         f.n * (t * f.rise);
}

bool AxisSweep::tipLeaves() const {
  return law == PoseLaw::kAxes || (pose != nullptr && pose->beyond != 0.0);
}

/// The tip's way is a curve of its own.
static bool tipLeaves(const Toolpath& path, const Motion& m) {
  return m.axis >= 0 && path.axes[static_cast<std::size_t>(m.axis)].tipLeaves();
}

Vec3 Toolpath::pointAt(const Motion& m, double u) const {
  if (tipLeaves(*this, m)) return posedWayOf(*this, m).at(u).tip;
  if (m.arc < 0) return m.from + u * (m.to - m.from);
  PROVEOUT_ASSERT(static_cast<std::size_t>(m.arc) < arcs.size());
  const ArcGeometry& arc = arcs[m.arc];
  return arcPoint(arcFrame(m.from, m.to, arc), arc, u);
}

namespace toolpath_detail {

/// Widens `box` by the extremes of one coordinate of an arc with constant radius and no rise in that
/// coordinate: they lie where the angle is that of the coordinate's direction in the arc's plane. One turn
/// holds them all.
void extendByCircle(Box3& box, const ArcFrame& f, const ArcGeometry& arc, int axis) {
  if (arc.sweep_rad == 0.0) return;
  const double phi = std::atan2(f.v[axis], f.u[axis]);
  const double turn = std::clamp(arc.sweep_rad, -2 * kPi, 2 * kPi);
  const double lo = std::min(0.0, turn), hi = std::max(0.0, turn);
  for (int k = static_cast<int>(std::ceil((lo - phi) / kPi)); phi + k * kPi <= hi; ++k) {
    const Vec3 p = arcPoint(f, arc, std::clamp((phi + k * kPi) / arc.sweep_rad, 0.0, 1.0));
    box.min[axis] = std::min(box.min[axis], p[axis]);
    box.max[axis] = std::max(box.max[axis], p[axis]);
  }
}

/// Largest value of `value` in [a, b], where it has one maximum, by golden sections.
template <typename Value>
double largestIn(double a, double b, Value value) {
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 45; ++i) {  // 0.618^45 = 4e-10 of the interval; the value is exact to its square
    const double c = b - kGolden * (b - a), d = a + kGolden * (b - a);
    if (value(c) > value(d)) {
      b = d;
    } else {
      a = c;
    }
  }
  return value(0.5 * (a + b));
}

/// Largest value of sign * coordinate over the arc's piece [a, b], a turn at most, from samples that are
/// refined.
double largestInTurn(const ArcFrame& f, const ArcGeometry& arc, int axis, double sign, double a, double b) {
  constexpr int kSamples = 64;
  const auto value = [&](double t) { return sign * arcPoint(f, arc, t)[axis]; };
  int best = 0;
  for (int i = 1; i <= kSamples; ++i) {
    if (value(a + (b - a) * i / kSamples) > value(a + (b - a) * best / kSamples)) best = i;
  }
  const double step = (b - a) / kSamples;
  const double refined =
      largestIn(a + step * std::max(best - 1, 0), a + step * std::min(best + 1, kSamples), value);
  return std::max(refined, value(a + step * best));
}

/// Whether the coordinate only grows or only falls along the arc, for sure: its derivative in the middle is
/// more than it can change by up to the ends.
bool isMonotonic(const ArcFrame& f, const ArcGeometry& arc, int axis) {
  const double sweep = arc.sweep_rad, growth = f.radius_end - f.radius_start;
  const double radius = f.radius_start + 0.5 * growth, c = std::cos(0.5 * sweep), s = std::sin(0.5 * sweep);
  const double rate = growth * (f.u[axis] * c + f.v[axis] * s) +
                      radius * sweep * (f.v[axis] * c - f.u[axis] * s) + f.n[axis] * f.rise;
  const double most = 2.0 * std::abs(growth * sweep) + std::max(f.radius_start, f.radius_end) * sweep * sweep;
  return std::abs(rate) > 0.5 * most;
}

/// Spirals and helices that rise in the coordinate. At a given phase the coordinate is linear in the number
/// of the turn, so that every extreme lies in the first turn or in the last.
void extendBySpiral(Box3& box, const ArcFrame& f, const ArcGeometry& arc, int axis) {
  if (isMonotonic(f, arc, axis)) return;  // the ends are in the box
  const double turn = std::min(1.0, 2 * kPi / std::max(std::abs(arc.sweep_rad), 1e-12));
  for (const double start : {0.0, 1.0 - turn}) {
    const double end = std::min(1.0, start + turn);
    box.max[axis] = std::max(box.max[axis], largestInTurn(f, arc, axis, 1.0, start, end));
    box.min[axis] = std::min(box.min[axis], -largestInTurn(f, arc, axis, -1.0, start, end));
  }
}

}  // namespace toolpath_detail

Box3 Toolpath::bounds(const Motion& m) const {
  if (tipLeaves(*this, m)) return posedWayOf(*this, m).tipBounds(0.0, 1.0);
  Box3 box;
  box.extend(m.from);
  box.extend(m.to);
  if (m.arc < 0) return box;
  PROVEOUT_ASSERT(static_cast<std::size_t>(m.arc) < arcs.size());
  const ArcGeometry& arc = arcs[m.arc];
  const ArcFrame f = arcFrame(m.from, m.to, arc);
  const bool spiral = f.radius_end != f.radius_start;
  for (int axis = 0; axis < 3; ++axis) {
    if (spiral || f.n[axis] * f.rise != 0.0) {
      toolpath_detail::extendBySpiral(box, f, arc, axis);
    } else {
      toolpath_detail::extendByCircle(box, f, arc, axis);
    }
  }
  return box;
}

double Toolpath::length(const Motion& m) const {
  if (tipLeaves(*this, m)) return posedWayOf(*this, m).length();
  if (m.arc < 0) return (m.to - m.from).norm();
  PROVEOUT_ASSERT(static_cast<std::size_t>(m.arc) < arcs.size());
  const ArcGeometry& arc = arcs[m.arc];
  const ArcFrame f = arcFrame(m.from, m.to, arc);
  const double dr = f.radius_end - f.radius_start;
  const double s = std::abs(arc.sweep_rad);
  const double k2 = dr * dr + f.rise * f.rise;
  const auto speedAt = [&](double r) { return std::sqrt(r * r * s * s + k2); };
  // The radius hardly changes: Simpson's rule is exact to far below 1e-9, the closed form would cancel.
  if (std::abs(dr) <= 0.01 * std::max(f.radius_start, f.radius_end) || s == 0.0) {
    const double middle = 0.5 * (f.radius_start + f.radius_end);
    return (speedAt(f.radius_start) + 4.0 * speedAt(middle) + speedAt(f.radius_end)) / 6.0;
  }
  const auto integral = [&](double r) {
    return 0.5 * r * speedAt(r) + 0.5 * k2 / s * std::asinh(r * s / std::sqrt(k2));
  };
  return (integral(f.radius_end) - integral(f.radius_start)) / dr;
}

double threadTurns(const Toolpath& path, const Motion& motion) {
  if (motion.kind != MotionKind::kThread || !(motion.feed > 0.0)) return 0.0;
  return path.length(motion) / motion.feed * std::abs(motion.spindle);
}

void ToolpathBuilder::file(std::uint32_t index, const std::string& name) {
  if (path_.files.size() <= index) path_.files.resize(index + 1);
  path_.files[index] = name;
}

void ToolpathBuilder::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
  path_.motions.push_back(motion);
  Motion& kept = path_.motions.back();
  kept.arc = -1;
  if (arc != nullptr) {
    kept.arc = static_cast<std::int32_t>(path_.arcs.size());
    path_.arcs.push_back(*arc);
  }
  kept.axis = -1;
  if (axis != nullptr) {
    kept.axis = static_cast<std::int32_t>(path_.axes.size());
    path_.axes.push_back(*axis);
  }
}

void ToolpathBuilder::wireMotion(const Motion& motion, const WireSweep& wire) {
  path_.motions.push_back(motion);
  Motion& kept = path_.motions.back();
  kept.arc = kept.axis = -1;
  kept.wire = static_cast<std::int32_t>(path_.wires.size());
  path_.wires.push_back(wire);
}

void ToolpathBuilder::event(const PathEvent& event) {
  path_.events.push_back({static_cast<MotionId>(path_.motions.size()), event});
}

void ToolpathBuilder::diagnostic(const Diagnostic& diagnostic) { path_.diagnostics.add(diagnostic); }

void ToolpathBuilder::originWord(const WordOrigin& word) { path_.origins.words.push_back(word); }
void ToolpathBuilder::originData(const DataInForce& data) { path_.origins.data.push_back(data); }
void ToolpathBuilder::originModal(const ModalOrigins& modal) { path_.origins.modal.push_back(modal); }
void ToolpathBuilder::originSet(const OriginSet& set) { path_.origins.sets.push_back(set); }

}  // namespace proveout
