// Macro language and macro calls.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in macro.cpp. Where several rows of one kind follow each other only the first has a
/// name.
enum class MacroParam : std::uint16_t {
  kReadAhead,
  kCommonLow,
  kCommonKept,
  kProtectFirst,
  kProtectLast,
  kG9010,                            ///< G codes of O9010 to O9019
  kGBlock = kG9010 + 10,             ///< first code, first program, number of codes
  kGDecimalBlock = kGBlock + 3,      ///< the same, codes with one decimal
  kM9000 = kGDecimalBlock + 3,       ///< M codes of the subprograms O9000 to O9009
  kMSubprogramBlock = kM9000 + 10,   ///< first code, first program, number of codes
  kM9020 = kMSubprogramBlock + 3,    ///< M codes of the macros O9020 to O9029
  kMMacroBlock = kM9020 + 10,        ///< first code, first program, number of codes
  kLetterA = kMMacroBlock + 3,       ///< bits of A B C S T
  kAsciiLetter = kLetterA + 5,       ///< four letters
  kAsciiProgram = kAsciiLetter + 4,  ///< their programs
  kModalFromEachBlock = kAsciiProgram + 4,
  kCallsInSystemPrograms,
  kMacroBlocksBesideMotion,
  kList8000,
  kList9000,
  kInterrupts,
  kInterruptAsSubprogram,
  kInterruptAtBlockEnd,
  kInterruptByEdge,
  kInterruptOwnCodes,
  kInterruptFromSystem,
  kInterruptOn,
  kInterruptOff,
  kSubNesting,    ///< most subprograms that may be open; 0: as many as all kinds of calls together
  kMacroNesting,  ///< the same of macros
  kMainPasses,    ///< M99 in the main program: how often that is run; 0: once
  kCount
};
constexpr ParamId paramId(MacroParam p) { return {ParamChapter::kMacro, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
