// Patterns of holes: G70, G71, G72 of Haas mills.
#include <fmt/core.h>

#include <cmath>

#include "core/geometry/degrees.h"
#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/haas/haas.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr int kHoleCircle = 700, kHoleArc = 710, kHoleLine = 720;
constexpr std::int64_t kMostHoles = 10000;

struct HolePattern {
  double length = 0.0;     ///< radius or spacing, mm
  double angle_deg = 0.0;  ///< of the first hole or of the line
  double step_deg = 0.0;
  std::int64_t count = 0;
};

bool readPattern(IsoContext& c, const BlockPlan& plan, HolePattern& out) {
  const int code10 = plan.governor->code10;
  const std::string code = gName(code10);
  const Word* i = c.word('I');
  const Word* l = c.word('L');
  if (i == nullptr || l == nullptr) {
    return c.alarm(SharedAlarm::kMissingData, i == nullptr ? "I" : "L",
                   fmt::format("{} needs I ({}) and L (number of holes)", code,
                               code10 == kHoleLine ? "spacing" : "radius"));
  }
  if (!integerWord(c, *l, 1, kMostHoles, out.count)) return false;
  out.length = lengthOf(plan, *i);
  if (out.length == 0.0) return c.alarm(SharedAlarm::kOutOfRange, *i, "it must not be 0");
  if (const Word* j = c.word('J')) out.angle_deg = j->value;
  if (code10 == kHoleCircle) out.step_deg = 360.0 / static_cast<double>(out.count);
  const Word* k = code10 == kHoleArc ? c.word('K') : nullptr;
  if (code10 == kHoleArc && k == nullptr)
    return c.alarm(SharedAlarm::kMissingData, "K", "G71 needs K, the angle from hole to hole");
  if (k != nullptr) out.step_deg = k->value;
  return true;
}

}  // namespace

bool planHaasHoles(IsoContext& c, BlockPlan& plan) {
  const int code10 = plan.governor->code10;
  if (!plan.next.inCycle()) {
    return c.fail(
        "pattern-no-cycle",
        fmt::format("{} makes holes by a drilling cycle, and none is active: program G81 or another "
                    "one before (L0 keeps it from drilling there)",
                    gName(code10)));
  }
  HolePattern pattern;
  if (!readPattern(c, plan, pattern)) return false;
  plan.claimed = plan.claimed | (code10 == kHoleArc ? AddressSet("IJKL") : AddressSet("IJL"));
  if (!planCycleAtPoints(c, plan, fanucCycleRulesOf(true))) return false;
  const WorkPlane plane = planeOf(plan.next);
  const Vec2 center(plan.motion.target[plane.u], plan.motion.target[plane.v]);
  c.hole_points.clear();
  for (std::int64_t k = 0; k < pattern.count; ++k) {
    const bool line = code10 == kHoleLine;
    const double angle = degToRad(
        std::remainder(pattern.angle_deg + (line ? 0.0 : pattern.step_deg * static_cast<double>(k)), 360.0));
    const double reach = line ? pattern.length * static_cast<double>(k) : pattern.length;
    c.hole_points.push_back(center + reach * Vec2(std::cos(angle), std::sin(angle)));
  }
  return true;
}

}  // namespace proveout::nc
