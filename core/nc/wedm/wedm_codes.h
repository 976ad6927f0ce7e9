// The codes of the wire EDM control: rows that execute, and that `proveout coverage` prints (digest wedm,
// D16).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"
#include "core/nc/wedm/wedm_state.h"

namespace proveout::nc {

/// Of one group a block has one code at most; codes of kMirror add up.
enum class WedmGroup : std::uint8_t {
  kOneShot,
  kMotion,
  kMirror,
  kSkip,
  kUnits,
  kCorner,
  kExtension,
  kSlow,
  kOvercut,
  kOffset,
  kTaper,
  kSystem,
  kShape,
  kFourAxis,
  kDistance
};

struct WedmGCode {
  int code;
  WedmGroup group;
  int WedmState::*mode;           ///< that takes the code; null: `set` does it
  void (*set)(WedmState& state);  ///< or null
  std::string_view cls, ids, meaning;
};
std::span<const WedmGCode> wedmGCodes();
/// Null: the control has no such code.
const WedmGCode* wedmGCode(int code);

/// M00, M02, M50, M60, M98, M99 and T84 to T87.
struct WedmFunction {
  char address;
  int code;
  int WedmState::*flag;  ///< that it sets to `value`, or null
  int value;
  std::string_view cls, ids, meaning;
};
std::span<const WedmFunction> wedmFunctions();
const WedmFunction* wedmFunction(char address, int code);

/// What a row of coverage is that no code stands for.
struct WedmFeature {
  std::string_view code, cls, ids, meaning;
};
std::span<const WedmFeature> wedmFeatures();

std::vector<CoverageRow> wedmCoverage();
std::vector<CoverageIdRow> wedmCoverageIds();
std::map<std::string, std::string_view> wedmOpenReasons();

}  // namespace proveout::nc
