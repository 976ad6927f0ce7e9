#include "core/nc/fanuc/lathe/run_out.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_words.h"

namespace proveout::nc {

RunOut runOutOf(IsoContext& c, double lead) {
  if (latheData(c).run_out)
    noteSetting(
        c, FanucParam::kThreadChamfer,
        fmt::format("threads end in a run-out of {:g} leads", c.parameters[FanucParam::kThreadChamfer]));
  return runOutOf(c, lead, c.parameters[FanucParam::kThreadChamfer]);
}

RunOut runOutOf(IsoContext& c, double lead, double leads) {
  if (!latheData(c).run_out) return {};
  return {leads * lead, std::tan(degToRad(c.parameters[FanucParam::kThreadChamferAngle]))};
}

bool cutThreadTo(LatheMoves& moves, const Vec2& end, double level, double lead, const RunOut& run_out) {
  const Vec2 way = end - moves.at();
  const double along = std::abs(way.x());
  const double length = std::min(run_out.length, along);
  if (!(length > 0.0)) return moves.thread(end, lead);
  const Vec2 leave = moves.at() + (1.0 - length / along) * way;
  const double room = std::abs(level - leave.y());
  const double rise = std::min(room, length * run_out.slope);
  const double out = run_out.slope > 0.0 ? rise / run_out.slope : length;
  const Vec2 last(leave.x() + std::copysign(out, way.x()),
                  leave.y() + std::copysign(rise, level - leave.y()));
  return moves.thread(leave, lead) && moves.thread(last, lead);
}

}  // namespace proveout::nc
