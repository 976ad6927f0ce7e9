// The chapters of the code table. Each has a file of its own; tables/codes.cpp lists them.
#pragma once

#include "core/nc/nct/model/codes.h"

namespace proveout::nc {

CodeTable motionTable();
CodeTable framesTable();
CodeTable compTable();
CodeTable cyclesTable();
CodeTable transformsTable();
CodeTable spindleTable();
CodeTable toolsTable();
CodeTable measuringTable();
CodeTable macroTable();
CodeTable dataTable();
CodeTable rotaryTable();
CodeTable turningTable();
CodeTable programTable();

}  // namespace proveout::nc
