// G22 and G23: zone 2 of the program (manual chapter 22).
#include <fmt/core.h>

#include <limits>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

bool performZone(IsoContext& c, BlockPlan& plan) {
  const ZoneChange& change = std::get<ZoneChange>(plan.payload);
  c.registers.program_zone.reset();
  if (change.on) c.registers.program_zone = change.zone;
  return c.stages.zone.configure();
}

}  // namespace

bool planZoneOn(IsoContext& c, BlockPlan& plan) {
  if (!ownBlockOf(c, "G22", "XYZIJKP")) return false;
  std::int64_t outside = 0;
  if (const Word* p = c.word('P'); p && !integerWord(c, *p, 0, 1, outside)) return false;
  plan.motion.target = plan.start;
  plan.perform = performZone;
  ZoneChange& change = plan.payload.emplace<ZoneChange>();
  change.on = true;
  change.zone = endlessZone(outside == 1);
  bool point = true;
  for (int k = 0; k < kMainAxes; ++k) {
    const Word* high = c.word("XYZ"[k]);
    const Word* low = c.word("IJK"[k]);
    if (high && high->incremental)
      return c.alarm(SharedAlarm::kIncremental, *high, "limits of G22 are machine coordinates");
    boundZone(change.zone, k, low ? lengthOf(plan, *low) : -kNoLimit,
              high ? lengthOf(plan, *high) : kNoLimit);
    if (change.zone.low[k] > change.zone.high[k]) {
      return c.alarm(SharedAlarm::kOutOfRange, *high, "the positive limit of G22 is below the negative one");
    }
    point = point && change.zone.low[k] == change.zone.high[k];
  }
  if (!point) return true;
  // X = I, Y = J, Z = K: everything is allowed with P0, and with P1 forbidden, that point too (manual 22.2).
  if (outside == 0) change.zone.axes.reset();
  if (outside == 1) {
    change.zone.high[0] = -kNoLimit;
    change.zone.low[0] = -kNoLimit;
  }
  return true;
}

bool planZoneOff(IsoContext& c, BlockPlan& plan) {
  if (!ownBlockOf(c, "G23", {})) return false;
  plan.motion.target = plan.start;
  plan.perform = performZone;
  plan.payload.emplace<ZoneChange>();
  return true;
}

}  // namespace proveout::nc
