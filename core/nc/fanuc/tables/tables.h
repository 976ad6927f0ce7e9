// The chapters of the code tables of Fanuc-like controls; dialect.cpp puts them together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/nc/iso/model/codes.h"

namespace proveout::nc {

// Mills and lathes.
CodeTable fanucTextTable();
CodeTable fanucMotionTable();
CodeTable fanucFramesTable();
CodeTable fanucCompTable();
CodeTable fanucRotaryTable();
CodeTable fanucTransformsTable();
CodeTable fanucMacroTable();
// Lathes: the rows of all systems of G codes, those of one, and numbers of mills that it does not have.
enum class GCodeSystem : std::uint8_t { kA, kB, kC };
CodeTable fanucLatheTable();
std::vector<CodeTable> fanucLatheSystemTables(GCodeSystem system);
std::span<const std::int32_t> notInSystem(GCodeSystem system);
// Mills.
CodeTable fanucCyclesTable();
// Haas, instead of rows of the others or beside them: mills and lathes, G110 to G129 of both, one of them.
CodeTable haasTable();
CodeTable haasFramesTable();
CodeTable haasMillTable();
CodeTable haasLatheTable();

}  // namespace proveout::nc
