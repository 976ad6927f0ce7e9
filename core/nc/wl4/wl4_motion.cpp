#include "core/nc/wl4/wl4_motion.h"

#include "core/nc/wl4/cycles/wl4_measuring.h"
#include "core/nc/wl4/wl4_arcs.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_output.h"
#include "core/nc/wl4/wl4_speeds.h"

namespace proveout::nc {

namespace {

bool sendArc(Wl4Context& c, const Wl4BlockPlan& p, const Vec2& center, double sweep) {
  PathItem item = motionItem(c, p, PathItem::Kind::kArc);
  item.center = Vec3(center.x(), center.y(), c.machine[item.plane.w]);
  item.sweep = sweep;
  return planFeed(c, p, item.feed) && sendMotion(c, p, item);
}

}  // namespace

bool performMotion(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.measures) return performMeasuring(c, p);
  if (p.next.motion != 32) c.thread_angle.reset();
  return wl4GCode(p.next.motion)->perform(c, p);
}

bool performRapid(Wl4Context& c, Wl4BlockPlan& p) {
  PathItem item = motionItem(c, p, PathItem::Kind::kLine);
  item.rapid = true;
  item.feed.join.stops = true;
  return sendMotion(c, p, item);
}

bool performLine(Wl4Context& c, Wl4BlockPlan& p) {
  PathItem item = motionItem(c, p, PathItem::Kind::kLine);
  return planFeed(c, p, item.feed) && sendMotion(c, p, item);
}

bool performArc(Wl4Context& c, Wl4BlockPlan& p) {
  PlaneArc arc;
  bool moves = false;
  if (!resolveBlockArc(c, p, arc, moves)) return false;
  return !moves || sendArc(c, p, arc.center, arc.sweep_rad);
}

bool performQuarter(Wl4Context& c, Wl4BlockPlan& p) {
  Vec2 center;
  double sweep = 0.0;
  return resolveQuarter(c, p, center, sweep) && sendArc(c, p, center, sweep);
}

bool performReference(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.next.radius != 40)
    return c.report.fail("wl4-compensation", "G36 while compensation is on: G40 first");
  if (!p.named.any()) return c.report.fail("wl4-g36", "G36 needs the axes that are to move: G36 X0 Z0");
  if (!c.pipe.flush(FlushReason::kBuffer)) return false;
  return performRapid(c, p);
}

}  // namespace proveout::nc
