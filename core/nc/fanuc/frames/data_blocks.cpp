// The blocks between G10 L50, L52, L3 and G11 (iso-fanuc, section 6).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

constexpr int kChapters = static_cast<int>(ParamChapter::kCount);
constexpr int kStartUpParameter = 5003;  ///< #0 SUP, #1 SUV
constexpr double kLeastIncrementMm = 0.001;

/// Bit of an R that is written as eight binary digits: R00000100 has bit 2.
int binaryDigit(double r, int bit) {
  const double shifted = std::floor(std::abs(r) / std::pow(10.0, bit));
  return std::fmod(shifted, 10.0) != 0.0 ? 1 : 0;
}

bool hasOwnUnit(const Word& w) { return w.from_expression || w.point; }

/// A value as the row counts it: lengths without a point are least increments.
double wholeValue(const ParamInfo& row, const Word& r) {
  const bool length = row.choices.empty() && row.meaning.find("mm") != std::string_view::npos;
  return length && !hasOwnUnit(r) ? r.value * kLeastIncrementMm : r.value;
}

bool refuseFanucParameter(IsoContext& c, ParamStatus status, const ParamInfo& row, const Word& r) {
  switch (status) {
    case ParamStatus::kOk:
      return true;
    case ParamStatus::kRestart:
      c.warn(
          "parameter",
          fmt::format("{} takes effect when the control is switched on: it stays as the job says", row.name),
          r.columns, Severity::kNote);
      return true;
    case ParamStatus::kNeedsIndex:
    case ParamStatus::kBadIndex:
      return c.failWord("031", "illegal P command in G10: there is no such axis or spindle", r);
    default:
      return c.alarm(SharedAlarm::kOutOfRange, r,
                     fmt::format("beyond the limits of parameter {} ({})", row.number, row.name));
  }
}

/// The type of start-up is made of two bits.
void takeStartUp(IsoContext& c, const Word& r, const Word* bit) {
  const auto now = static_cast<int>(c.parameters[FanucParam::kCompStartUp]);
  int sup = now == 1 ? 1 : 0, suv = now == 2 ? 1 : 0;
  const auto take = [&](int k, int& value) {
    if (bit == nullptr) value = binaryDigit(r.value, k);
    if (bit != nullptr && bit->value == k) value = r.value != 0.0 ? 1 : 0;
  };
  take(0, sup);
  take(1, suv);
  c.parameters.put(FanucParam::kCompStartUp, suv != 0 ? 2.0 : sup);
}

/// Choices that are 0 here where the bit of the control is 1: 3401#0 DPI, 1202#3 RLC, 5002#6 LWM.
bool isTurnedOver(const ParamInfo& row) {
  return row.name == "decimal" || row.name == "g52_at_end" || row.name == "wear_moves";
}

/// The digit of a row that is one bit.
double bitValue(const ParamInfo& row, double digit) {
  return isTurnedOver(row) ? (digit != 0.0 ? 0.0 : 1.0) : digit;
}

bool takeRow(IsoContext& c, const ParamInfo& row, const Word& r, int index) {
  const bool bit = row.bit >= 0;
  const bool by_number = c.word('Q') != nullptr;
  const double digit = !bit ? 0.0 : by_number ? r.value : binaryDigit(r.value, row.bit);
  const double value = bit ? bitValue(row, digit) : wholeValue(row, r);
  const bool each = row.scope == ParamScope::kAxis || row.scope == ParamScope::kSpindle;
  const ParamStatus status = c.parameters.write(row.number, bit ? row.bit : kWholeParam,
                                                each ? std::max(index, 1) : 0, value, false);
  return refuseFanucParameter(c, status, row, r);
}

bool fanucParameterBlock(IsoContext& c) {
  for (const Word& w : c.block.words) {
    if (!AddressSet("NPQR").has(w.address))
      return c.alarm(SharedAlarm::kIllegalAddress, w, "in parameter input (G10 L50, L52)");
  }
  const Word *n = c.word('N'), *r = c.word('R'), *q = c.word('Q'), *p = c.word('P');
  if (n == nullptr) return c.alarm(SharedAlarm::kMissingData, "N", "the number of the parameter");
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "the value of the parameter");
  std::int64_t number = 0, index = 0, bit = 0;
  if (!integerWord(c, *n, 0, 99999, number) || (p && !integerWord(c, *p, 0, 99, index)) ||
      (q && !integerWord(c, *q, 0, 7, bit)))
    return false;
  if (number == kStartUpParameter) {
    takeStartUp(c, *r, q);
    return true;
  }
  bool known = false;
  for (int chapter = 0; chapter < kChapters; ++chapter) {
    for (const ParamInfo& row : c.parameters.table().chapter(static_cast<ParamChapter>(chapter))) {
      if (row.name.empty() || row.number != number || (q && row.bit >= 0 && row.bit != bit)) continue;
      known = true;
      if (!takeRow(c, row, *r, static_cast<int>(index))) return false;
    }
  }
  if (!known) {
    c.warnOnce(fmt::format("parameter {}", number), "parameter",
               fmt::format("parameter {} has no effect in the simulation", number), n->columns,
               Severity::kNote);
  }
  configureFeeds(c);
  return true;
}

bool fanucLifeBlock(IsoContext&) { return true; }

template <DataInput block>
bool openFanucData(IsoContext& c, BlockPlan&) {
  c.data_input = block;
  return true;
}

}  // namespace

bool planFanucParameters(IsoContext& c, BlockPlan& plan) {
  for (const Word& w : c.block.words) {
    if (w.address != 'G' && w.address != 'L' && w.address != 'P')
      return c.alarm(SharedAlarm::kIllegalAddress, w, "G10 L50 and L52 stand alone");
  }
  plan.perform = openFanucData<fanucParameterBlock>;
  return true;
}

bool planFanucToolLife(IsoContext& c, BlockPlan& plan) {
  c.warnOnce("tool life", "tool-life",
             "tool life data (G10 L3) are noted: T takes the tool of its own number, lives are not counted",
             {}, Severity::kNote);
  plan.perform = openFanucData<fanucLifeBlock>;
  return true;
}

}  // namespace proveout::nc
