// The formulas of the nct control (manual 23.2).
#pragma once

#include "core/nc/macro/formula_language.h"

namespace proveout::nc {

const FormulaLanguage& nctFormulas();

}  // namespace proveout::nc
