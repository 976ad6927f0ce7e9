// The chapters of the code table of LinuxCNC; dialect.cpp puts them together.
#pragma once

#include "core/nc/iso/model/codes.h"

namespace proveout::nc {

CodeTable linuxCncMotionTable();
CodeTable linuxCncFunctionTable();

}  // namespace proveout::nc
