// Macro language and macro calls.
#pragma once

#include "core/nc/nct/nct_parameters.h"

namespace proveout::nc {

/// Order of the rows in macro.cpp.
enum class MacroParam : std::uint16_t {
  kReadAhead,
  kProtectFirst,
  kProtectLast,
  kMacroBlocksBesideMotion,
  kCount
};
constexpr ParamId paramId(MacroParam p) { return {ParamChapter::kMacro, static_cast<std::uint16_t>(p)}; }
std::span<const ParamInfo> macroParams();

}  // namespace proveout::nc
