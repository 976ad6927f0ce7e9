// Notes of settings that a path depends on.
#pragma once

#include <fmt/core.h>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The path of the block in hand depends on a setting: told once a run, where the job does not give it.
/// `meaning`: what the value in force does.
template <class Enum>
void noteSetting(IsoContext& c, Enum p, std::string_view meaning) {
  if (c.parameters.given(p)) return;
  const std::string_view key = c.parameters.name(p);
  if (!c.firstTime(fmt::format("setting {}", key))) return;
  c.warn("setting", fmt::format("the path depends on the setting {} of the machine: {}", key, meaning), {},
         Severity::kNote);
}

}  // namespace proveout::nc
