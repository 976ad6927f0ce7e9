// The words of a call as arguments of its macro (section 12 of the rows).
#include "core/nc/iso/macro/arguments.h"

#include <fmt/core.h>

#include "core/nc/fanuc/macro/macro_rules.h"
#include "core/nc/fanuc/text/decimal.h"
#include "core/nc/iso/context/origins.h"

namespace proveout::nc {
namespace {

constexpr const char* kArgumentAlarm = "129";

/// Variables of A to Z, arguments I; 0: no argument.
constexpr std::array<std::int8_t, 26> kFanucLetterVariables{1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                            0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr std::size_t kGVariable = 10, kNVariable = 14;  // of the blocks of G66.1

/// I, J, K in their order, arguments II: a letter that is not behind the one before it begins the next set.
class CentreSets {
 public:
  /// The variable of the next letter; 0: there are no more sets.
  std::size_t next(Address letter) {
    if (last_ != 0 && letter <= last_) ++set_;
    last_ = letter;
    constexpr int kSets = 10;
    if (set_ >= kSets) return 0;
    return static_cast<std::size_t>(4 + 3 * set_ + (letter - 'I'));
  }

 private:
  Address last_ = 0;
  int set_ = 0;
};

bool refuseArgument(IsoContext& c, const Word& w, std::string_view detail) {
  return c.failWord(kArgumentAlarm,
                    fmt::format("illegal argument address {}: {}", wordName(w, c.block), detail), w);
}

}  // namespace

bool fanucArguments(IsoContext& c, const ArgumentRules& rules, Arguments& out) {
  CentreSets sets;
  if (c.block.program >= 0)
    return c.fail(kArgumentAlarm, "illegal argument address O", c.block.program_columns);
  const bool number_behind = !rules.of_block && rules.call != nullptr && c.block.number >= 0 &&
                             c.block.number_columns.begin > rules.call->columns.begin;
  if (number_behind)
    return c.fail(kArgumentAlarm, "illegal argument address N: the block number stands in front of the call",
                  c.block.number_columns);
  if (rules.of_block && c.block.number >= 0) out.v[kNVariable] = {static_cast<double>(c.block.number)};
  for (const Word& w : c.block.words) {
    // P and L belong to the call itself.
    if (&w == rules.call ||
        (!rules.of_block && (w.address == 'L' || (w.address == 'P' && rules.weak.has('P')))))
      continue;
    const Value value{fanucArgument(c, w), false, numberOf(c, w, OriginKind::kArgument)};
    if (rules.of_block && w.address == 'G') {
      out.v[kGVariable] = value;
      continue;
    }
    if (w.address < 'A' || w.address > 'Z') return refuseArgument(c, w, "arguments are single letters");
    const bool centre = w.address >= 'I' && w.address <= 'K';
    const auto variable =
        centre ? sets.next(w.address)
               : static_cast<std::size_t>(kFanucLetterVariables[static_cast<std::size_t>(w.address - 'A')]);
    if (variable == 0) {
      return refuseArgument(c, w,
                            centre
                                ? "there are more than 10 sets of I, J, K"
                                : "G, L, N, O and P are no arguments: a G code stands in a block of its own");
    }
    out.v[variable] = value;
  }
  return true;
}

double fanucStepsPerUnit(const IsoContext& c, Address address) {
  const bool inch = c.state.active[kGroupUnits] == gcode::kInch;
  if (address == 'F') return c.state.perTurn() ? (inch ? 10000.0 : 100.0) : (inch ? 100.0 : 1.0);
  if (AddressSet("ABC").has(address)) return 1000.0;
  if (AddressSet("XYZUVWIJKRQEcr").has(address)) return inch ? 10000.0 : 1000.0;
  return 1.0;
}

}  // namespace proveout::nc
