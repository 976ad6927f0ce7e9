#include "core/nc/iso/cycles/path_steps.h"

#include "core/nc/iso/context/words.h"

namespace proveout::nc {

bool performSteps(IsoContext& c, BlockPlan& plan) {
  const WorkPlane plane = planeOf(plan.next);
  for (const PathStep& step : c.path_steps) {
    PathItem item;
    item.kind = step.kind == PathStep::Kind::kArc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
    item.plane = plane;
    item.in_plane = true;
    const Vec3 from = plane.of(c.position);
    item.to = c.position;
    item.to[plane.u] = step.to.x();
    item.to[plane.v] = step.to.y();
    item.to[plane.w] = step.to.z();
    item.rapid = step.kind == PathStep::Kind::kRapid;
    item.feed = plan.motion.feed;
    item.feed.feed *= step.feed_factor;
    if (step.kind == PathStep::Kind::kArc) {
      item.center = {step.center.x(), step.center.y(), from.z()};
      item.start = from.head<2>();
      item.sweep = step.sweep_rad;
    }
    item.source = c.here();
    c.position = item.to;
    c.machine = c.chain.machineOf(item.to);
    if (!c.pipe.push(item)) return false;
  }
  return true;
}

}  // namespace proveout::nc
