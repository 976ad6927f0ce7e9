#include "core/nc/iso/system_variables/status_bank.h"

#include <cmath>

#include "core/nc/iso/context/context.h"
#include "core/nc/iso/system_variables/plc_bank.h"

namespace proveout::nc {
namespace {

enum StatusNumber : int {
  kClock = 3001,
  kCutting = 3002,
  kControl1 = 3003,
  kControl2 = 3004,
  kMirrored = 3007,
  kDate = 3011,
  kTime = 3012,
  kPartsMade = 3901,
  kPartsWanted = 3902,
  kPalletPlace = 8500,
  kPalletFirst = 8501,
  kPalletLast = 8505,
  kPalletUserFirst = 8531,
  kPalletUserLast = 8534,
  // Names without numbers: beyond what programs can write as a number.
  kSearchAndTest = 1'000'000'001,
  kBlockSearch,
  kTestMode,
  kMachineLock,
  kNoSingleBlock,
  kNoStop,
  kNoOverride,
  kNoExactStop,
};

/// Bits of #_CNTBS.
constexpr double kTestBit = 2.0;

/// Whole milliseconds; sums of times that end at one may come out a little below it.
double wholeMs(double ms) { return std::floor(ms + 1e-6); }

}  // namespace

void StatusBank::addTo(VariableStore& store) {
  const auto add = [&](const char* name, int number) { store.addSymbol({name, number}); };
  for (const auto& [first, last] : {std::pair<int, int>{kClock, kControl2},
                                    {kMirrored, kMirrored},
                                    {kDate, kTime},
                                    {kPartsMade, kPartsWanted},
                                    {kPalletPlace, kPalletLast},
                                    {kPalletUserFirst, kPalletUserLast},
                                    {kSearchAndTest, kNoExactStop}}) {
    if (first >= kPalletPlace && first <= kPalletUserLast && !rules_.pallets) continue;
    store.addBank(first, last, *this);
  }
  add("CLOCK1", kClock);
  add("CLOCK2", kCutting);
  add("CNTL1", kControl1);
  add("CNTL2", kControl2);
  add("MIRIMG", kMirrored);
  add("DATE", kDate);
  add("TIME", kTime);
  add("PRTSA", kPartsMade);
  add("PRTSN", kPartsWanted);
  add("CNTBS", kSearchAndTest);
  add("BSEARCH", kBlockSearch);
  add("TEST", kTestMode);
  add("MCHLOCK", kMachineLock);
  add("M_SBK", kNoSingleBlock);
  add("M_FHD", kNoStop);
  add("M_OV", kNoOverride);
  add("M_EST", kNoExactStop);
}

/// A bit for each mirrored axis, by the axis's number.
double StatusBank::mirrorMask() const {
  double mask = 0.0;
  for (int axis = 0; axis < c_.axes.count(); ++axis) {
    if (!c_.state.transforms.mirrored[static_cast<std::size_t>(axis)]) continue;
    mask += std::ldexp(1.0, c_.axes.at(axis).number - 1);
  }
  return mask;
}

double StatusBank::timeOfDay() const {
  const int start = c_.host.person.time;
  const std::int64_t begin = start / 10000 * 3600 + start / 100 % 100 * 60 + start % 100;
  constexpr std::int64_t kDay = 86400;
  const std::int64_t now = (begin + static_cast<std::int64_t>(c_.clock.now_s())) % kDay;
  return static_cast<double>(now / 3600 * 10000 + now / 60 % 60 * 100 + now % 60);
}

VariableStatus StatusBank::read(int number, Value& out) {
  const AutomaticBits& bits = c_.state.automatic;
  const auto is = [](bool bit) { return Value{bit ? 1.0 : 0.0}; };
  const bool test = c_.host.person.test_mode;
  switch (number) {
    case kClock:
      out = {wholeMs(c_.clock.now_s() * 1000.0 - clock_start_ms_)};
      break;
    case kCutting:
      out = {wholeMs(c_.clock.cutting_s() * 1000.0 - cutting_start_ms_) / rules_.cutting_unit_ms};
      break;
    case kControl1:
    case kNoSingleBlock:
      out = {(bits.no_single_block ? 1.0 : 0.0) + (number == kControl1 && no_wait_ ? 2.0 : 0.0)};
      break;
    case kControl2:
      out = {(bits.no_stop ? 1.0 : 0.0) + (bits.no_override ? 2.0 : 0.0) + (bits.no_exact_stop ? 4.0 : 0.0)};
      break;
    case kNoStop:
      out = is(bits.no_stop);
      break;
    case kNoOverride:
      out = is(bits.no_override);
      break;
    case kNoExactStop:
      out = is(bits.no_exact_stop);
      break;
    case kMirrored:
      out = {mirrorMask()};
      break;
    case kDate:
      out = {static_cast<double>(c_.host.person.date)};
      break;
    case kTime:
      out = {timeOfDay()};
      break;
    case kPartsMade:
      out = {c_.registers.parts_made};
      break;
    case kPartsWanted:
      out = {c_.registers.parts_wanted};
      break;
    case kPalletPlace:
      out = {static_cast<double>(pallet_place_)};
      break;
    case kSearchAndTest:
      out = {test ? kTestBit : 0.0};
      break;
    case kTestMode:
      out = is(test);
      break;
    case kBlockSearch:
    case kMachineLock:
      out = {0.0};
      break;
    default:
      tellPallets();
      out = Value::none();
      break;
  }
  return VariableStatus::kDone;
}

VariableStatus StatusBank::writeCount(double& count, const Value& value) {
  const double whole = std::round(value.vacant ? 0.0 : value.number);
  constexpr double kMaxCount = 99'999'999;
  if (!(whole >= 0.0 && whole <= kMaxCount)) return VariableStatus::kLimit;
  count = whole;
  return VariableStatus::kDone;
}

VariableStatus StatusBank::writeBits(int number, const Value& value) {
  AutomaticBits& bits = c_.state.automatic;
  bool bit = false;
  if (number != kControl1 && number != kControl2) {
    if (!bitValue(value, bit)) return VariableStatus::kLimit;
    (number == kNoSingleBlock ? bits.no_single_block
     : number == kNoStop      ? bits.no_stop
     : number == kNoOverride  ? bits.no_override
                              : bits.no_exact_stop) = bit;
    return VariableStatus::kDone;
  }
  const double whole = std::round(value.vacant ? 0.0 : value.number);
  constexpr double kMostBits = 7;
  if (!(whole >= 0.0 && whole <= kMostBits)) return VariableStatus::kLimit;
  const auto set = static_cast<unsigned>(whole);
  if (number == kControl1) {
    bits.no_single_block = (set & 1u) != 0;
    no_wait_ = rules_.waits_for_m && (set & 2u) != 0;
  } else {
    bits.no_stop = (set & 1u) != 0;
    bits.no_override = (set & 2u) != 0;
    bits.no_exact_stop = (set & 4u) != 0;
  }
  return VariableStatus::kDone;
}

VariableStatus StatusBank::write(int number, const Value& value) {
  const double amount = value.vacant ? 0.0 : value.number;
  switch (number) {
    case kClock:
      clock_start_ms_ = c_.clock.now_s() * 1000.0 - amount;
      return VariableStatus::kDone;
    case kCutting:
      cutting_start_ms_ = c_.clock.cutting_s() * 1000.0 - amount * rules_.cutting_unit_ms;
      return VariableStatus::kDone;
    case kControl1:
    case kControl2:
    case kNoSingleBlock:
    case kNoStop:
    case kNoOverride:
    case kNoExactStop:
      return writeBits(number, value);
    case kPartsMade:
      return writeCount(c_.registers.parts_made, value);
    case kPartsWanted:
      return writeCount(c_.registers.parts_wanted, value);
    case kPalletPlace:
      if (amount != 10.0 && amount != 11.0) return VariableStatus::kLimit;
      pallet_place_ = static_cast<int>(amount);
      tellPallets();
      return VariableStatus::kDone;
    default:
      return VariableStatus::kReadOnly;
  }
}

void StatusBank::tellPallets() {
  if (!c_.firstTime("pallets")) return;
  c_.warn("noted", "there are no pallets in the simulation: their data are vacant", {}, Severity::kNote);
}

void countPart(IsoContext& c, int m) {
  const int chosen = static_cast<int>(c.parameters[DataParam::kPartCountM]);
  if (chosen == 0 ? m == mcode::kEnd || m == mcode::kEndAndRewind : m == chosen)
    c.registers.parts_made += 1.0;
}

}  // namespace proveout::nc
