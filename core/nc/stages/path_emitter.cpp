#include "core/nc/stages/path_emitter.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/printable.h"
#include "core/nc/kinematics/machine_of.h"

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

PathEmitter::PathEmitter(const ControlSettings& settings, const AxisTable& axes, MotionSink& sink,
                         InterpretSummary& summary)
    : settings_(settings),
      summary_(summary),
      time_(sink, summary),
      axes_(axes),
      more_(axes.moreCount()),
      origin_(offsetZero(settings)),
      machine_(settings.start + origin_),
      tool_(settings.tool) {
  takeChain(machineOf(settings, axes, origin_));
  for (int k = 0; k < axes_.count(); ++k) {
    any_limit_ = any_limit_ || axes_.at(k).limit.has_value();
    if (axes_.at(k).rotary()) ++rotary_;
  }
  for (const AxisSettings& axis : settings.axes) {
    if (const int k = axes_.find(axis.name); k >= kMainAxes) machine_[k] = axis.start;
  }
  for (const auto& [tool, length] : settings.gauge_lengths) gauges_[tool] = Vec3(0.0, 0.0, length);
  for (const auto& [tool, mount] : settings.inserts) {
    if (mount.gauge) gauges_[tool] = Vec3(mount.gauge->x(), 0.0, mount.gauge->y());
  }
  placeTool();
  home_ = machine_.xyz = settings.start - to_workpiece_;
}

void PathEmitter::lowerStart(double height) {
  home_.z() = machine_.xyz.z() = std::min(machine_.xyz.z(), height);
}

void PathEmitter::takeChain(const MachineModel& model) {
  chain_ = std::make_shared<const MachineChain>(model, origin_);
  plain_ = more_ == 0 && chain_->isLevel() && chain_->toolAtZero() == Vec3::UnitZ();
}

/// The tool as it stands in the spindle of the chain.
void PathEmitter::placeTool() {
  setTool(tool_);
  if (tool_ == 0) to_workpiece_ -= alongTool(settings_.unnamed_gauge);
}

void PathEmitter::turnHead(const Vec3& direction, const Vec3& gauge) {
  MachineModel model = machineOf(settings_, axes_, origin_);
  model.spindle.direction = direction;
  model.spindle.gauge = gauge;
  takeChain(model);
  placeTool();
}

void PathEmitter::setTool(int tool) {
  tool_ = tool;
  const auto gauge = gauges_.find(tool);
  to_workpiece_ = chain_->tipAtZero(0.0);
  if (gauge != gauges_.end()) to_workpiece_ -= alongTool(gauge->second);
}

void PathEmitter::countFromNose(int tool) {
  const auto mount = settings_.inserts.find(tool);
  if (mount == settings_.inserts.end() || mount->second.gauge) return;
  gauges_[tool] = Vec3(mount->second.nose_center.x(), 0.0, mount->second.nose_center.y());
}

/// A gauge vector of a tool, whose z goes along it, as it stands in the spindle.
Vec3 PathEmitter::alongTool(const Vec3& gauge) const {
  const Vec3& axis = chain_->toolAtZero();
  if (axis == Vec3::UnitZ()) return gauge;
  return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis) * gauge;
}

Vec3 PathEmitter::toolPoint(const AxisPoint& machine) const { return chain_->point(machine, to_workpiece_); }

/// Length that the axes besides X Y Z add to a motion: mm and degrees alike, as the feed counts them.
double PathEmitter::furtherTravel(const AxisPoint& to, const AxisSet& slaves) const {
  double sum = 0.0;
  for (int k = kMainAxes; k < kMainAxes + more_; ++k) {
    if (slaves.test(static_cast<std::size_t>(k))) continue;
    const double d = to[k] - machine_[k];
    sum += d * d;
  }
  return std::sqrt(sum);
}

bool PathEmitter::plainArc(const AxisPoint& to, const MachineArc& arc, const AxisSet& slaves) const {
  const bool main = arc.plane.u < kMainAxes && arc.plane.v < kMainAxes;
  return main && furtherTravel(to, slaves) < kNoMoveMm && chain_->isLevel() && chain_->atZero(machine_);
}

double PathEmitter::furtherRapidTime(const AxisPoint& to) const {
  double slowest = 0.0;
  for (int k = kMainAxes; k < kMainAxes + more_; ++k) {
    slowest = std::max(slowest, std::abs(to[k] - machine_[k]) / axes_.at(k).rapid);
  }
  return slowest;
}

const AxisSweep* PathEmitter::sweepTo(const AxisPoint& to) {
  if (rotary_ == 0 && chain_->toolAtZero() == Vec3::UnitZ()) return nullptr;
  sweep_ = {};
  for (int k = kMainAxes; k < kMainAxes + more_ && sweep_.rotary_count < kMaxRotaryAxes; ++k) {
    if (!axes_.at(k).rotary()) continue;
    RotaryPosition& rotary = sweep_.rotary[static_cast<std::size_t>(sweep_.rotary_count++)];
    axes_.at(k).name.copy(rotary.name.data(), rotary.name.size() - 1);
    rotary.from = machine_[k];
    rotary.to = to[k];
    rotary.in_path = chain_->carries(k);
  }
  sweep_.from = chain_->toolAxis(machine_);
  sweep_.to = chain_->toolAxis(to);
  return &sweep_;
}

