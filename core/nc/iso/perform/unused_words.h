// Words that a block gives and nothing reads.
#pragma once

#include <string_view>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Warns that a word of the block does nothing with that code; once for each place in the programs.
void tellUnused(IsoContext& c, const Word& word, std::string_view code, std::string_view why);
/// Warns of the words that no code of the block has asked for (IsoContext::asked). `read`: addresses that
/// every block reads. Behind the plan of the block.
void tellUnusedWords(IsoContext& c, const BlockPlan& plan, AddressSet read);

}  // namespace proveout::nc
