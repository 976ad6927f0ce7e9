// The chapters of the code tables of Fanuc-like controls; dialect.cpp puts them together.
#pragma once

#include <cstdint>
#include <span>

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
CodeTable haasLatheTable();  ///< what Haas lathes have beside them
CodeTable fanucLatheSystemTable(GCodeSystem system);
std::span<const std::int32_t> notInSystem(GCodeSystem system);
// Mills.
CodeTable fanucCyclesTable();
/// Mills of Haas: instead of rows of the others, or beside them.
CodeTable haasMillTable();

}  // namespace proveout::nc
