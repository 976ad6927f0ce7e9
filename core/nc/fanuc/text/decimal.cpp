#include "core/nc/fanuc/text/decimal.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr AddressSet kFanucLengths = "XYZUVWABCIJKRQcra";
constexpr AddressSet kFanucIntegers = "DHLMNOSTP";
constexpr double kMostMm = 999999.999, kMostInch = 99999.9999;
constexpr double kMostSpeed = 99999.0;

constexpr std::int32_t kDirectionComp = 1410;  // G141 of Haas

/// What the block is, as far as its numbers depend on it.
struct NumberRules {
  bool inch = false, per_turn = false, inverse = false;
  bool dwell = false, scaling = false, rotation = false, data = false, nurbs = false;
  bool thread = false;   ///< F is a lead, Q an angle of the spindle
  bool cycle = false;    ///< K counts repeats
  bool vector = false;   ///< I, J, K are a direction, which has no unit
  bool turning = false;  ///< a turning cycle: its P, Q, D, K, L have rules of their own
  bool haas = false, lathe = false, increments = false;
};

/// F of the code is a lead.
bool countsLead(std::int32_t code10) {
  return code10 == gcode::kThread || code10 == lathe_code::kThreading || code10 == lathe_code::kVaryingThread;
}

void takeCode(NumberRules& rules, const GCode& code, int number10) {
  switch (code.group) {
    case kGroupUnits:
      rules.inch = code.code10 == gcode::kInch;
      break;
    case kGroupFeedMode:
      rules.per_turn = code.code10 == gcode::kFeedPerTurn;
      rules.inverse = code.code10 == gcode::kInverseTime;
      break;
    case kGroupMotion:
      rules.thread = countsLead(code.code10);
      rules.nurbs = code.code10 == 62;
      rules.cycle = false;
      break;
    case kGroupCycle:
      rules.cycle = code.code10 != gcode::kCycleCancel;
      break;
    case kGroupScaling:
      rules.scaling = code.code10 != gcode::kScalingOff;
      break;
    case kGroupRotation:
      rules.rotation = true;
      break;
    default:
      break;
  }
  rules.vector = rules.vector || number10 == gcode::kTipByVector || number10 == kDirectionComp;
  rules.dwell = rules.dwell || number10 == 40;
  rules.data = rules.data || number10 == 100;
  rules.turning = rules.turning || (rules.lathe && number10 >= 700 && number10 < 800);
}

NumberRules rulesOf(const IsoContext& c) {
  NumberRules rules;
  rules.inch = c.state.active[kGroupUnits] == gcode::kInch;
  rules.per_turn = c.state.perTurn();
  rules.inverse = c.state.active[kGroupFeedMode] == gcode::kInverseTime;
  rules.thread = countsLead(c.state.active[kGroupMotion]) && !c.state.inCycle();
  rules.nurbs = c.state.active[kGroupMotion] == 62;
  rules.cycle = c.state.inCycle();
  rules.vector =
      c.state.five.tip == TipControl::kVector || c.state.active[kGroupRadiusComp] == kDirectionComp;
  rules.haas = isHaas(c);
  rules.lathe = isLathe(c);
  rules.increments = c.parameters.flag(FanucParam::kDecimal);
  if (!c.block.present.has('G')) return rules;
  for (const Word& w : c.block.words) {
    if (w.address != 'G') continue;
    const int number10 = code10Of(w);
    if (const GCode* code = number10 < 0 ? nullptr : c.codes.g(number10)) takeCode(rules, *code, number10);
  }
  return rules;
}

bool rotary(const IsoContext& c, const Word& w) {
  if (w.axis >= kMainAxes) return c.axes.at(w.axis).rotary();
  return w.axis < 0 && AddressSet("ABC").has(w.address);
}

/// Does the word have a rule of its own, so that it stays as it is written?
bool ownRule(const NumberRules& rules, const Word& w) {
  switch (w.address) {
    case 'P':
    case 'Q':
      return rules.turning || (rules.data && rules.lathe);
    case 'I':
    case 'J':
      return rules.vector || rules.scaling;
    case 'K':
      return rules.vector || rules.scaling || rules.nurbs || rules.turning || (rules.cycle && !rules.haas);
    case 'R':
      return rules.nurbs;
    default:
      return false;
  }
}

/// The value as a whole number of increments; `steps` of them are a unit.
double rounded(double value, double steps) {
  constexpr double kHalf = 0.5 + 1e-6;  // a half that the binary number misses is a half
  const double whole = std::floor(std::abs(value) * steps + kHalf) / steps;
  return value < 0.0 ? (whole > 0.0 ? -whole : 0.0) : whole;
}

void noteInteger(IsoContext& c, const NumberRules& rules, const Word& w) {
  if (w.value == 0.0 || fanucData(c).decimal_noted || c.parameters.given(FanucParam::kDecimal)) return;
  fanucData(c).decimal_noted = true;
  const double least = rotary(c, w) || !rules.inch ? 0.001 : 0.0001;
  noteSetting(c, FanucParam::kDecimal,
              fmt::format("{}{:g} without a point is taken as {:g}; with decimal = \"increment\" (parameter "
                          "3401#0 DPI = 0) it would be {:g}",
                          wordName(w, c.block), w.value, w.value, w.value * least),
              w.columns);
}

