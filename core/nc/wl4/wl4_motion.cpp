// Motions of the WL4 control.
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/nc/services/arcs.h"
#include "core/nc/services/plane_curves.h"
#include "core/nc/wl4/wl4_control.h"
#include "core/tool/tip.h"

namespace proveout::nc {

namespace {

constexpr double kQuarterTolerance = 0.01;  ///< mm, of the legs of G12 and G13

/// An angle in 0 <= angle < 360, degrees.
float turnedTo(double degrees) {
  const double rest = std::fmod(degrees, 360.0);
  const auto angle = static_cast<float>(rest < 0.0 ? rest + 360.0 : rest);
  return angle < 360.0F ? angle : 0.0F;
}

}  // namespace

Vec2 Wl4Control::tipOf(const Wl4State& s) const {
  const Wl4Parameters::Tool& tool = parameters_.tool(s.selected_tool);
  if (!lathe_ || tool.at_center) return Vec2::Zero();
  const Vec2 tip = tipDirection(tool.tip);
  return tool.nose_radius * Vec2(tip.y(), tip.x());
}

PlaneFrame Wl4Control::plane(const Wl4State& s) const {
  return PlaneFrame(s.plane == 17 ? Plane::kXY : s.plane == 18 ? Plane::kZX : Plane::kYZ);
}

/// Whether "clockwise" and "left" of the program are the other way round in the plane (u, v).
bool Wl4Control::flipped(const Wl4State& s) const {
  const PlaneFrame f = plane(s);
  bool flip = s.plane == 18 && !parameters_.g18_zx;
  for (const int axis : {f.u(), f.v()}) flip = flip != s.mirrored[static_cast<std::size_t>(axis)];
  return flip;
}

double Wl4Control::compRadius(const Wl4State& s) const {
  double radius = lathe_ ? parameters_.tool(s.selected_tool).nose_radius : 0.0;
  const auto row = settings_.radius_offsets.find(s.d);
  if (row != settings_.radius_offsets.end()) radius += row->second.geometry + row->second.wear;
  return radius;
}

bool Wl4Control::move(const Plan& p) {
  if (p.measures) return measure(p);
  if (p.next.motion != 32) thread_angle_.reset();
  switch (p.next.motion) {
    case 0:
    case 1:
      return straight(p, p.next.motion == 0);
    case 2:
    case 3:
      return arc(p);
    case 12:
    case 13:
      return corner(p);
    default:
      return thread(p);
  }
}

void Wl4Control::fill(const Plan& p, PathItem& item) const {
  const Wl4State& s = p.next;
  item.space = PathItem::Space::kWork;
  item.plane = WorkPlane(plane(s));
  item.to = p.target;
  item.in_plane =
      p.named[static_cast<std::size_t>(item.plane.u)] || p.named[static_cast<std::size_t>(item.plane.v)];
  item.comp_on = s.radius != 40;
  const double side = (s.radius == 41) != flipped(s) ? 1.0 : -1.0;
  item.offset = item.comp_on ? side * compRadius(s) : 0.0;
  item.start = item.plane.of(machine_).head<2>();
  AxisPoint level = machine_;
  level[item.plane.u] = item.to[item.plane.u];
  level[item.plane.v] = item.to[item.plane.v];
  item.level = level == item.to;
  item.source = here();
}

bool Wl4Control::send(const Plan& p, PathItem& item) {
  if (p.chamfer > 0.0) {
    item.join = PathItem::Join::kChamfer;
    item.join_size = p.chamfer;
    corner_stage_.announce();
  }
  if (item.comp_on && compRadius(p.next) < 0.0 && lathe_) {
    return fail("wl4-radius", "the nose radius and the corrector D are negative together");
  }
  if (item.comp_on && !comp_stage_.linked()) {
    const Vec2 tip = tipOf(p.next);
    comp_stage_.setTip({tip.y(), 0.0, tip.x()});
    comp_stage_.engage(corner_stage_.sentUntil(item.plane.of(machine_)), parameters_.arc_threshold);
  }
  if (!pipe_.push(item)) return false;
  machine_ = p.target;
  return true;
}

bool Wl4Control::feedOf(const Plan& p, FeedStyle& feed) {
  const Wl4State& s = p.next;
  feed.join.stops = p.exact_stop || s.stop != 64;
  if (!(s.feed > 0.0)) return fail("wl4-feed", "the feed is zero: F is missing");
  feed.feed = s.feed;
  if (s.feed_mode == 95) {
    const double from = 2.0 * (machine_[0] - state_.acting[0]), to = 2.0 * (p.target[0] - s.acting[0]);
    double n = state_.turns() ? meanRpm(s, from, to) : 0.0;
    if (state_.turns()) warnOfUnlimitedSpeed(s, from, to);
    if (s.speed_mode == 96) feed.spindle = state_.spindle == 4 ? -n : n;
    if (!(n > 0.0)) {
      warnOnce("feed without spindle", "wl4-spindle-off",
               fmt::format("feed per revolution while the spindle stands: timed at {} 1/min",
                           settings_.default_spindle_rpm));
      n = settings_.default_spindle_rpm;
    }
    feed.feed *= n;
  }
  if (feed.feed > parameters_.max_feed) {
    warnOnce("max feed", "wl4-max-feed",
             fmt::format("the feed is limited to {} mm/min (MAX_FEED)", parameters_.max_feed));
    feed.feed = parameters_.max_feed;
  }
  return true;
}

bool Wl4Control::straight(const Plan& p, bool rapid) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  fill(p, item);
  item.rapid = rapid;
  if (rapid) {
    item.feed.join.stops = true;
  } else if (!feedOf(p, item.feed)) {
    return false;
  }
  return send(p, item);
}

