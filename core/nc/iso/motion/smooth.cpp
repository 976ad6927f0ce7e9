// G5.1: smoothing of short lines (manual 4.7). The path stays the programmed polyline; the machine's differs
// from it by the tolerance that the event tells.
#include <fmt/core.h>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

std::string axisNames(const IsoContext& c) {
  std::string names;
  const AxisSet set = c.state.axes.smooth_axes;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const bool all = set.none() && !c.axes.at(axis).rotary();
    if (all || set[static_cast<std::size_t>(axis)])
      names += (names.empty() ? "" : " ") + c.axes.at(axis).name;
  }
  return names;
}

/// A sum of parameters without the rounding of its last digits.
double nineDigits(double value) { return std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr); }

bool performSmooth(IsoContext& c, BlockPlan& plan) {
  const int mode = std::get<Smoothing>(plan.payload).mode;
  c.state.axes.smooth_axes = plan.next.axes.smooth_axes;
  event::Smoothing told;
  told.mode = mode;
  if (mode >= 2) {
    const auto tell = [&](std::optional<double>& field, AxisParam p) {
      if (c.parameters[p] != 0.0) field = c.parameters[p];
    };
    const AxisParam deviation = mode == 2 ? AxisParam::kSmoothDeviationMax : AxisParam::kFineTolerance;
    told.axes = axisNames(c);
    told.tolerance = nineDigits(c.parameters[deviation] + c.parameters[AxisParam::kSmoothMerge]);
    tell(told.longest, AxisParam::kSmoothBlockMax);
    tell(told.shortest, AxisParam::kSmoothBlockMin);
    tell(told.angle, AxisParam::kSmoothAngle);
    tell(told.joined, AxisParam::kSmoothMerge);
    if (mode == 2) tell(told.least, AxisParam::kSmoothDeviationMin);
    if (mode == 3) tell(told.any_angle_below, AxisParam::kFineBlockMin);
  }
  return sendEvent(c, std::move(told));
}

}  // namespace

bool planSmooth(IsoContext& c, BlockPlan& plan) {
  const Word* q = c.ownWord(plan, 'Q');
  std::int64_t mode = 0;
  if (q == nullptr) return c.alarm(SharedAlarm::kMissingData, "Q", "G5.1 needs Q0 to Q3");
  if (!integerWord(c, *q, 0, 3, mode)) return false;
  AxisModal& modal = plan.next.axes;
  modal.smoothing = static_cast<std::int8_t>(mode);
  modal.smooth_axes.reset();
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (w.axis < 0)
      return c.alarm(SharedAlarm::kIllegalAddress, w, "the axes that take part go by their own names");
    modal.smooth_axes.set(static_cast<std::size_t>(word.axis));
  }
  plan.motion.target = plan.start;
  plan.payload.emplace<Smoothing>().mode = static_cast<int>(mode);
  plan.perform = performSmooth;
  return true;
}

}  // namespace proveout::nc