bool takeLength(IsoContext& c, const NumberRules& rules, Word& w) {
  const bool dwell = rules.dwell && (w.address == 'X' || w.address == 'U');
  const bool angle =
      rotary(c, w) || w.address == kCommaDirection || (rules.rotation && w.address == 'R') || dwell;
  const double steps = angle || !rules.inch ? 1e3 : 1e4;
  const bool bare = !w.point && !w.from_expression;
  if (rules.thread && w.address == 'Q') {
    if (w.point && !rules.haas)
      return c.alarm(SharedAlarm::kPoint, w, "the start angle is an integer in 0.001 degrees");
    if (!w.point) w.value *= 1e-3;
  } else if (bare && rules.increments) {
    w.value /= steps;
    if (dwell && w.value > 0.0 && w.value < 0.02 && c.firstTime("short dwell")) {
      c.warn("short-dwell",
             fmt::format("a dwell of {:g} ms: without a point it counts in milliseconds (decimal = "
                         "\"increment\")",
                         1e3 * w.value),
             w.columns, Severity::kNote);
    }
  } else if (bare) {
    noteInteger(c, rules, w);
  }
  if (!bare && !w.from_expression && w.decimals <= (steps > 1e3 ? 4 : 3)) {
    w.value += 0.0;  // no finer than increments as it is written; -0 is 0
  } else {
    w.value = rounded(w.value, steps);
    w.is_integer = std::floor(w.value) == w.value;
  }
  const double most = rules.inch && !angle ? kMostInch : kMostMm;
  return std::abs(w.value) <= most ||
         c.alarm(SharedAlarm::kOutOfRange, w, fmt::format("at most {:.10g}", most));
}

void takeFeed(IsoContext& c, const NumberRules& rules, Word& w) {
  if (w.point || w.from_expression || rules.inverse || !rules.increments) return;
  const bool turn = rules.thread || rules.per_turn;
  if (rules.thread) {
    w.value *= 1e-4;
  } else if (rules.per_turn) {
    w.value *= rules.inch ? 1e-4 : 1e-2;
  } else if (rules.inch) {
    w.value *= 1e-2;
  }
  w.is_integer = std::floor(w.value) == w.value;
  if (turn)
    noteSettingOf(c, "decimal (feed per turn)", false,
                  fmt::format("F without a point is taken as {:g} per turn (parameter 1403#0)", w.value),
                  w.columns);
}

/// A point where an integer stands: 007.
bool checkPoint(IsoContext& c, const NumberRules& rules, const Word& w) {
  const bool counts = w.address == 'K' && rules.cycle && !rules.haas;
  if (!w.point || rules.haas || rules.turning || (!counts && !kFanucIntegers.has(w.address))) return true;
  if (w.address == 'P' && (rules.scaling || rules.data)) return true;
  if (w.address == 'H' && rules.lathe) return true;  // a step of C
  return c.alarm(SharedAlarm::kPoint, w, "an integer stands here");
}

/// A coordinate with a point, no finer than increments and in range: it is what it says by all rules.
bool saysItself(const Word& w) {
  const bool coordinate = w.address >= 'X' && w.address <= 'Z';
  return coordinate && w.point && !w.from_expression && w.decimals <= 3 && std::abs(w.value) <= kMostInch &&
         (w.value != 0.0 || !w.minus);
}

}  // namespace

bool takeFanucWords(IsoContext& c) {
  if (std::all_of(c.block.words.begin(), c.block.words.end(), saysItself)) return true;
  const NumberRules rules = rulesOf(c);
  for (Word& w : c.block.words) {
    if (saysItself(w)) continue;
    if (!checkPoint(c, rules, w)) return false;
    const bool axis = w.address == kNamedWord && w.axis >= 0;
    if (w.address == 'F') {
      takeFeed(c, rules, w);
    } else if ((axis || kFanucLengths.has(w.address)) && !ownRule(rules, w)) {
      if (!takeLength(c, rules, w)) return false;
    } else if (w.address == 'S' && std::abs(w.value) > kMostSpeed) {
      return c.alarm(SharedAlarm::kOutOfRange, w, "at most 99999");
    }
  }
  return true;
}

double fanucArgument(const IsoContext& c, const Word& w) {
  constexpr AddressSet kLengths = "XYZUVWABCIJKRQ";
  const bool bare = !w.point && !w.from_expression && kLengths.has(w.address);
  if (!bare || !c.parameters.flag(FanucParam::kDecimal)) return w.value;
  const bool inch = c.state.active[kGroupUnits] == gcode::kInch && !rotary(c, w);
  return w.value / (inch ? 1e4 : 1e3);
}

}  // namespace proveout::nc
