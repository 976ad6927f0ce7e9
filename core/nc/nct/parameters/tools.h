// Tool management.
#pragma once

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in tools.cpp.
enum class ToolParam : std::uint16_t { kLifeAtT, kRows, kUserColumns, kOffsetCode, kPlaceCode, kCount };
constexpr ParamId paramId(ToolParam p) { return {ParamChapter::kTools, static_cast<std::uint16_t>(p)}; }
std::span<const ParamInfo> toolParams();

}  // namespace proveout::nc
