// The formulas of LinuxCNC.
#pragma once

#include "core/nc/macro/formula_language.h"

namespace proveout::nc {

const FormulaLanguage& linuxCncFormulas();

}  // namespace proveout::nc
