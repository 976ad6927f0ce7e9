// The formulas of custom macro B.
#pragma once

#include "core/nc/macro/formula_language.h"

namespace proveout::nc {

const FormulaLanguage& fanucFormulas();

}  // namespace proveout::nc
