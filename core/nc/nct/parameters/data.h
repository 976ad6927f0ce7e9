// Offset tables, system variables, output of programs.
#pragma once

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in data.cpp.
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
std::span<const ParamInfo> dataParams();

}  // namespace proveout::nc
