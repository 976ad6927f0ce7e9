// Offset tables, length and cutter compensation.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

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

}  // namespace proveout::nc
