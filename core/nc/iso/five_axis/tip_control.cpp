#include "core/nc/iso/five_axis/tip_control.h"

#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/five_axis/shank_track.h"
#include "core/nc/iso/five_axis/tip_way.h"

namespace proveout::nc {

namespace {

/// "A -30 to 120, C endless".
std::string travelText(const IsoContext& c) {
  std::string out;
  for (const int k : {c.five_axes.first, c.five_axes.second}) {
    if (k < 0) continue;
    const AxisInfo& axis = c.axes.at(k);
    out += out.empty() ? "" : ", ";
    out += axis.limit ? fmt::format("{} {:g} to {:g}", axis.name, axis.limit->min, axis.limit->max)
                      : fmt::format("{} endless", axis.name);
  }
  return out;
}

bool planShank(IsoContext& c, BlockPlan& plan) {
  const Word* p = c.word('P');
  std::int64_t form = 0;
  if (p != nullptr && !integerWord(c, *p, 0, 1, form)) return false;
  plan.next.five.shank = form == 1;
  return true;
}

/// The vector of G43.5: as it is where none of its words is there; else words that are missing are 0.
bool planVector(IsoContext& c, BlockPlan& plan) {
  plan.claimed = plan.claimed | AddressSet("IJK");
  Vec3 vector = Vec3::Zero();
  bool given = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.word("IJK"[axis]);
    given = given || w != nullptr;
    vector[axis] = w == nullptr ? 0.0 : w->value;
  }
  if (!given) return true;
  if (!(vector.norm() > 0.0) || !std::isfinite(vector.norm()))
    return c.fail("tcp-definition", "G43.5 definition error: I, J and K give no direction");
  plan.motion.tool_vector = vector;
  return true;
}

bool checkMode(IsoContext& c, const BlockPlan& plan, const char* name) {
  const int motion = plan.next.active[kGroupMotion];
  if (plan.by_group[kGroupLengthComp] != nullptr && motion != gcode::kRapid && motion != gcode::kLine)
    return c.fail("tcp-definition", fmt::format("{} can be switched on in G0 or G1 only", name));
  if (motion == gcode::kThread)
    return c.fail("tcp-definition",
                  fmt::format("threads (G33) cannot be cut under {}: program G49 first", name));
  if (plan.next.inCycle())
    return c.fail("tcp-definition", fmt::format("cycles cannot run under {}: program G49 first", name));
  if (plan.next.compOn())
    return c.fail(
        "tcp-definition",
        fmt::format("cutter compensation (G41, G42) cannot be on under {}: program G40 first", name));
  return true;
}

}  // namespace

bool planTipControl(IsoContext& c, BlockPlan& plan) {
  const bool by_vector = plan.next.active[kGroupLengthComp] == gcode::kTipByVector;
  const char* name = by_vector ? "G43.5" : "G43.4";
  const bool called = plan.by_group[kGroupLengthComp] != nullptr;
  if (called && !hasFiveAxes(c, name)) return false;
  if (!checkMode(c, plan, name)) return false;
  if (called && !planShank(c, plan)) return false;
  if (by_vector && !planVector(c, plan)) return false;
  if (!called && !c.block.present.has('H')) return true;
  plan.next.length = AxisPoint();
  plan.next.five.tip = by_vector ? TipControl::kVector : TipControl::kAngles;
  plan.next.five.along_tool = true;
  plan.frames_changed = plan.flush = true;
  return true;
}

bool leavesTipControl(IsoContext& c, const BlockPlan& plan) {
  const int motion = plan.next.active[kGroupMotion];
  return motion == gcode::kRapid || motion == gcode::kLine ||
         c.fail("tcp-definition", "G49 ends tool centre point control in G0 or G1 only");
}

bool namesMotion(const IsoContext& c, const BlockPlan& plan) {
  return c.anyAxisWord() || plan.motion.tool_vector.has_value();
}

std::optional<RotaryAngles> chooseAngles(IsoContext& c, const Vec3& wanted) {
  const RotaryAngles now = c.five_axes.at(c.machine);
  const FiveAxisModel::Positions positions = c.five_axes.positionsFor(wanted, now);
  const std::optional<RotaryAngles> chosen = choosePosition(c.five_axes, positions, now, c.axes);
  if (chosen) return chosen;
  c.fail("unreachable",
         fmt::format("the tool cannot be turned into the direction {:.4f}, {:.4f}, {:.4f}: {} ({})",
                     wanted.x(), wanted.y(), wanted.z(),
                     positions.count > 0 ? "the positions for it are out of travel" : "no position has it",
                     travelText(c)));
  return std::nullopt;
}

bool takeToolVector(IsoContext& c, BlockPlan& plan, AxisPoint& target) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word) && word.axis >= kMainAxes && c.axes.at(word.axis).rotary())
      return c.fail("tcp-definition",
                    "G43.5 definition error: the tool's direction is given by I, J and K, not by rotary axes",
                    w.columns);
  }
  if (!plan.motion.tool_vector) return true;
  const CoordinateChain chain = c.chainOf(plan.next, kTablesAtZero);
  const Vec3 along = chain.toMachine(*plan.motion.tool_vector) - chain.toMachine(Vec3::Zero());
  // Under shank control the way decides which pair it is: performTipMove().
  const std::optional<RotaryAngles> angles = chooseAngles(c, along.normalized());
  if (!angles) return false;
  AxisPoint end = plan.chain->machineOf(target);
  setAngles(c.five_axes, *angles, end);
  target.more = plan.chain->programOf(end).more;
  return true;
}

bool turnsAboutTip(const IsoContext& c, const BlockPlan& plan) {
  if (plan.next.five.tip == TipControl::kOff && !plan.motion.about_tip) return false;
  return turnsRotaryAxes(c, c.chain.machineOf(plan.motion.target));
}

bool performTipMove(IsoContext& c, BlockPlan& plan) {
  if (plan.motion.join != PathMotion::Join::kSharp || plan.motion.meet != PathMotion::Meet::kNo)
    return c.fail("tcp-definition",
                  "chamfers, roundings and calculated points cannot stand in a block that turns the tool "
                  "while its tip is held");
  const TipWay way(c, plan);
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.space = PathItem::Space::kMachine;
  item.plane = plan.next.workPlane();
  item.rapid = plan.motion.rapid;
  item.feed = plan.motion.feed;
  item.source = c.here();
  item.pose = std::make_unique<PoseTrack>();
  PoseTrack& track = *item.pose;
  track.tip_mm = way.length();
  track.length = plan.next.h_value;
  track.held_mm = plan.motion.pivot_mm;
  if (plan.motion.is_arc) track.arc = way.arc(c.machine);
  const std::optional<ShankTrack> shank =
      plan.next.five.shank ? trackShank(c, plan) : std::optional<ShankTrack>();
  if (plan.next.five.shank) {
    if (!shank) return false;
    track.law = plan.motion.is_arc ? PoseLaw::kCone : PoseLaw::kVector;
    track.at = [&](double share) { return way.machineAt(share, shank->at(share)); };
    AxisPoint end = c.chain.machineOf(plan.motion.target);
    setAngles(c.five_axes, shank->at(1.0), end);
    c.chain = c.chainOf(plan.next, end);
    plan.motion.target.more = c.chain.programOf(end).more;
  } else {
    track.at = [&](double share) { return way.machineAt(share); };
  }
  const AxisPoint end = item.to = c.chain.machineOf(plan.motion.target);
  const bool sent = c.pipe.push(item);  // the way is told from where the control stands until now
  c.position = plan.motion.target;
  c.machine = end;
  return sent;
}

}  // namespace proveout::nc
