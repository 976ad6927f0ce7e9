// The chapters of the code table. Each has a file of its own; dialect.cpp lists them.
#pragma once

#include "core/nc/iso/model/codes.h"

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
CodeTable axesTable();
CodeTable turningTable();
CodeTable programTable();

}  // namespace proveout::nc
