// Travel of a rotary axis whose position is counted in one turn only (manual 5.6).
#pragma once

#include <cmath>

namespace proveout {

/// How a rotary axis takes its words: N0107 and N0108 of the nct control.
struct RolloverRule {
  bool on = false;        ///< false: the axis counts on over whole turns, like a linear one
  bool shortest = false;  ///< absolute words take the shorter way
  bool by_sign = false;   ///< the sign of an absolute word is the direction; wins over `shortest`
  double period = 360.0;  ///< travel of one turn, > 0
};

/// Remainder in [0, period).
inline double reduceTurn(double value, double period) {
  const double r = std::fmod(value, period);
  return r < 0.0 ? r + period : r;
}

/// Signed travel of an absolute word `target` from `current`; always less than a turn.
inline double rolloverTravel(double current, double target, const RolloverRule& rule) {
  if (!rule.on) return target - current;
  const double period = rule.period;
  const double here = reduceTurn(current, period);
  if (rule.by_sign) {
    const double there = std::fmod(std::abs(target), period);
    return target < 0.0 ? -reduceTurn(here - there, period) : reduceTurn(there - here, period);
  }
  const double travel = std::fmod(target - here, period);
  if (!rule.shortest) return travel;
  if (travel > 0.5 * period) return travel - period;
  return travel <= -0.5 * period ? travel + period : travel;
}

/// Signed travel of an incremental word: whole turns are cut.
inline double rolloverStep(double step, const RolloverRule& rule) {
  return rule.on ? std::fmod(step, rule.period) : step;
}

}  // namespace proveout
