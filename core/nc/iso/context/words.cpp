#include "core/nc/iso/context/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout::nc {

std::string gName(int code10) {
  return code10 % 10 ? fmt::format("G{}.{}", code10 / 10, code10 % 10) : fmt::format("G{}", code10 / 10);
}

std::int32_t code10Of(const Word& w) {
  const double tenfold = std::round(w.value * 10.0);
  if (!(tenfold >= 0.0 && tenfold <= 1e8)) return -1;
  if (!w.from_expression && std::abs(tenfold - w.value * 10.0) > 1e-6) return -1;
  return static_cast<std::int32_t>(tenfold);
}

std::int32_t mNumber(const Word& w) {
  const double whole = std::round(w.value);
  const bool integer = w.is_integer || w.from_expression;
  return integer && whole >= 0.0 && whole <= 99999999.0 ? static_cast<std::int32_t>(whole) : -1;
}

bool integerWord(IsoContext& c, const Word& w, std::int64_t min, std::int64_t max, std::int64_t& out) {
  // A computed value is rounded to the digits of the address (manual 23.1.1).
  const double value = w.from_expression ? std::round(w.value) : w.value;
  const bool whole = w.is_integer || w.from_expression;
  if (!whole || value < static_cast<double>(min) || value > static_cast<double>(max)) {
    return c.alarm(SharedAlarm::kOutOfRange, addressText(w.address),
                   fmt::format("an integer from {} to {} is expected", min, max), w.columns);
  }
  out = static_cast<std::int64_t>(value);
  return true;
}

bool takeWords(IsoContext& c) {
  if (c.dialect.take_words == nullptr || c.data_input != nullptr) return true;
  return c.dialect.take_words(c);
}

bool checkRepeats(IsoContext& c) {
  const Block& block = c.block;
  if (!block.negative.empty()) {
    const auto at = std::find_if(block.words.begin(), block.words.end(),
                                 [&](const Word& w) { return w.columns.begin == block.negative_at.begin; });
    const bool sign = c.dialect.lexing.number_alarms;
    return c.alarm(sign ? SharedAlarm::kSign : SharedAlarm::kOutOfRange, addressText(at->address),
                   "no minus sign here", block.negative_at);
  }
  if (block.repeated.empty()) return true;
  const auto at = std::find_if(block.words.begin(), block.words.end(),
                               [&](const Word& w) { return w.columns.begin == block.repeated_at.begin; });
  if (at->address == 'N')
    return c.alarm(SharedAlarm::kSyntax, "", "two N words in one block", block.repeated_at);
  return c.alarm(SharedAlarm::kDuplicateWord, addressText(at->address), {}, block.repeated_at);
}

}  // namespace proveout::nc