MotionPace PathEmitter::linePace(const AxisPoint& to, double length, double speed) const {
  MotionPace pace;
  pace.length = length;
  pace.speed = speed;
  for (int k = 0; k < axes_.count(); ++k) pace.begin[k] = (to[k] - machine_[k]) / length;
  pace.end = pace.begin;
  pace.acceleration = lineAcceleration(time_.limits(), pace.begin, axes_.count());
  return pace;
}

void PathEmitter::rapidTo(const AxisPoint& to, const SourceRef& source, double speed) {
  const Vec3 d = to.xyz - machine_.xyz;
  const double further = more_ > 0 ? furtherTravel(to) : 0.0;
  if (d.cwiseAbs().maxCoeff() < kNoMoveMm && further < kNoMoveMm) return;
  Motion m;
  m.kind = MotionKind::kRapid;
  double minutes = (d.cwiseAbs().cwiseQuotient(settings_.rapid_mm_min)).maxCoeff();
  if (more_ > 0) minutes = std::max(minutes, furtherRapidTime(to));
  m.time_s = 60.0 * minutes;
  m.source = source;
  const double length = std::hypot(d.norm(), further);
  if (speed > 0.0) {
    m.time_s = 60.0 * length / speed;
    time_.flush();  // this one has its own time
  }
  if (chain_->turns(machine_, to)) return sendTurned(m, to);
  MotionJoin join;
  join.stops = true;
  if (speed > 0.0 || !time_.wantsPace(join)) return send(m, to, nullptr);
  MotionPace pace = linePace(to, length, length / m.time_s);
  pace.rapid = true;
  send(m, to, nullptr, &pace, join);
}

void PathEmitter::lineTo(const AxisPoint& to, const FeedStyle& style, const SourceRef& source) {
  const Vec3 d = to.xyz - machine_.xyz;
  const double further = more_ > 0 ? furtherTravel(to) : 0.0;
  if (d.cwiseAbs().maxCoeff() < kNoMoveMm && further < kNoMoveMm) return;
  Motion m;
  const double length = style.paced_mm > 0.0 ? style.paced_mm
                        : further > 0.0      ? std::hypot(d.norm(), further)
                                             : d.norm();
  const bool wants_pace = style.acceleration > 0.0 || time_.wantsPace(style.join);
  const bool paced = time_.limits().feeds || wants_pace;
  MotionPace pace;
  if (paced) pace = linePace(to, length, 0.0);
  m.kind = style.kind;
  m.compensated = style.compensated;
  m.spindle = style.spindle;
  m.feed = style.feed;
  if (time_.limits().feeds) m.feed = allowedFeed(time_.limits(), pace.begin, axes_.count(), m.feed);
  if (style.kind == MotionKind::kThread) {
    m.thread_start_deg = style.thread_start_deg;
    m.thread_pitch_change = style.thread_pitch_change;
    m.spindle *= m.feed / style.feed;  // the lead stays where an axis cannot follow
  }
  m.time_s = 60.0 * length / m.feed;
  m.source = source;
  if (chain_->turns(machine_, to)) return sendTurned(m, to);
  if (!wants_pace) return send(m, to, nullptr);
  if (style.acceleration > 0.0) pace.acceleration = std::min(pace.acceleration, style.acceleration);
  pace.speed = m.feed / 60.0;
  send(m, to, nullptr, &pace, style.join);
}

std::optional<PathEmitter::Line> PathEmitter::lineOf(const AxisPoint& to, const SourceRef& source) {
  if (chain_->turns(machine_, to)) return std::nullopt;
  Line line;
  line.motion.kind = MotionKind::kFeed;
  line.motion.from = toolPoint(machine_);
  line.motion.to = toolPoint(to);
  line.motion.tool = tool_;
  line.motion.spindle = spindle_;
  line.motion.source = source;
  if (const AxisSweep* sweep = sweepTo(to)) {
    line.axis = *sweep;
    line.has_axis = true;
  }
  return line;
}

