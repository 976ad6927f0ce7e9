// Tables of the WL4 control: codes and functions (digest wl4, 4.1 and 6).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/nc/coverage.h"
#include "core/nc/wl4/wl4_parameters.h"

namespace proveout::nc {

/// Of two codes of one group in a block the last one counts.
enum class Wl4Group : std::uint8_t {
  kMotion,
  kDeed,  ///< one-shot: what the block does in place of a motion
  kPlane,
  kRadius,
  kLength,
  kSystem,
  kStop,
  kCycle,
  kDistance,
  kFeed,
  kSpeed,
  kFlag  ///< one-shot: several may stand in a block
};

struct Wl4GCode {
  int code;
  Wl4Group group;
  std::string_view cls, ids, meaning;
};
/// Null: the control has no such code.
const Wl4GCode* wl4GCode(int code);

enum class Wl4Phase : std::uint8_t { kStart, kEnd };
/// When an M function acts in its block.
Wl4Phase wl4Phase(int m);

/// What the code supports, and the rows of the manual.
std::vector<CoverageRow> wl4Coverage();
std::vector<CoverageIdRow> wl4CoverageIds();

}  // namespace proveout::nc
