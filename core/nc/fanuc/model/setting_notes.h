// Notes of settings that a path depends on.
#pragma once

#include <fmt/core.h>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The path of the block in hand depends on the setting `key`: told once a run, where the job does not give
/// it (`given`). `meaning`: what the value in force does.
inline void noteSettingOf(IsoContext& c, std::string_view key, bool given, std::string_view meaning,
                          Columns at = {}) {
  if (given || !c.firstTime(fmt::format("setting {}", key))) return;
  c.warn("setting", fmt::format("the path depends on the setting {} of the machine: {}", key, meaning), at,
         Severity::kNote);
}

/// The same with the setting's own row.
template <class Enum>
void noteSetting(IsoContext& c, Enum p, std::string_view meaning, Columns at = {}) {
  noteSettingOf(c, c.parameters.name(p), c.parameters.given(p), meaning, at);
}

}  // namespace proveout::nc
