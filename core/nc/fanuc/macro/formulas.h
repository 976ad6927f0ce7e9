// The formulas of custom macro B.
#pragma once

#include "core/nc/macro/formula_language.h"

namespace proveout::nc {

/// `signed_angles`: arc functions give -180 to 180 degrees (6004#0 NAT 1), else 0 to 360.
const FormulaLanguage& fanucFormulas(bool signed_angles = false);

}  // namespace proveout::nc
