// Codes that parameters turn into calls of programs (manual 23.3.4-23.3.8).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

/// What a code calls. `code` tells calls apart: see systemCode().
struct SystemCall {
  std::int32_t code = -1;
  std::int32_t program = 0;  ///< O number in the folder of the system macros
  bool modal = false;        ///< G: stays active until G67
  int variable = 0;          ///< letters: the global that gets the value
};

/// A letter that calls a subprogram where its parameter says so.
struct SystemLetter {
  Address letter;
  MacroParam parameter;
  std::int32_t program;
  int variable;  ///< gets the value of the word
};
constexpr MacroParam paramBehind(MacroParam first, int offset) {
  return static_cast<MacroParam>(static_cast<int>(first) + offset);
}
inline constexpr std::array<SystemLetter, 5> kSystemLetters{
    {{'A', MacroParam::kLetterA, 9030, 195},
     {'B', paramBehind(MacroParam::kLetterA, 1), 9031, 196},
     {'C', paramBehind(MacroParam::kLetterA, 2), 9032, 197},
     {'S', paramBehind(MacroParam::kLetterA, 3), 9033, 198},
     {'T', paramBehind(MacroParam::kLetterA, 4), 9034, 199}}};

/// One number for each code that can call: G tenfold, M and letters beyond all G.
constexpr std::int32_t systemCode(Address letter, std::int32_t code10) {
  constexpr std::int32_t kLetters = 1'100'000'000, kM = 1'000'000'000;
  if (letter == 'G') return code10;
  return letter == 'M' ? kM + code10 / 10 : kLetters + letter;
}
/// "G101", "G101.1", "M55", "T".
std::string systemCodeName(std::int32_t code);
constexpr bool isSystemG(std::int32_t code) { return code >= 0 && code < 1'000'000'000; }

/// The assignments of N1704 to N1754, worked out anew when a parameter has changed.
class SystemCalls {
 public:
  explicit SystemCalls(std::span<const SystemLetter> letters = kSystemLetters) : letters_known_(letters) {}
  /// Call before each look-up; costs a comparison.
  void update(const IsoParameters& parameters) {
    if (revision_ != parameters.revision()) rebuild(parameters);
  }
  bool none() const { return g_.empty() && m_macros_.empty() && !anySubprogram(); }
  bool anyG() const { return !g_.empty(); }
  bool anyMMacro() const { return !m_macros_.empty(); }
  bool anySubprogram() const { return !m_subprograms_.empty() || !letters_.empty(); }

  /// False: the code calls nothing. code10 is the G number tenfold.
  bool g(std::int32_t code10, SystemCall& out) const { return find(g_, code10, 'G', out); }
  bool mMacro(std::int32_t m, SystemCall& out) const { return find(m_macros_, 10 * m, 'M', out); }
  bool mSubprogram(std::int32_t m, SystemCall& out) const { return find(m_subprograms_, 10 * m, 'M', out); }
  bool letter(Address letter, SystemCall& out) const;
  /// The letters that call.
  AddressSet letters() const { return letter_set_; }
  /// What is wrong with the assignments; empty: nothing.
  const std::string& fault() const { return fault_; }

 private:
  /// Codes first, first + step, ...: each calls the next program.
  struct Range {
    std::int32_t first10, step10, count, program;
    bool modal;
  };
  struct Letter {
    Address letter;
    std::int32_t program;
    int variable;
  };
  static bool find(const std::vector<Range>& ranges, std::int32_t code10, Address letter, SystemCall& out);
  void rebuild(const IsoParameters& parameters);
  void addLetter(Address letter, std::int32_t program, int variable);

  std::span<const SystemLetter> letters_known_;
  std::uint32_t revision_ = 0;
  std::vector<Range> g_, m_macros_, m_subprograms_;
  std::vector<Letter> letters_;
  AddressSet letter_set_;
  std::string fault_;
};

}  // namespace proveout::nc
