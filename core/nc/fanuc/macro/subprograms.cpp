// M98, M198: which program, how often, from which block on (section 11 of the rows).
#include <fmt/core.h>

#include "core/nc/fanuc/macro/macro_rules.h"
#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr std::int64_t kMostNumber = 99'999'999, kNumberDigits = 10'000;
constexpr int kExternalCall = 198;

bool isThere(IsoContext& c, std::int64_t number, bool folders_first) {
  return c.programs.byNumber(c.calls.top().file, number, folders_first).text != nullptr;
}

/// "P8": the last four digits are the number, what stands in front of them the repetitions. A number of more
/// digits that is there under this name alone is taken as it is.
void partNumber(IsoContext& c, const Word& p, SubprogramCall& call) {
  const std::int64_t whole = call.number, number = whole % kNumberDigits;
  if (whole < kNumberDigits) return;
  if (isThere(c, whole, call.folders_first) && (number == 0 || !isThere(c, number, call.folders_first))) {
    c.warnOnce(fmt::format("long-number {}", whole), "long-number",
               fmt::format("P{0} is read as program O{0}, which is there; with four digits for the number it "
                           "would be O{1:04} {2} times (subprogram_form)",
                           whole, number, whole / kNumberDigits),
               p.columns);
    return;
  }
  noteSetting(c, FanucParam::kSubprogramForm,
              fmt::format("P{} is program O{:04} {} times, with the form L it is program O{}", whole, number,
                          whole / kNumberDigits, whole));
  call.number = number;
  call.count = whole / kNumberDigits;
}

}  // namespace

bool fanucSubprogram(IsoContext& c, int code, SubprogramCall& call) {
  const Word* p = c.word('P');
  const Word* l = c.word('L');
  const Word* q = c.word('Q');
  call.folders_first = code == kExternalCall;
  if (q != nullptr && !integerWord(c, *q, 1, kMostNumber, call.block)) return false;
  if (l != nullptr && !integerWord(c, *l, 0, kMostNumber, call.count)) return false;
  if (l != nullptr && call.count == 0) {
    if (c.firstTime("call-none"))
      c.warn("call-none", fmt::format("M{} L0 calls nothing", code), l->columns, Severity::kNote);
    return true;
  }
  if (c.block.has_file) return true;
  if (p == nullptr) {
    return c.fail(SharedAlarm::kProgramNotFound,
                  fmt::format("program not found: M{} needs P with the number of the program", code));
  }
  if (!integerWord(c, *p, 1, kMostNumber, call.number)) return false;
  const bool haas = c.parameters[FanucParam::kFlavour] == 1.0;
  const bool by_l = l != nullptr || haas || c.parameters[FanucParam::kSubprogramForm] == 1.0;
  if (!by_l) partNumber(c, *p, call);
  if (call.number == 0)
    return c.alarm(SharedAlarm::kProgramNotFound, *p, "the last four digits are the number of the program");
  return true;
}

}  // namespace proveout::nc
