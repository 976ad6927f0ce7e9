// Exit codes of the program; the contract with pipelines.
#pragma once

#include "core/base/result.h"
#include "io/report.h"

namespace proveout {

inline constexpr int kExitOk = 0;             ///< done, nothing over tolerance
inline constexpr int kExitFindings = 1;       ///< done, findings of severity error
inline constexpr int kExitInput = 2;          ///< bad file, program alarm, bad usage
inline constexpr int kExitResource = 3;       ///< memory or time limit
inline constexpr int kExitInterrupted = 130;  ///< Ctrl-C

inline int exitCodeOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kResourceLimit:
      return kExitResource;
    case ErrorKind::kInterrupted:
      return kExitInterrupted;
    case ErrorKind::kInput:
    case ErrorKind::kInternal:
      break;
  }
  return kExitInput;
}

inline int exitCodeOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return kExitOk;
    case Verdict::kFail:
      return kExitFindings;
    case Verdict::kError:
      break;
  }
  return kExitInput;
}

}  // namespace proveout
