// The list of controls. A new control is a row of its own folder, named in controls.cpp.
#pragma once

#include <span>

#include "core/nc/control/control_row.h"

namespace proveout::nc {

/// All of them, in the order of ControlId.
std::span<const ControlRow* const> controlRows();
const ControlRow& rowOf(ControlId control);

/// What is said where a row lacks what only a built control has.
inline constexpr const char* kNotBuilt = "this control is known but this version cannot run it yet";

}  // namespace proveout::nc
