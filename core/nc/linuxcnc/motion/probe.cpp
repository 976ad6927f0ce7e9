// G38.2 to G38.5.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/sends.h"
#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

/// So far into the material the touch of a probe is looked for where it has just touched, mm.
constexpr double kLcnTouchMm = 2e-3;
/// Parts of a move away in which the first loss of contact is looked for.
constexpr int kLcnAwayParts = 64;

using LcnLineOfPath = std::optional<PathEmitter::Line>;

/// The line to `to`, machine, as the stock sees it; nothing: reported.
bool lcnPathTo(IsoContext& c, const AxisPoint& to, LcnLineOfPath& line) {
  if (!c.pipe.flush(FlushReason::kBuffer) || !c.stages.rapid.flush(FlushReason::kBuffer)) return false;
  c.emitter.time().flush();
  line = c.emitter.lineOf(c.axisMap().axesAt(to), c.here());
  return line || c.fail("probe-turn", "a measuring move that turns a table is not simulated");
}

/// Where a way between two points of the workpiece frame first meets the stock, 0 to 1. False: reported.
bool lcnMeets(IsoContext& c, const LcnLineOfPath& line, const Vec3& from, const Vec3& to,
              std::optional<double>& at) {
  Motion motion = line->motion;
  motion.from = from;
  motion.to = to;
  const auto met = c.host.probe->firstContact(motion, nullptr, line->has_axis ? &line->axis : nullptr);
  if (!met) return c.fail("probe", met.error().message);
  at = *met;
  return true;
}

/// What a probing move found.
struct LcnProbed {
  std::optional<double> at;  ///< part of the way at which it ends; nothing: it goes to its end
  bool at_once = false;      ///< away: there was no contact at the start
};

/// Away: the end of the contact with the stock as cut so far. False: reported.
bool lcnLoss(IsoContext& c, const LcnLineOfPath& line, LcnProbed& out) {
  const LinuxCncChannel& own = linuxCncChannel(c);
  const Vec3 from = line->motion.from, way = line->motion.to - from;
  const double length = way.norm();
  if (!(length > 0.0))
    return c.fail("probe", "a probing move away without a way in X, Y, Z is not simulated");
  // Behind a touch the probe stands on the surface: a little into it there is contact for sure.
  const bool touched = own.probe_way && own.probe_met && (own.probe_end.xyz - c.standing().xyz).norm() < 1e-9;
  const Vec3 into = touched ? Vec3(kLcnTouchMm * *own.probe_way) : Vec3(-kLcnTouchMm / length * way);
  std::optional<double> met;
  if (!touched && !lcnMeets(c, line, from, from + into, met)) return false;
  if (!touched && !met && !lcnMeets(c, line, from, line->motion.to, met)) return false;
  if (!touched && !(met && *met * length < kLcnTouchMm)) {
    out.at = 0.0;
    out.at_once = true;
    return true;
  }
  // What the shift into the material adds to the way.
  const double more = std::max(0.0, -into.dot(way) / (length * length));
  const auto place = [&](double part) { return Vec3(from + into + part * way); };
  for (int k = 1; k <= kLcnAwayParts; ++k) {
    const double a = static_cast<double>(k - 1) / kLcnAwayParts, b = static_cast<double>(k) / kLcnAwayParts;
    if (!lcnMeets(c, line, place(b), place(a), met)) return false;
    if (met && *met * (b - a) * length < 1e-6) continue;  // contact at the end of the part still
    const double last = met ? b - *met * (b - a) : a;
    out.at = std::clamp(last - more, 0.0, 1.0);
    return true;
  }
  return true;
}

/// Asks the stock as cut so far about the line to `to`, machine. False: reported.
bool lcnAsk(IsoContext& c, const AxisPoint& to, bool away, LcnProbed& out) {
  if (c.host.probe == nullptr) {
    c.warnOnce("no probe", "no-probe", "there is no stock here that a measuring move could touch");
    return true;
  }
  LcnLineOfPath line;
  if (!lcnPathTo(c, to, line)) return false;
  LinuxCncChannel& own = linuxCncChannel(c);
  if (away) return lcnLoss(c, line, out);
  if (!lcnMeets(c, line, line->motion.from, line->motion.to, out.at)) return false;
  const Vec3 way = line->motion.to - line->motion.from;
  own.probe_way = way.norm() > 0.0 ? std::optional<Vec3>(way.normalized()) : std::nullopt;
  return true;
}

/// What the control says at the end of a probing move. False: it is an error, reported.
bool lcnProbeEnds(IsoContext& c, int code, const LcnProbed& found, bool met) {
  const bool must = code == 382 || code == 384;
  if (!must || c.host.probe == nullptr) return true;
  if (found.at_once) return lcnFail(c, "probe", "Probe is already clear when starting G38.4 or G38.5 move");
  if (met) return true;
  return lcnFail(
      c, "probe",
      fmt::format("{} move finished without {} contact", gName(code), code == 384 ? "breaking" : "making"));
}

bool performLcnProbe(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const int code = plan.governor->code10;
  const bool away = code == 384 || code == 385;
  const AxisPoint to = c.chain.machineOf(plan.motion.target);
  LcnProbed found;
  if (!lcnAsk(c, to, away, found)) return false;
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.space = PathItem::Space::kMachine;
  item.feed = plan.motion.feed;
  item.feed.kind = MotionKind::kProbe;
  item.to = found.at ? between(c.standing(), to, std::clamp(*found.at, 0.0, 1.0)) : to;
  item.source = c.here();
  if (!c.pipe.push(item)) return false;
  c.settle(item.to);
  const bool met = found.at.has_value() || (away && c.host.probe == nullptr);
  own.probe_met = met;
  own.probe_at = c.position;
  own.probe_end = item.to;
  if (away) own.probe_way.reset();
  own.modal = own.next;
  return sendEvent(c, event::Probe{met}) && lcnProbeEnds(c, code, found, met);
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
