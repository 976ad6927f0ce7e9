// The nct control as tables of the ISO family.
#pragma once

#include "core/nc/iso/model/dialect.h"

namespace proveout::nc {

/// The control's codes; made once.
const CodeIndex& nctCodes();
const IsoDialect& nctDialect();

}  // namespace proveout::nc
