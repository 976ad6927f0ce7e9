// What the plan functions of lathes do with words.
#pragma once

#include <optional>
#include <string_view>

#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Whether the word has a decimal point, or was computed.
bool pointed(const IsoContext& c, const Word& w);
/// A word of G71 to G73 or of a taper, mm as written; 0: it is not there. X words are diameters elsewhere.
double lengthWord(IsoContext& c, const BlockPlan& plan, Address a);
/// P and Q of G74 to G76: thousandths of a mm (ten-thousandths of an inch); with a point units, and a note.
double stepWord(IsoContext& c, const BlockPlan& plan, const Word& w);
/// D of the one-line forms: units; without a point from 100 on, or with `decimal` = "increment", thousandths.
double depthWord(IsoContext& c, const BlockPlan& plan, const Word& w);
/// Whether the word counts in least increments (`decimal`).
bool countsIncrements(const IsoContext& c, const Word& w);
/// Whether the plane is that of turning, Z and X. False: reported.
bool turningPlane(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