void PathEmitter::arcTo(const AxisPoint& to, const MachineArc& arc, const FeedStyle& style,
                        const SourceRef& source) {
  if (!plain_ && !plainArc(to, arc, style.slaves)) return furtherArc(to, arc, style, source);
  ArcGeometry geometry;
  const Vec3 shift = plain_ ? to_workpiece_ : Vec3(toolPoint(machine_) - machine_.xyz);
  geometry.center = arc.center + shift;
  geometry.normal = arc.normal;
  geometry.sweep_rad = arc.sweep_rad;
  const ArcFrame frame = arcFrame(machine_.xyz + shift, to.xyz + shift, geometry);
  const double length = arcLength(frame.radius_start, frame.radius_end, arc.sweep_rad, frame.rise);
  double paced = length;  // the length that the feed is the speed of
  if (style.along == FeedStyle::Along::kPlane) {
    paced = arcLength(frame.radius_start, frame.radius_end, arc.sweep_rad, 0.0);
  } else if (style.along == FeedStyle::Along::kStartRadius && frame.radius_start > 0.0) {
    paced = frame.radius_start * std::abs(arc.sweep_rad);
  }
  Motion m;
  m.kind = style.kind;
  m.compensated = style.compensated;
  m.spindle = style.spindle;
  m.time_s = 60.0 * paced / style.feed;
  m.feed = length == paced ? style.feed : 60.0 * length / m.time_s;
  m.source = source;
  m.arc = 0;
  const bool wants_pace = time_.wantsPace(style.join);
  if (!time_.limits().feeds && !wants_pace) return send(m, to, &geometry);
  const ArcPace machine{machine_.xyz, to.xyz, {arc.center, arc.normal, arc.sweep_rad}, length};
  if (time_.limits().feeds) {
    m.feed = allowedArcFeed(time_.limits(), machine, m.feed);
    m.time_s = 60.0 * length / m.feed;
  }
  if (!wants_pace) return send(m, to, &geometry);
  MotionPace pace;
  pace.length = length;
  pace.speed = m.feed / 60.0;
  setArcPace(time_.limits(), machine, pace);
  send(m, to, &geometry, &pace, style.join);
}

void PathEmitter::send(Motion& motion, const AxisPoint& to, const ArcGeometry* arc, const MotionPace* pace,
                       const MotionJoin& join) {
  const AxisSweep* sweep = nullptr;
  if (plain_) {
    motion.from = machine_.xyz + to_workpiece_;
    motion.to = to.xyz + to_workpiece_;
  } else {
    motion.from = toolPoint(machine_);
    motion.to = toolPoint(to);
    sweep = sweepTo(to);
  }
  motion.tool = tool_;
  if (motion.spindle == 0.0) motion.spindle = spindle_;
  const AxisPoint from = machine_;
  if (plain_) {
    machine_.xyz = to.xyz;
  } else {
    machine_ = to;
  }
  if (any_limit_ && (chain_->anyRotary() || !chain_->isLevel())) {
    checkMachineTravel(from, motion.source);
  } else if (any_limit_) {
    checkTravel(motion, arc, motion.source);
  }
  ++summary_.motions;
  if (pace == nullptr) {
    time_.pass(motion, arc, sweep);
  } else {
    time_.motion(motion, arc, sweep, *pace, join);
  }
}

void PathEmitter::checkTravel(const Motion& motion, const ArcGeometry* arc, const SourceRef& source) {
  Toolpath one;
  Motion copy = motion;
  if (arc) {
    one.arcs.push_back(*arc);
    copy.arc = 0;
  }
  const Box3 box = one.bounds(copy);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& limit = settings_.limits[static_cast<std::size_t>(axis)];
    if (!limit) continue;
    const double low = box.min[axis] - to_workpiece_[axis];
    const double high = box.max[axis] - to_workpiece_[axis];
    const bool below = low < limit->min - kNoMoveMm;
    if (!below && high <= limit->max + kNoMoveMm) continue;
    overtravel(axis, below ? low : high, below ? limit->min : limit->max, source);
  }
  if (more_ > 0) checkFurtherTravel(machine_, source);
}

void PathEmitter::checkMachineTravel(const AxisPoint& from, const SourceRef& source) {
  for (int axis = 0; axis < kMainAxes; ++axis) {
    const auto& limit = settings_.limits[static_cast<std::size_t>(axis)];
    if (!limit) continue;
    const double low = std::min(from[axis], machine_[axis]), high = std::max(from[axis], machine_[axis]);
    if (low < limit->min - kNoMoveMm) {
      overtravel(axis, low, limit->min, source);
    } else if (high > limit->max + kNoMoveMm) {
      overtravel(axis, high, limit->max, source);
    }
  }
  checkFurtherTravel(machine_, source);
}

void PathEmitter::checkFurtherTravel(const AxisPoint& to, const SourceRef& source) {
  for (int k = kMainAxes; k < kMainAxes + more_; ++k) {
    const auto& limit = axes_.at(k).limit;
    if (!limit) continue;
    if (to[k] < limit->min - kNoMoveMm) overtravel(k, to[k], limit->min, source);
    if (to[k] > limit->max + kNoMoveMm) overtravel(k, to[k], limit->max, source);
  }
}

void PathEmitter::overtravel(int axis, double value, double limit, const SourceRef& source) {
  event(event::Overtravel{axes_.at(axis).name, value, limit, {}}, 0.0, source);
}

void PathEmitter::event(EventKind what, double time_s, const SourceRef& source) {
  const bool stands =
      !std::holds_alternative<event::Overtravel>(what) && !std::holds_alternative<event::Output>(what);
  time_.event({std::move(what), time_s, source}, stands);
}

void PathEmitter::diagnostic(const Diagnostic& diagnostic) {
  if (diagnostic.severity == Severity::kError) ++summary_.errors;
  if (diagnostic.severity == Severity::kWarning) ++summary_.warnings;
  time_.diagnostic(diagnostic);
}

}  // namespace proveout::nc
