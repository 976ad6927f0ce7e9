#include "core/nc/iso/motion/curve.h"

#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/services/virtual_plane.h"

namespace proveout::nc {

std::vector<Vec3> chordsOf(const CurveMove& curve) {
  std::vector<Vec3> points;
  const auto at = [&](double t) { return curve.at(curve, t); };
  divideCurve(at, curve.pieces, kCurveToleranceMm, [&](double t) { points.push_back(at(t)); });
  return points;
}

bool sendChords(IsoContext& c, BlockPlan& plan, const std::vector<Vec3>& points) {
  const AxisPoint from = c.position, to = plan.motion.target;
  double length = 0.0;
  Vec3 last = from.xyz;
  for (const Vec3& p : points) {
    length += (p - last).norm();
    last = p;
  }
  if (plan.next.active[kGroupFeedMode] == gcode::kInverseTime) {
    plan.motion.feed.feed = plan.next.feed * length;
    plan.motion.feed.paced_mm = 0.0;
  }
  double gone = 0.0;
  last = from.xyz;
  for (std::size_t k = 0; k < points.size(); ++k) {
    gone += (points[k] - last).norm();
    last = points[k];
    AxisPoint& target = plan.motion.target;
    target = k + 1 == points.size() || !(length > 0.0) ? to : between(from, to, gone / length);
    target.xyz = k + 1 == points.size() ? to.xyz : points[k];
    if (!pushMotion(c, plan, PathItem::Kind::kLine)) return false;
  }
  c.position = to;
  c.machine = c.chain.machineOf(to);
  return true;
}

bool performCurve(IsoContext& c, BlockPlan& plan) {
  return sendChords(c, plan, chordsOf(std::get<CurveMove>(plan.payload)));
}

}  // namespace proveout::nc