bool Wl4Control::pushArc(const Plan& p, const Vec2& center, double sweep) {
  PathItem item;
  item.kind = PathItem::Kind::kArc;
  fill(p, item);
  item.center = Vec3(center.x(), center.y(), machine_[item.plane.w]);
  item.sweep = sweep;
  return feedOf(p, item.feed) && send(p, item);
}

bool Wl4Control::arc(const Plan& p) {
  PlaneArc arc;
  bool moves = false;
  if (!arcOf(p, arc, moves)) return false;
  return !moves || pushArc(p, arc.center, arc.sweep_rad);
}

bool Wl4Control::arcOf(const Plan& p, PlaneArc& arc, bool& moves) {
  const Wl4State& s = p.next;
  const PlaneFrame f = plane(s);
  const WorkPlane w(f);
  ArcRequest request;
  request.start = w.of(machine_);
  request.end = w.of(p.target);
  request.has_plane_end =
      p.named[static_cast<std::size_t>(f.u())] || p.named[static_cast<std::size_t>(f.v())];
  request.has_other_axis = p.named.count() > 0 && !request.has_plane_end;
  request.counter_clockwise = (s.motion == 3) != flipped(s);
  constexpr std::string_view kCenters = "IJK";
  const auto center = [&](int axis) -> std::optional<double> {
    const char letter = kCenters[static_cast<std::size_t>(axis)];
    if (!block_.has(letter)) return std::nullopt;
    return s.sign(axis) * block_.value(letter);
  };
  request.center_u = center(f.u());
  request.center_v = center(f.v());
  request.center_word_outside_plane = block_.has(kCenters[static_cast<std::size_t>(f.w())]);
  if (block_.has('R')) {
    const double radius = block_.value('R');
    const double chord = (request.end - request.start).head<2>().norm();
    if (!(radius > 0.0)) return fail("wl4-radius-word", "R of an arc has to be positive", block_.at('R'));
    if (chord > 2.0 * radius + kQuarterTolerance) {
      return fail("wl4-arc", fmt::format("the end is {:.3f} mm away: R{} does not reach it", chord, radius),
                  block_.at('R'));
    }
    request.radius = std::max(radius, 0.5 * chord);
    if (request.center_u || request.center_v) {
      warn("wl4-arc", "R and a centre in one block: R counts", block_.at('R'));
    }
  }
  const ArcResolution resolved = resolveArc(request);
  switch (resolved.error) {
    case ArcError::kNone:
      break;
    case ArcError::kNoDefinition:
      return fail("wl4-arc",
                  block_.hasCode(s.motion)
                      ? std::string("an arc needs its centre (two of I J K) or R")
                      : fmt::format("G{} of an earlier block still holds, and an arc needs its centre "
                                    "(two of I J K) or R; for a line program G1",
                                    s.motion));
    case ArcError::kCenterOutsidePlane:
      return fail("wl4-arc", "the centre is given outside the plane of G17, G18 or G19");
    case ArcError::kRadiusDifference:
      return fail("wl4-arc",
                  fmt::format("the end is off the circle by {:.4f} mm", resolved.radius_difference));
    default:
      return fail("wl4-arc", "these words give no arc");
  }
  moves = !resolved.no_motion;
  arc = resolved.arc;
  return true;
}

