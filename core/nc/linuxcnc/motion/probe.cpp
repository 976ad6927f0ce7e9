// G38.2 to G38.5.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/sends.h"
#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

/// Asks the stock as cut so far about the line to `to`, machine. `contact`: where it is met. False: reported.
bool lcnAsk(IsoContext& c, const AxisPoint& to, std::optional<AxisPoint>& contact) {
  if (c.host.probe == nullptr) {
    c.warnOnce("no probe", "no-probe", "there is no stock here that a measuring move could touch");
    return true;
  }
  if (!c.pipe.flush(FlushReason::kBuffer) || !c.stages.rapid.flush(FlushReason::kBuffer)) return false;
  c.emitter.time().flush();
  const auto line = c.emitter.lineOf(c.axisMap().axesAt(to), c.here());
  if (!line) return c.fail("probe-turn", "a measuring move that turns a table is not simulated");
  const auto met = c.host.probe->firstContact(line->motion, nullptr, line->has_axis ? &line->axis : nullptr);
  if (!met) return c.fail("probe", met.error().message);
  if (*met) contact = between(c.standing(), to, std::clamp(**met, 0.0, 1.0));
  return true;
}

bool performLcnProbe(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const int code = plan.governor->code10;
  const bool away = code == 384 || code == 385;
  const bool must = code == 382 || code == 384;
  const AxisPoint to = c.chain.machineOf(plan.motion.target);
  std::optional<AxisPoint> contact;
  // Away from the stock the contact is lost at once here: the probe of the simulation never bends.
  if (away) {
    c.warnOnce("probe away", "probe-away",
               "G38.4, G38.5: where contact is lost is not simulated: the move goes to its end");
  } else if (!lcnAsk(c, to, contact)) {
    return false;
  }
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.space = PathItem::Space::kMachine;
  item.feed = plan.motion.feed;
  item.feed.kind = MotionKind::kProbe;
  item.to = contact.value_or(to);
  item.source = c.here();
  if (!c.pipe.push(item)) return false;
  c.settle(item.to);
  const bool met = contact.has_value() || away;
  own.probe_met = met;
  own.probe_at = c.position;
  own.modal = own.next;
  if (!sendEvent(c, event::Probe{met})) return false;
  if (met || !must) return true;
  if (c.host.probe == nullptr) return true;  // told
  return lcnFail(c, "probe", fmt::format("{} move finished without making contact", gName(code)));
}

}  // namespace

bool planLcnProbe(IsoContext& c, BlockPlan& plan) {
  if (lcnCompOn(c, plan)) return lcnFail(c, "comp", "Cannot probe with cutter radius compensation on");
  if (plan.next.active[kGroupFeedMode] == lcn::kInverseTime)
    return lcnFail(c, "feed", "Cannot probe in inverse time feed mode");
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  if (!lcnLineFeed(c, plan, plan.motion.target, "a probe move", plan.motion.feed)) return false;
  bool same = true;
  for (int axis = 0; axis < c.axes.count(); ++axis)
    same = same && std::abs(plan.motion.target[axis] - plan.start[axis]) < 1e-9;
  if (same) return lcnFail(c, "probe", "Start point too close to probe point");
  plan.perform = performLcnProbe;
  plan.flush = plan.rebases = true;
  return true;
}

}  // namespace proveout::nc
