// The chapters of the code tables of Fanuc-like controls; dialect.cpp puts them together.
#pragma once

#include "core/nc/iso/model/codes.h"

namespace proveout::nc {

// Mills and lathes.
CodeTable fanucMotionTable();
CodeTable fanucFramesTable();
CodeTable fanucCompTable();
CodeTable fanucTransformsTable();
CodeTable fanucMacroTable();
// Mills.
CodeTable fanucCyclesTable();
/// Mills of Haas: instead of rows of the others, or beside them.
CodeTable haasMillTable();

}  // namespace proveout::nc