bool Wl4Control::corner(const Plan& p) {
  Vec2 center;
  double sweep = 0.0;
  return cornerOf(p, center, sweep) && pushArc(p, center, sweep);
}

bool Wl4Control::cornerOf(const Plan& p, Vec2& center, double& sweep) {
  const WorkPlane w(plane(p.next));
  if (!p.named[static_cast<std::size_t>(w.u)] || !p.named[static_cast<std::size_t>(w.v)] ||
      p.named.count() != 2) {
    return fail("wl4-corner-arc", "G12 and G13 need the end on both axes of the plane and no other word");
  }
  const Vec2 from = w.of(machine_).head<2>(), to = w.of(p.target).head<2>(), d = to - from;
  if (std::abs(std::abs(d.x()) - std::abs(d.y())) > kQuarterTolerance || d.norm() < 1e-6) {
    return fail("wl4-corner-arc",
                fmt::format("G12 and G13 are quarter circles: the way is {:.3f} and {:.3f} mm",
                            std::abs(d.x()), std::abs(d.y())));
  }
  const bool ccw = (p.next.motion == 13) != flipped(p.next);
  const double turn = ccw ? 1.0 : -1.0;
  center = Vec2(from.x(), to.y());
  const Vec2 arm = from - center, other = to - center;
  if (turn * cross2(arm, other) < 0.0) center = Vec2(to.x(), from.y());
  sweep = turn * kPi / 2.0;
  return true;
}

bool Wl4Control::thread(const Plan& p) {
  const Wl4State& s = p.next;
  const bool turns = state_.turns();
  double n = turns ? rpm(s, 2.0 * (machine_[0] - s.acting[0])) : 0.0;
  const double spindle_rpm = state_.spindle == 4 ? -n : n;  // 0: what cuts then cuts no thread
  if (!(n > 0.0)) {
    warnOnce(
        "thread without spindle", "wl4-spindle-off",
        fmt::format("a thread while the spindle stands: timed at {} 1/min", settings_.default_spindle_rpm));
    n = settings_.default_spindle_rpm;
  }
  const double pitch = s.pitch;
  if (!(pitch > 0.0)) return fail("wl4-thread", "the pitch F of the thread is zero");
  const Vec3 way = p.target.xyz - machine_.xyz;
  const double along = way.cwiseAbs().maxCoeff();
  // Revolutions n with F n + I n (n - 1) / 2 = length.
  double revolutions = along / pitch;
  if (s.i != 0.0) {
    const double b = pitch - 0.5 * s.i, root = b * b + 2.0 * s.i * along;
    if (root < 0.0) return fail("wl4-thread", "the pitch falls to zero before the end of the thread");
    revolutions = (std::sqrt(root) - b) / s.i;
  }
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  fill(p, item);
  item.feed.kind = MotionKind::kThread;
  item.feed.feed = revolutions > 0.0 ? way.norm() / revolutions * n : pitch * n;
  item.feed.join.stops = p.exact_stop;
  item.feed.join.unbroken = !p.exact_stop;
  item.feed.spindle = spindle_rpm;
  item.feed.thread_pitch_change = static_cast<float>(s.i);
  const double start = s.motion == 32 && thread_angle_ ? *thread_angle_ : s.p;
  const double end = start + 360.0 * revolutions;
  item.feed.thread_start_deg = turnedTo(start);
  if (s.motion == 32) {
    thread_angle_.reset();
    if (!p.exact_stop) thread_angle_ = std::fmod(end, 360.0);  // a stop ends the sequence
    return send(p, item);
  }
  // G33: there and, the spindle reversed, back.
  const AxisPoint from = machine_;
  const FeedStyle feed = item.feed;
  const int direction = state_.spindle;
  if (!send(p, item)) return false;
  Wl4State reversed = s;
  reversed.spindle = direction == 3 ? 4 : direction == 4 ? 3 : direction;
  if (turns && !spindle(reversed)) return false;
  Plan back = p;
  back.target = from;
  back.chamfer = 0.0;
  PathItem item_back;
  item_back.kind = PathItem::Kind::kLine;
  fill(back, item_back);
  item_back.feed = feed;
  // Counted the other way round, from where the way there has ended, the lead falling as it has grown.
  item_back.feed.spindle = -feed.spindle;
  item_back.feed.thread_start_deg = turnedTo(-end);
  item_back.feed.thread_pitch_change = -feed.thread_pitch_change;
  if (!send(back, item_back)) return false;
  reversed.spindle = direction;
  return !turns || spindle(reversed);
}

