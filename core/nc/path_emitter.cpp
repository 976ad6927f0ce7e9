#include "core/nc/path_emitter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout::nc {
namespace {

/// Moves shorter than this are none: a thousandth of the control's internal increment (1e-6 mm), above the
/// rounding noise of the coordinate chain.
constexpr double kNoMoveMm = 1e-9;

}  // namespace

double arcLength(double radius_start, double radius_end, double sweep_rad, double rise) {
  const double sweep = std::abs(sweep_rad);
  const double change = radius_end - radius_start;
  const double k = change / sweep;
  const double c2 = k * k + (rise / sweep) * (rise / sweep);
  const auto speed = [&](double r) { return std::sqrt(r * r + c2); };
  if (std::abs(change) < 1e-2 * std::max(radius_start, radius_end)) {
    // The closed form loses digits here; Simpson's error is below 1e-12 of the length.
    const double middle = speed(0.5 * (radius_start + radius_end));
    return sweep * (speed(radius_start) + 4 * middle + speed(radius_end)) / 6.0;
  }
  const double c = std::sqrt(c2);
  const auto primitive = [&](double r) { return 0.5 * (r * speed(r) + c2 * std::asinh(r / c)); };
  return std::abs((primitive(radius_end) - primitive(radius_start)) / k);
}

std::string jsonNumber(double value) { return fmt::format("{}", value == 0.0 ? 0.0 : value); }

std::string jsonString(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

PathEmitter::PathEmitter(const ControlSettings& settings, MotionSink& sink, InterpretSummary& summary)
    : settings_(settings),
      sink_(sink),
      summary_(summary),
      origin_(settings.work_offsets[0] + settings.common_offset),
      machine_(settings.start + origin_) {
  for (const auto& limit : settings.limits) any_limit_ = any_limit_ || limit.has_value();
  setTool(0);
}

void PathEmitter::setTool(int tool) {
  tool_ = tool;
  const auto gauge = settings_.gauge_lengths.find(tool);
  to_workpiece_ = -origin_;
  if (gauge != settings_.gauge_lengths.end()) to_workpiece_.z() -= gauge->second;
}

void PathEmitter::rapidTo(const Vec3& to, const SourceRef& source) {
  const Vec3 d = to - machine_;
  if (d.cwiseAbs().maxCoeff() < kNoMoveMm) return;
  Motion m;
  m.kind = MotionKind::kRapid;
  m.time_s = 60.0 * (d.cwiseAbs().cwiseQuotient(settings_.rapid_mm_min)).maxCoeff();
  m.source = source;
  summary_.rapid_s += m.time_s;
  send(m, to, nullptr);
}

void PathEmitter::lineTo(const Vec3& to, const FeedStyle& style, const SourceRef& source) {
  const Vec3 d = to - machine_;
  if (d.cwiseAbs().maxCoeff() < kNoMoveMm) return;
  Motion m;
  m.kind = style.kind;
  m.feed = style.feed;
  m.time_s = 60.0 * d.norm() / style.feed;
  m.source = source;
  summary_.cutting_s += m.time_s;
  send(m, to, nullptr);
}

void PathEmitter::arcTo(const Vec3& to, const MachineArc& arc, const FeedStyle& style,
                        const SourceRef& source) {
  ArcGeometry geometry;
  geometry.center = arc.center + to_workpiece_;
  geometry.normal = arc.normal;
  geometry.sweep_rad = arc.sweep_rad;
  const ArcFrame frame = arcFrame(machine_ + to_workpiece_, to + to_workpiece_, geometry);
  const double length = arcLength(frame.radius_start, frame.radius_end, arc.sweep_rad, frame.rise);
  double paced = length;  // the length that the feed is the speed of
  if (style.along == FeedStyle::Along::kPlane) {
    paced = arcLength(frame.radius_start, frame.radius_end, arc.sweep_rad, 0.0);
  } else if (style.along == FeedStyle::Along::kStartRadius && frame.radius_start > 0.0) {
    paced = frame.radius_start * std::abs(arc.sweep_rad);
  }
  Motion m;
  m.kind = style.kind;
  m.time_s = 60.0 * paced / style.feed;
  m.feed = length == paced ? style.feed : 60.0 * length / m.time_s;
  m.source = source;
  m.arc = 0;
  summary_.cutting_s += m.time_s;
  send(m, to, &geometry);
}

void PathEmitter::send(Motion& motion, const Vec3& to, const ArcGeometry* arc) {
  motion.from = machine_ + to_workpiece_;
  motion.to = to + to_workpiece_;
  motion.tool = tool_;
  motion.spindle = spindle_;
  machine_ = to;
  if (any_limit_) checkTravel(motion, arc, motion.source);
  summary_.cycle_s += motion.time_s;
  ++summary_.motions;
  sink_.motion(motion, arc);
}

void PathEmitter::checkTravel(const Motion& motion, const ArcGeometry* arc, const SourceRef& source) {
  Toolpath one;
  Motion copy = motion;
  if (arc) {
    one.arcs.push_back(*arc);
    copy.arc = 0;
  }
  const Box3 box = one.bounds(copy);
  constexpr std::string_view kNames = "XYZ";
  for (int axis = 0; axis < 3; ++axis) {
    const auto& limit = settings_.limits[static_cast<std::size_t>(axis)];
    if (!limit) continue;
    const double low = box.min[axis] - to_workpiece_[axis];
    const double high = box.max[axis] - to_workpiece_[axis];
    const bool below = low < limit->min - kNoMoveMm;
    if (!below && high <= limit->max + kNoMoveMm) continue;
    event("overtravel",
          {{"axis", jsonString(kNames.substr(static_cast<std::size_t>(axis), 1))},
           {"value", jsonNumber(below ? low : high)},
           {"limit", jsonNumber(below ? limit->min : limit->max)}},
          0.0, source);
  }
}

void PathEmitter::event(std::string name, EventData data, double time_s, const SourceRef& source) {
  summary_.cycle_s += time_s;
  sink_.event({std::move(name), std::move(data), time_s, source});
}

void PathEmitter::diagnostic(const Diagnostic& diagnostic) {
  if (diagnostic.severity == Severity::kError) ++summary_.errors;
  if (diagnostic.severity == Severity::kWarning) ++summary_.warnings;
  sink_.diagnostic(diagnostic);
}

}  // namespace proveout::nc
