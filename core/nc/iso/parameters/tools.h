// Tool management.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class ToolParam : std::uint16_t { kLifeAtT, kRows, kUserColumns, kOffsetCode, kPlaceCode, kCount };
constexpr ParamId paramId(ToolParam p) { return {ParamChapter::kTools, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
