// What the row of a lathe hands to the shared code (IsoDialect).
#pragma once

#include <memory>

#include "core/nc/iso/model/dialect.h"
#include "core/nc/iso/model/plan.h"

namespace proveout::nc {

/// Offsets of the settings go into the tables.
std::unique_ptr<MakerData> makeLatheData(IsoContext& c);
/// Words of H are steps of C; numbers as takeFanucWords() reads them.
bool takeLatheWords(IsoContext& c);
/// planFanuc(), and what lathes refuse or tell besides: D belongs to cycles, U and W to system A.
bool planLatheBlock(IsoContext& c, BlockPlan& plan);
/// fanucBegin(), and the codes of live tools.
void latheBegin(IsoContext& c);
/// X in diameter, plane ZX, feed per turn.
void latheAtPowerOn(const IsoContext& c, IsoState& state);
/// T ttoo: tool tt, offset oo (section 15).
bool planLatheTool(IsoContext& c, BlockPlan& plan, const Word& t);
/// The contour of G70 is cut: the tool goes back to where it began.
bool endLatheLines(IsoContext& c);

}  // namespace proveout::nc
