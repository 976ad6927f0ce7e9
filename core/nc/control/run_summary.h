// How the interpretation of a program ended.
#pragma once

#include <cstdint>

#include "core/nc/control/kept_data.h"

namespace proveout {

/// How interpretation ended.
enum class ProgramEnd {
  kEndOfProgram,  ///< M2, M30, or the end of the main program's text
  kUntil,         ///< settings.until reached
  kAlarm,         ///< an error of the program
  kBlockLimit,    ///< settings.block_limit reached; also reported as an error
  kCancelled,     ///< progress.cancel()
};

struct InterpretSummary {
  ProgramEnd end = ProgramEnd::kEndOfProgram;
  std::uint64_t blocks = 0;   ///< executed blocks
  std::uint64_t motions = 0;  ///< motions sent to the sink
  int errors = 0;
  int warnings = 0;
  double cycle_s = 0.0;    ///< everything: motions, dwells, tool changes
  double cutting_s = 0.0;  ///< feed motions
  double rapid_s = 0.0;    ///< rapid motions
  KeptData kept = {};      ///< for the next program, of controls that keep something
  bool ok() const { return errors == 0 && end != ProgramEnd::kCancelled; }
};

}  // namespace proveout
