#include "core/nc/services/drilling.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout {
namespace drilling_detail {

/// mm; a rest of the hole below it is not worth a peck of its own. Far below any control's increment.
constexpr double kDepthTolerance = 1e-9;

DrillError check(const DrillCycle& c) {
  for (const double x : {c.initial, c.r, c.bottom, c.peck, c.clearance, c.dwell, c.shift.x(), c.shift.y(),
                         c.retract_factor, c.peck_less, c.peck_least, c.to_r_every}) {
    if (!std::isfinite(x)) return DrillError::kNotFinite;
  }
  if (c.peck < 0.0 || c.clearance < 0.0 || c.peck_less < 0.0 || c.peck_least < 0.0 || c.to_r_every < 0.0)
    return DrillError::kBadPeck;
  if (!(c.retract_factor > 0.0)) return DrillError::kBadRetract;
  // Three steps a peck, and a dozen around them.
  const bool pecks = c.peck > 0.0;
  const double shortest = c.peck_less > 0.0 ? std::min(c.peck, c.peck_least) : c.peck;
  if (pecks && !(shortest > 0.0)) {
    // Without a shortest peck they must reach the bottom before they are used up.
    const double most = 0.5 * c.peck * (c.peck / c.peck_less + 1.0);
    if (most < std::abs(c.bottom - c.r)) return DrillError::kBadPeck;
    if (c.peck / c.peck_less > static_cast<double>(kMaxDrillSteps) / 3.0 - 12.0)
      return DrillError::kTooManySteps;
  } else if (pecks &&
             3.0 * std::abs(c.bottom - c.r) / shortest + 12.0 > static_cast<double>(kMaxDrillSteps)) {
    return DrillError::kTooManySteps;
  }
  return DrillError::kNone;
}

/// Writes the steps of one hole; keeps the drill axis position so that every step carries it.
class Expander {
 public:
  Expander(const DrillCycle& cycle, std::vector<DrillStep>& steps)
      : c_(cycle), steps_(steps), position_(cycle.initial) {}

  void run();

 private:
  DrillStep& add(DrillStepKind kind, int operation) {
    DrillStep step;
    step.kind = kind;
    step.operation = operation;
    step.position = position_;
    return steps_.emplace_back(step);
  }
  void rapid(double to, int operation) {
    position_ = to;
    add(DrillStepKind::kRapid, operation);
  }
  DrillStep& feed(double to, int operation) {
    position_ = to;
    return add(DrillStepKind::kFeed, operation);
  }
  void shift(const Vec2& by, int operation) { add(DrillStepKind::kShift, operation).shift = by; }
  void dwell() {
    if (c_.dwell > 0.0) add(DrillStepKind::kDwell, 6).dwell = c_.dwell;
  }

  /// Operations 7 to 10 of the cycles that leave the hole at rapid: to R or to the initial point, then
  /// `after`.
  template <typename After>
  void leave(After after) {
    if (c_.return_to_r) {
      rapid(c_.r, 7);
      after(8);
    } else {
      rapid(c_.initial, 9);
      after(10);
    }
  }
  void leave() {
    leave([](int) {});
  }
  /// Operation 9 of the cycles that leave the hole at feed.
  void leaveFromR() {
    if (!c_.return_to_r) rapid(c_.initial, 9);
  }

  void peckDown();
  void tap(DrillStepKind at_bottom, DrillStepKind after);
  void rigidTap();
  void rigidTapFeed(double to, int operation, double factor);
  void feedOut();
  void fineBore();
  void backBore();
  void stopAndLeave(bool manual);

