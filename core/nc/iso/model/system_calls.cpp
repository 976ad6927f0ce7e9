#include "core/nc/iso/model/system_calls.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/model/code_names.h"

namespace proveout::nc {
namespace {

constexpr int kG0 = 1000;  ///< in a parameter: G0, since 0 means none

std::int32_t tenths(double code) { return static_cast<std::int32_t>(std::lround(std::abs(code) * 10.0)); }
std::int32_t whole(double value) { return static_cast<std::int32_t>(std::lround(value)); }

}  // namespace

bool SystemCalls::find(const std::vector<Range>& ranges, std::int32_t code10, Address letter,
                       SystemCall& out) {
  for (const Range& range : ranges) {
    const std::int32_t offset = code10 - range.first10;
    if (offset < 0 || offset % range.step10 != 0 || offset / range.step10 >= range.count) continue;
    out = {systemCode(letter, code10), range.program + offset / range.step10, range.modal, 0};
    return true;
  }
  return false;
}

bool SystemCalls::letter(Address letter, SystemCall& out) const {
  for (const Letter& row : letters_) {
    if (row.letter != letter) continue;
    out = {systemCode(letter, 0), row.program, false, row.variable};
    return true;
  }
  return false;
}

void SystemCalls::addLetter(Address letter, std::int32_t program, int variable) {
  letters_.push_back({letter, program, variable});
  letter_set_.add(letter);
}

std::string systemCodeName(std::int32_t code) {
  if (isSystemG(code)) {
    return code % 10 != 0 ? fmt::format("G{}.{}", code / 10, code % 10) : fmt::format("G{}", code / 10);
  }
  const std::int32_t letters = systemCode(0, 0);
  if (code >= letters) return std::string(addressText(static_cast<Address>(code - letters)));
  return fmt::format("M{}", code - systemCode('M', 0));
}

void SystemCalls::rebuild(const IsoParameters& parameters) {
  *this = SystemCalls(letters_known_);
  revision_ = parameters.revision();
  const auto value = [&](MacroParam p) { return parameters[p]; };
  constexpr int kSingles = 10;
  for (int k = 0; k < kSingles; ++k) {
    const double g = value(paramBehind(MacroParam::kG9010, k));
    if (g != 0.0) g_.push_back({std::abs(g) == kG0 ? 0 : tenths(g), 10, 1, 9010 + k, g < 0.0});
    const double sub = value(paramBehind(MacroParam::kM9000, k)),
                 macro = value(paramBehind(MacroParam::kM9020, k));
    if (sub != 0.0) m_subprograms_.push_back({10 * whole(sub), 10, 1, 9000 + k, false});
    if (macro != 0.0) m_macros_.push_back({10 * whole(macro), 10, 1, 9020 + k, false});
  }
  const auto block = [&](std::vector<Range>& ranges, MacroParam start, std::int32_t step10) {
    const double first = value(start);
    const std::int32_t program = whole(value(paramBehind(start, 1))),
                       count = whole(value(paramBehind(start, 2)));
    if (count > 0) ranges.push_back({tenths(first), step10, count, program, first < 0.0});
  };
  block(g_, MacroParam::kGBlock, 10);
  block(g_, MacroParam::kGDecimalBlock, 1);
  block(m_subprograms_, MacroParam::kMSubprogramBlock, 10);
  block(m_macros_, MacroParam::kMMacroBlock, 10);
  for (const SystemLetter& row : letters_known_) {
    if (value(row.parameter) != 0.0) addLetter(row.letter, row.program, row.variable);
  }
  constexpr int kAsciiLetters = 4;
  for (int k = 0; k < kAsciiLetters; ++k) {
    const std::int32_t ascii = whole(value(paramBehind(MacroParam::kAsciiLetter, k)));
    const std::int32_t program = whole(value(paramBehind(MacroParam::kAsciiProgram, k)));
    if (ascii == 0) continue;
    const auto letter = static_cast<Address>(ascii);
    if (letter < 'A' || letter > 'Z' || AddressSet("GNOM").has(letter)) {
      fault_ = fmt::format("{}: {} is the code of no letter that may call (A to Z without G, M, N, O)",
                           parameters.name(paramBehind(MacroParam::kAsciiLetter, k)), ascii);
    } else {
      addLetter(letter, program, 191 + k);
    }
  }
  SystemCall call;
  for (const std::int32_t code10 :
       {gcode::kMacroCall, gcode::kMacroAfterMotions, gcode::kMacroOfBlocks, gcode::kMacroCancel}) {
    if (!g(code10, call)) continue;
    fault_ = fmt::format("G65, G66, G66.1 and G67 cannot call system macros ({} to {})",
                         parameters.name(MacroParam::kG9010),
                         parameters.name(paramBehind(MacroParam::kGDecimalBlock, 2)));
  }
}

}  // namespace proveout::nc
