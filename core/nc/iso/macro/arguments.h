// Words of a block as arguments of a macro (manual 23.3).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// How the words of a call become arguments.
struct ArgumentRules {
  const Word* call = nullptr;  ///< the word that calls and is no argument itself; may be null
  /// Words of the call itself: their values are stored, but an I, J or K may take their variable.
  AddressSet weak;
  bool of_block = false;  ///< G66.1: all words of the block are arguments
};

/// Fills the arguments from the block in hand. False: alarm 2017, reported.
bool collectArguments(IsoContext& c, const ArgumentRules& rules, Arguments& out);

}  // namespace proveout::nc
