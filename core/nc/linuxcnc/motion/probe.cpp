// G38.2 to G38.5.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/sends.h"
#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

/// So far on both sides of a place contact is felt, mm.
constexpr double kLcnTouchMm = 2e-4;
/// Parts of a move away in which the first loss of contact is looked for, and how near it is found, mm.
constexpr int kLcnAwayParts = 64;
constexpr double kLcnAwayMm = 1e-5;

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

/// Does the tool touch there, felt along `n`, unit? What it would only slide along is no contact to the
/// stock. False: reported.
bool lcnTouches(IsoContext& c, const LcnLineOfPath& line, const Vec3& at, const Vec3& n, bool& touches) {
  std::optional<double> met;
  if (!lcnMeets(c, line, at - kLcnTouchMm * n, at + kLcnTouchMm * n, met)) return false;
  touches = met.has_value();
  return true;
}

/// Away: the end of the contact with the stock as cut so far. False: reported.
bool lcnLoss(IsoContext& c, const LcnLineOfPath& line, LcnProbed& out) {
  const LinuxCncChannel& own = linuxCncChannel(c);
  const Vec3 from = line->motion.from, way = line->motion.to - from;
  const double length = way.norm();
  if (!(length > 0.0))
    return c.fail("probe", "a probing move away without a way in X, Y, Z is not simulated");
  // Behind a touch the contact is felt the way that the probe came, else against the way that it goes.
  const bool touched = own.probe_way && own.probe_met && (own.probe_end.xyz - c.standing().xyz).norm() < 1e-9;
  const Vec3 n = touched ? *own.probe_way : Vec3(-way / length);
  bool touches = touched;
  if (!touched && !lcnTouches(c, line, from, n, touches)) return false;
  if (!touches && !lcnTouches(c, line, from, -n, touches)) return false;
  if (!touches) {
    out.at = 0.0;
    out.at_once = true;
    return true;
  }
  double last = 0.0, clear = 0.0;
  for (int k = 1; k <= kLcnAwayParts && touches; ++k) {
    last = clear;
    clear = static_cast<double>(k) / kLcnAwayParts;
    if (!lcnTouches(c, line, from + clear * way, n, touches)) return false;
  }
  if (touches) return true;
  while ((clear - last) * length > kLcnAwayMm) {
    const double middle = 0.5 * (last + clear);
    if (!lcnTouches(c, line, from + middle * way, n, touches)) return false;
    (touches ? last : clear) = middle;
  }
  // Straight back the contact ends where the touch was, not where it is no longer felt.
  const double felt = std::max(0.0, -n.dot(way)) * kLcnTouchMm / (length * length);
  out.at = std::max(0.0, last - felt);
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
