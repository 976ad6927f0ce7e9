// Offset tables, system variables, output of programs.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class DataParam : std::uint16_t {
  kCommonToolOffsets,
  kDiameterDisplay,
  kLatheOffsets,
  kMaxWear,
  kTurningOffsets,
  kProgramCoordinates,
  kTipPositions,
  kPrintNoSpaces,
  kPartCountM,
  kCount
};
constexpr ParamId paramId(DataParam p) { return {ParamChapter::kData, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
