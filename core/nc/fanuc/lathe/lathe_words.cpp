#include "core/nc/fanuc/lathe/lathe_words.h"

#include <fmt/core.h>

#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr double kThousandthMm = 0.001, kTenThousandthInch = 0.0001 * 25.4;
/// A depth of so much without a point is meant in thousandths, whatever `decimal` says.
constexpr double kNoDepth = 100.0;

double thousandth(const BlockPlan& plan) {
  return plan.next.active[kGroupUnits] == gcode::kInch ? kTenThousandthInch : kThousandthMm;
}

}  // namespace

bool pointed(const IsoContext& /*c*/, const Word& w) { return w.point || w.from_expression; }

bool countsIncrements(const IsoContext& c, const Word& w) {
  return c.parameters.flag(FanucParam::kDecimal) && !w.point && !w.from_expression;
}

double lengthWord(IsoContext& c, const BlockPlan& plan, Address a) {
  const Word* w = c.word(a);
  if (w == nullptr) return 0.0;
  // K of turning cycles comes as it is written: it counts elsewhere.
  const bool raw = a == 'K' && plan.governor != nullptr && plan.governor->code10 >= lathe_code::kFinish;
  return raw && countsIncrements(c, *w) ? w->value * thousandth(plan) : lengthOf(plan, *w);
}

double stepWord(IsoContext& c, const BlockPlan& plan, const Word& w) {
  if (!pointed(c, w)) return w.value * thousandth(plan);
  if (!w.from_expression) {
    if (c.firstTime(fmt::format("point {}", addressText(w.address)))) {
      c.warn(
          "point",
          fmt::format("{} counts in thousandths on most controls, without a point: {:g} is taken as a length "
                      "in the unit of the program",
                      addressText(w.address), w.value),
          w.columns, Severity::kNote);
    }
    return lengthOf(plan, w);
  }
  return w.value * thousandth(plan);
}

double depthWord(IsoContext& c, const BlockPlan& plan, const Word& w) {
  if (pointed(c, w)) return lengthOf(plan, w);
  if (countsIncrements(c, w)) return w.value * thousandth(plan);
  if (w.value < kNoDepth) return lengthOf(plan, w);
  if (c.firstTime("depth without a point")) {
    c.warn("point",
           fmt::format("D{:g} without a point is taken in thousandths: {:g} mm", w.value,
                       w.value * thousandth(plan)),
           w.columns, Severity::kNote);
  }
  return w.value * thousandth(plan);
}

bool turningPlane(IsoContext& c, const BlockPlan& plan) {
  return plan.next.plane() == Plane::kZX ||
         c.alarm(SharedAlarm::kPlane, "", "cycles of turning work in the plane of Z and X: program G18");
}

}  // namespace proveout::nc
