// The numbers of words as Fanuc-like controls read them (section 2, "Decimal rule per address").
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// IsoDialect::take_words: turns words without a point that count in least increments into units, rounds
/// coordinates to the least increment, half away from zero, and refuses points at integers (007) and values
/// over range (003). Words that belong to a code with a rule of its own are left as they are written: P and Q
/// of turning cycles, I J K P of scaling, knots and weights of G06.2. False: reported.
bool takeFanucWords(IsoContext& c);

/// A word of a macro call as its variable gets it: lengths without a point count as their address does, in
/// units or, with `decimal` "increment", in least increments; nothing is rounded.
double fanucArgument(const IsoContext& c, const Word& w);

}  // namespace proveout::nc
