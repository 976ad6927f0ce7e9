// Carrying the steps of a block out.
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/linuxcnc/frames/frames.h"
#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

void lcnFill(IsoContext& c, const BlockPlan& plan, PathItem& item) {
  item.plane = plan.next.workPlane();
  item.in_plane = true;
  item.feed = plan.motion.feed;
  item.comp_on = plan.next.compOn();
  item.offset = plan.next.compOffset();
  item.tip = static_cast<std::uint8_t>(plan.next.d_tip);
  item.source = c.here();
}

/// A motion from where the program stands to the step's end.
bool lcnMove(IsoContext& c, const BlockPlan& plan, const LinuxCncStep& step) {
  using Kind = LinuxCncStep::Kind;
  PathItem item;
  lcnFill(c, plan, item);
  item.kind = step.kind == Kind::kArc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
  item.rapid = step.kind == Kind::kRapid;
  item.to = step.to;
  const Vec3 from = item.plane.of(c.position);
  item.start = from.head<2>();
  if (step.kind == Kind::kArc) {
    item.center = {step.center.x(), step.center.y(), from.z()};
    item.sweep = step.sweep;
  }
  if (step.kind == Kind::kThread) item.feed.kind = MotionKind::kThread;
  if (step.kind == Kind::kThread && step.value > 0.0) item.feed.feed = step.value;
  const bool bare = step.bare && item.comp_on;
  item.comp_on = item.comp_on && !bare;
  if (item.comp_on) item.record = c.alarms.remember();
  c.position = step.to;
  c.machine = c.chain.machineOf(step.to);
  if (!c.pipe.push(item)) return false;
  if (bare) linuxCncChannel(c).comp.rebase(c.chain.workOf(c.position), plan.next.workPlane());
  return true;
}

bool lcnFunction(IsoContext& c, BlockPlan& plan, const LinuxCncStep& step) {
  using Kind = LinuxCncStep::Kind;
  switch (step.kind) {
    case Kind::kDwell: {
      PathItem item = functionItem(c, PathItem::Kind::kDwell, plan.next);
      item.value = step.value;
      return c.pipe.push(item);
    }
    case Kind::kSpindle:
      return turnMain(c, static_cast<int>(step.value), plan.next.spindle_rpm);
    case Kind::kOrient:
      return closeMainLoop(c, true);
    case Kind::kStop:
      return sendEvent(c, event::Stop{"M0", "manual retract of the cycle"});
    case Kind::kMachineRapid:
      if (!sendMachineRapid(c, step.to)) return false;
      c.settle(step.to);
      return true;
    default:
      return true;
  }
}

}  // namespace

bool performLinuxCncSteps(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  applyLinuxCncFrames(c, plan);
  own.arc_mode_said = own.arc_mode_said || plan.by_group[kGroupArcCentre] != nullptr;
  if (plan.next.compOn() && !own.comp.linked())
    own.comp.engage(plan.next.workPlane().of(c.chain.workOf(c.position)));
  for (const LinuxCncStep& step : own.steps) {
    const bool moves = step.kind <= LinuxCncStep::Kind::kThread;
    // Cycles make many steps of one block.
    if (moves && &step != own.steps.data() && c.watch.workOver(c.calls.place())) return false;
    if (moves ? !lcnMove(c, plan, step) : !lcnFunction(c, plan, step)) return false;
  }
  if (!plan.next.compOn() && own.comp.linked() && !own.comp.end()) return false;
  own.modal = own.next;
  return !plan.tool_change || plan.next.compOn() || lcnTakeStanding(c);
}

bool lcnTakeStanding(IsoContext& c) {
  if (!c.flushPipe()) return false;
  c.settle(c.standing());
  return true;
}

void lcnRapid(LinuxCncChannel& own, const AxisPoint& to) {
  own.steps.push_back({.kind = LinuxCncStep::Kind::kRapid, .to = to});
}
void lcnFeedTo(LinuxCncChannel& own, const AxisPoint& to) {
  own.steps.push_back({.kind = LinuxCncStep::Kind::kFeed, .to = to});
}

}  // namespace proveout::nc