bool Wl4Control::referenceMove(const Plan& p) {
  if (p.next.radius != 40) return fail("wl4-compensation", "G36 while compensation is on: G40 first");
  if (!p.named.any()) return fail("wl4-g36", "G36 needs the axes that are to move: G36 X0 Z0");
  if (!pipe_.flush(FlushReason::kBuffer)) return false;
  return straight(p, true);
}

/// G38: to the end or the first touch and back the same way.
bool Wl4Control::measure(const Plan& p) {
  if (p.next.radius != 40) return fail("wl4-compensation", "G38 while compensation is on: G40 first");
  if (p.next.motion > 3) return fail("wl4-g38", "G38 goes with G0, G1, G2 or G3");
  if (!pipe_.flush(FlushReason::kBuffer)) return false;
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  fill(p, item);
  if (p.next.motion == 0) {
    item.feed.feed = *std::min_element(settings_.rapid_mm_min.begin(), settings_.rapid_mm_min.end());
  } else if (!feedOf(p, item.feed)) {
    return false;
  }
  item.feed.kind = MotionKind::kProbe;
  item.feed.join.stops = true;
  if (p.next.motion > 1) {
    PlaneArc arc;
    bool moves = false;
    if (!arcOf(p, arc, moves)) return false;
    if (!moves) return true;
    item.kind = PathItem::Kind::kArc;
    item.center = Vec3(arc.center.x(), arc.center.y(), machine_[item.plane.w]);
    item.sweep = arc.sweep_rad;
  }
  double part = 1.0;
  bool touched = false;
  return touch(p, item, part, touched) && thereAndBack(p, item, part, touched);
}

/// Asks the probe how much of the way there is until the touch.
bool Wl4Control::touch(const Plan& p, const PathItem& item, double& part, bool& touched) {
  if (host_.probe == nullptr) {
    warnOnce("no probe", "wl4-no-probe",
             "there is no stock here that a measuring move could touch: it goes to its end");
    return true;
  }
  emitter_.time().flush();  // everything before is part of the stock that answers
  const auto line = emitter_.lineOf(p.target, here());
  if (!line) return fail("wl4-g38", "a measuring move that turns a table is not simulated");
  ArcGeometry arc;
  if (item.kind == PathItem::Kind::kArc) {
    PlaneArc curve;
    curve.start = item.plane.of(machine_);
    curve.end = item.plane.of(p.target);
    curve.center = item.center.head<2>();
    curve.sweep_rad = item.sweep;
    arc = toArcGeometry(curve, plane(p.next));
    arc.center += line->motion.from - machine_.xyz;
  }
  const auto contact =
      host_.probe->firstContact(line->motion, item.kind == PathItem::Kind::kArc ? &arc : nullptr,
                                line->has_axis ? &line->axis : nullptr);
  if (!contact) return fail("wl4-g38", contact.error().message);
  if (*contact) part = std::clamp(**contact, 0.0, 1.0);
  touched = contact->has_value();
  return true;
}

bool Wl4Control::thereAndBack(const Plan& p, PathItem& item, double part, bool touched) {
  const AxisPoint from = machine_;
  AxisPoint to = p.target;
  for (int k = 0; k < axes_.count(); ++k) to[k] = part < 1.0 ? from[k] + part * (to[k] - from[k]) : to[k];
  item.sweep *= part;
  if (item.kind == PathItem::Kind::kArc && part < 1.0) {
    const Vec2 arm = item.plane.of(from).head<2>() - item.center.head<2>();
    const Vec2 end = item.center.head<2>() + Eigen::Rotation2Dd(item.sweep) * arm;
    to[item.plane.u] = end.x();
    to[item.plane.v] = end.y();
  }
  PathItem back = item.copyMotion();
  item.to = to;
  back.to = from;
  back.sweep = -item.sweep;
  back.center[2] = to[back.plane.w];
  for (int k = 0; k < axes_.count() && k < 8; ++k) {
    const double unit = wantsDiameter(k) ? 2.0 : 1.0;
    const auto i = static_cast<std::size_t>(k);
    touch_machine_[i] = unit * to[k];
    touch_system_[i] = unit * p.next.sign(k) * (to[k] - p.next.acting[k]);
    touch_distance_[i] = unit * p.next.sign(k) * (to[k] - from[k]);
  }
  return pipe_.push(item) && sendEvent(event::Probe{touched}) && pipe_.push(back);
}

}  // namespace proveout::nc
