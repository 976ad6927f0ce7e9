#include "core/nc/iso/macro/arguments.h"

#include <bitset>

#include "core/nc/iso/context/origins.h"

namespace proveout::nc {
namespace {

/// Variable of each letter, argument type I.
constexpr std::array<int, 26> kLetterVariables{
    1,   // A
    2,   // B
    3,   // C
    7,   // D
    8,   // E
    9,   // F
    10,  // G
    11,  // H
    4,   // I
    5,   // J
    6,   // K
    12,  // L
    13,  // M
    14,  // N
    15,  // O
    16,  // P
    17,  // Q
    18,  // R
    19,  // S
    20,  // T
    21,  // U
    22,  // V
    23,  // W
    24,  // X
    25,  // Y
    26   // Z
};

constexpr int kSeries = 10;  ///< groups of I, J, K, argument type II

class ArgumentCollector {
 public:
  explicit ArgumentCollector(Arguments& out) : out_(out) {}

  void storeWeak(Address letter, const Value& value) { out_.v[variableOf(letter)] = value; }
  /// False: the variable is taken.
  bool store(Address letter, const Value& value) {
    if (letter >= 'I' && letter <= 'K') return storeInSeries(letter, value);
    return storeAt(variableOf(letter), value);
  }

 private:
  static std::size_t variableOf(Address letter) {
    return static_cast<std::size_t>(kLetterVariables[static_cast<std::size_t>(letter - 'A')]);
  }
  bool storeAt(std::size_t variable, const Value& value) {
    if (taken_[variable]) return false;
    taken_.set(variable);
    out_.v[variable] = value;
    return true;
  }
  bool storeInSeries(Address letter, const Value& value) {
    for (int n = 0; n < kSeries; ++n) {
      if (storeAt(variableOf(letter) + 3u * static_cast<std::size_t>(n), value)) return true;
    }
    return false;
  }

  Arguments& out_;
  std::bitset<kLocalCount + 1> taken_;
};

}  // namespace

bool collectArguments(IsoContext& c, const ArgumentRules& rules, Arguments& out) {
  if (c.dialect.arguments != nullptr) return c.dialect.arguments(c, rules, out);
  ArgumentCollector collector(out);
  const auto argument = [&](const Word& w) {
    return Value{w.value, false, numberOf(c, w, OriginKind::kArgument)};
  };
  AddressSet weak_seen;
  for (const Word& w : c.block.words) {
    const bool letter = w.address >= 'A' && w.address <= 'Z';
    if (!letter || w.incremental) return c.alarm(SharedAlarm::kIllegalAddress, w, "no argument of a macro");
    const bool weak = rules.weak.has(w.address);
    if (weak && weak_seen.has(w.address)) return c.alarm(SharedAlarm::kIllegalAddress, w, "given twice");
    if (weak) {
      weak_seen.add(w.address);
      collector.storeWeak(w.address, argument(w));
    }
  }
  if (c.block.program >= 0 && !collector.store('O', {static_cast<double>(c.block.program)}))
    return c.alarm(SharedAlarm::kIllegalAddress, "O", "given twice", c.block.program_columns);
  for (const Word& w : c.block.words) {
    if (&w == rules.call || rules.weak.has(w.address)) continue;
    if (!collector.store(w.address, argument(w)))
      return c.alarm(SharedAlarm::kIllegalAddress, w, "its variable has a value already");
  }
  return true;
}

}  // namespace proveout::nc
