#include "core/nc/wl4/wl4_output.h"

#include <memory>
#include <utility>

namespace proveout::nc {

PathItem motionItem(Wl4Context& c, const Wl4BlockPlan& p, PathItem::Kind kind) {
  const Wl4State& s = p.next;
  PathItem item;
  item.kind = kind;
  item.space = PathItem::Space::kWork;
  item.plane = WorkPlane(s.frame());
  item.to = p.target;
  item.in_plane =
      p.named[static_cast<std::size_t>(item.plane.u)] || p.named[static_cast<std::size_t>(item.plane.v)];
  item.comp_on = s.radius != 40;
  const double side = (s.radius == 41) != c.setup.flipped(s) ? 1.0 : -1.0;
  item.offset = item.comp_on ? side * c.setup.compRadius(s) : 0.0;
  item.start = item.plane.of(c.machine).head<2>();
  AxisPoint level = c.machine;
  level[item.plane.u] = item.to[item.plane.u];
  level[item.plane.v] = item.to[item.plane.v];
  item.level = level == item.to;
  item.source = c.report.here();
  return item;
}

bool sendMotion(Wl4Context& c, const Wl4BlockPlan& p, PathItem& item) {
  if (p.chamfer > 0.0) {
    item.join = PathItem::Join::kChamfer;
    item.join_size = p.chamfer;
    c.corner_stage.announce();
  }
  if (item.comp_on && c.setup.lathe && c.setup.compRadius(p.next) < 0.0) {
    return c.report.fail("wl4-radius", "the nose radius and the corrector D are negative together");
  }
  if (item.comp_on && !c.comp_stage.linked()) {
    const Vec2 tip = c.setup.tipOf(p.next);
    c.comp_stage.setTip({tip.y(), 0.0, tip.x()});
    c.comp_stage.engage(c.corner_stage.sentUntil(item.plane.of(c.machine)),
                        {.arc_threshold = c.setup.parameters.arc_threshold});
  }
  if (!c.pipe.push(item)) return false;
  c.machine = p.target;
  return true;
}

PathItem functionItem(Wl4Context& c, PathItem::Kind kind) {
  PathItem item;
  item.kind = kind;
  item.plane = WorkPlane(c.state.frame());
  item.to = c.machine;
  item.comp_on = c.state.radius != 40;
  item.source = c.report.here();
  return item;
}

bool sendEvent(Wl4Context& c, EventKind what, double time_s) {
  PathItem item = functionItem(c, PathItem::Kind::kEvent);
  item.event = std::make_unique<EventKind>(std::move(what));
  item.value = time_s;
  return c.pipe.push(item);
}

}  // namespace proveout::nc