  const DrillCycle& c_;
  std::vector<DrillStep>& steps_;
  double position_;
};

/// Calls visit(peck, depth) for each end of a peck, the bottom last.
template <typename Visit>
void forEachPeck(const DrillCycle& c, Visit visit) {
  const double direction = c.bottom < c.r ? -1.0 : 1.0;
  if (c.peck > 0.0 && c.peck_less > 0.0) {
    double peck = c.peck, depth = c.r;
    for (;; peck = std::max(peck - c.peck_less, c.peck_least)) {
      depth += direction * peck;
      if (direction * (c.bottom - depth) <= kDepthTolerance || !(peck > 0.0)) break;
      visit(depth);
    }
  } else if (c.peck > 0.0) {
    for (std::int64_t n = 1;; ++n) {
      const double depth = c.r + direction * c.peck * static_cast<double>(n);
      if (direction * (c.bottom - depth) <= kDepthTolerance) break;
      visit(depth);
    }
  }
  visit(c.bottom);
}

void Expander::peckDown() {
  const double back = c_.bottom < c_.r ? 1.0 : -1.0;  // direction out of the hole
  const bool to_r = c_.code == DrillCode::kPeck;
  double last = c_.r;
  bool first = true;
  double out_at = c_.to_r_every;  // depth below R from which the next way out goes to R
  forEachPeck(c_, [&](double depth) {
    if (!first) {
      const double cut = std::abs(last - c_.r) + kDepthTolerance;
      const bool far_out = c_.to_r_every > 0.0 && cut >= out_at;
      if (far_out) out_at = (std::floor(cut / c_.to_r_every) + 1.0) * c_.to_r_every;
      if (to_r || far_out) rapid(c_.r, 5);
      // The approach never goes back above R.
      const double approach = last + back * c_.clearance;
      rapid(to_r && back * (approach - c_.r) > 0.0 ? c_.r : approach, 5);
    }
    feed(depth, 5);
    last = depth;
    first = false;
  });
  if (c_.dwell_of_pecks) dwell();
}

void Expander::tap(DrillStepKind at_bottom, DrillStepKind after) {
  const auto lockedFeed = [this](double to, int operation) {
    DrillStep& step = feed(to, operation);
    step.locked = true;
    step.thread = true;
  };
  lockedFeed(c_.bottom, 5);
  dwell();
  add(at_bottom, 6);
  lockedFeed(c_.r, 7);
  if (c_.dwell_at_r) dwell();
  add(after, 8);
  leaveFromR();
}

void Expander::rigidTapFeed(double to, int operation, double factor) {
  DrillStep& step = feed(to, operation);
  step.locked = true;
  step.thread = true;
  step.feed_factor = factor;
}

void Expander::rigidTap() {
  add(c_.orient_before_rigid_tap ? DrillStepKind::kSpindleOrient : DrillStepKind::kCloseLoop, 4);
  const double back = c_.bottom < c_.r ? 1.0 : -1.0;
  double last = c_.r;
  bool first = true;
  forEachPeck(c_, [&](double depth) {
    if (!first) {
      const double factor = c_.tap_returns_to_r ? c_.tap_return_factor : 1.0;
      if (c_.tap_returns_to_r) rigidTapFeed(c_.r, 5, factor);
      const double approach = last + back * c_.clearance;
      rigidTapFeed(c_.tap_returns_to_r && back * (approach - c_.r) > 0.0 ? c_.r : approach, 5, factor);
    }
    rigidTapFeed(depth, 5, 1.0);
    last = depth;
    first = false;
  });
  dwell();
  rigidTapFeed(c_.r, 7, c_.retract_factor);
  if (c_.dwell_at_r) dwell();
  leaveFromR();
}

void Expander::feedOut() {
  feed(c_.bottom, 5);
  if (c_.code == DrillCode::kBoreDwellFeedOut) dwell();
  feed(c_.r, 7).feed_factor = c_.retract_factor;
  leaveFromR();
}

void Expander::fineBore() {
  feed(c_.bottom, 5);
  dwell();
  add(DrillStepKind::kSpindleOrient, 6);
  shift(c_.shift, 6);
  leave([this](int operation) {
    shift(-c_.shift, operation);
    add(DrillStepKind::kSpindleForward, operation);
  });
}

void Expander::backBore() {
  add(DrillStepKind::kSpindleOrient, 2);
  shift(c_.shift, 2);
  rapid(c_.r, 3);
  shift(-c_.shift, 4);
  add(DrillStepKind::kSpindleForward, 4);
  feed(c_.bottom, 5);
  if (c_.dwell_of_back) dwell();
  add(DrillStepKind::kSpindleOrient, 6);
  shift(c_.shift, 6);
  rapid(c_.initial, 9);
  shift(-c_.shift, 10);
  add(DrillStepKind::kSpindleForward, 10);
}

void Expander::stopAndLeave(bool manual) {
  feed(c_.bottom, 5);
  if (c_.code == DrillCode::kBoreManual) dwell();
  add(DrillStepKind::kSpindleStop, 6);
  if (manual) add(DrillStepKind::kProgramStop, 6);
  if (manual && c_.stops_at_r && !c_.return_to_r) rapid(c_.r, 7);
  leave([this](int operation) { add(DrillStepKind::kSpindleForward, operation); });
}

void Expander::run() {
  if (c_.code == DrillCode::kBackBore) return backBore();
  rapid(c_.r, 3);
  switch (c_.code) {
    case DrillCode::kChipBreak:
    case DrillCode::kPeck:
      peckDown();
      return leave();
    case DrillCode::kTapLeft:
      return tap(DrillStepKind::kSpindleForward, DrillStepKind::kSpindleReverse);
    case DrillCode::kTap:
      return tap(DrillStepKind::kSpindleReverse, DrillStepKind::kSpindleForward);
    case DrillCode::kRigidTap:
    case DrillCode::kRigidTapLeft:
      return rigidTap();
    case DrillCode::kFineBore:
      return fineBore();
    case DrillCode::kDrill:
    case DrillCode::kDrillDwell:
      feed(c_.bottom, 5);
      if (c_.code == DrillCode::kDrillDwell) dwell();
      return leave();
    case DrillCode::kBoreFeedOut:
    case DrillCode::kBoreDwellFeedOut:
      return feedOut();
    case DrillCode::kBoreStop:
      return stopAndLeave(false);
    case DrillCode::kBackBoreManual:
    case DrillCode::kBoreManual:
      return stopAndLeave(true);
    case DrillCode::kBackBore:
      return;  // done above
  }
}

}  // namespace drilling_detail

DrillError expandDrillCycle(const DrillCycle& cycle, std::vector<DrillStep>& steps) {
  steps.clear();
  const DrillError error = drilling_detail::check(cycle);
  if (error == DrillError::kNone) drilling_detail::Expander(cycle, steps).run();
  PROVEOUT_ASSERT(steps.size() <= static_cast<std::size_t>(kMaxDrillSteps));
  return error;
}

}  // namespace proveout
