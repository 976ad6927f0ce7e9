// Offset tables, length and cutter compensation.
#pragma once

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in comp.cpp.
enum class CompParam : std::uint16_t {
  kToolOffsets,
  kInterferenceCheck,
  kInterferenceAlarm,
  kExtraLookAhead,
  kMinCompStep,
  kLengthAlwaysZ,
  kLengthByPlane,
  kCount
};
constexpr ParamId paramId(CompParam p) { return {ParamChapter::kComp, static_cast<std::uint16_t>(p)}; }
std::span<const ParamInfo> compParams();

}  // namespace proveout::nc
