#include "core/nc/wl4/cycles/wl4_measuring.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/nc/wl4/wl4_arcs.h"
#include "core/nc/wl4/wl4_output.h"
#include "core/nc/wl4/wl4_speeds.h"

namespace proveout::nc {

namespace {

/// How a measuring move ends.
struct Contact {
  double part = 1.0;  ///< of the way there
  bool touched = false;
};

/// The item's circle in the machine frame; it begins at `from`.
ArcGeometry circleOf(const Wl4Context& c, const Wl4BlockPlan& p, const PathItem& item, const Vec3& from) {
  PlaneArc curve;
  curve.start = item.plane.of(c.machine);
  curve.end = item.plane.of(p.target);
  curve.center = item.center.head<2>();
  curve.sweep_rad = item.sweep;
  ArcGeometry arc = toArcGeometry(curve, p.next.frame());
  arc.center += from - c.machine.xyz;
  return arc;
}

/// Asks the probe how much of the way there is until the touch.
bool touch(Wl4Context& c, const Wl4BlockPlan& p, const PathItem& item, Contact& contact) {
  Probe* probe = c.setup.host.probe;
  if (probe == nullptr) {
    c.report.warnOnce("no probe", "wl4-no-probe",
                      "there is no stock here that a measuring move could touch: it goes to its end");
    return true;
  }
  c.emitter.time().flush();  // everything before is part of the stock that answers
  const auto line = c.emitter.lineOf(p.target, c.report.here());
  if (!line) return c.report.fail("wl4-g38", "a measuring move that turns a table is not simulated");
  ArcGeometry arc;
  const bool round = item.kind == PathItem::Kind::kArc;
  if (round) arc = circleOf(c, p, item, line->motion.from);
  const auto found =
      probe->firstContact(line->motion, round ? &arc : nullptr, line->has_axis ? &line->axis : nullptr);
  if (!found) return c.report.fail("wl4-g38", found.error().message);
  if (*found) contact.part = std::clamp(**found, 0.0, 1.0);
  contact.touched = found->has_value();
  return true;
}

/// For #1000 to #1029.
void remember(Wl4Context& c, const Wl4State& s, const AxisPoint& from, const AxisPoint& to) {
  const int count = std::min(c.setup.axes.count(), static_cast<int>(Wl4SystemValues::kTouches));
  for (int k = 0; k < count; ++k) {
    const double unit = c.setup.wantsDiameter(k) ? 2.0 : 1.0;
    c.system.setTouch(static_cast<std::size_t>(k), {unit * to[k], unit * s.sign(k) * (to[k] - s.acting[k]),
                                                    unit * s.sign(k) * (to[k] - from[k])});
  }
}

bool thereAndBack(Wl4Context& c, const Wl4BlockPlan& p, PathItem& item, const Contact& contact) {
  const AxisPoint from = c.machine;
  const double part = contact.part;
  AxisPoint to = p.target;
  for (int k = 0; k < c.setup.axes.count(); ++k)
    to[k] = part < 1.0 ? from[k] + part * (to[k] - from[k]) : to[k];
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
  remember(c, p.next, from, to);
  return c.pipe.push(item) && sendEvent(c, event::Probe{contact.touched}) && c.pipe.push(back);
}

}  // namespace

bool performMeasuring(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.next.radius != 40)
    return c.report.fail("wl4-compensation", "G38 while compensation is on: G40 first");
  if (p.next.motion > 3) return c.report.fail("wl4-g38", "G38 goes with G0, G1, G2 or G3");
  if (!c.pipe.flush(FlushReason::kBuffer)) return false;
  PathItem item = motionItem(c, p, PathItem::Kind::kLine);
  if (p.next.motion == 0) {
    const Vec3& rapid = c.setup.settings.rapid_mm_min;
    item.feed.feed = *std::min_element(rapid.begin(), rapid.end());
  } else if (!planFeed(c, p, item.feed)) {
    return false;
  }
  item.feed.kind = MotionKind::kProbe;
  item.feed.join.stops = true;
  if (p.next.motion > 1) {
    PlaneArc arc;
    bool moves = false;
    if (!resolveBlockArc(c, p, arc, moves)) return false;
    if (!moves) return true;
    item.kind = PathItem::Kind::kArc;
    item.center = Vec3(arc.center.x(), arc.center.y(), c.machine[item.plane.w]);
    item.sweep = arc.sweep_rad;
  }
  Contact contact;
  return touch(c, p, item, contact) && thereAndBack(c, p, item, contact);
}

}  // namespace proveout::nc
