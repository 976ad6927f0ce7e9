// What the interpreter says of words that no code of their line uses.
#pragma once

#include <string_view>

#include "core/nc/text/block.h"

namespace proveout::nc {

/// "E word with no G70, G76, M66, M67 or M68 to use it".
std::string_view lcnUnusedWord(Address letter);

}  // namespace proveout::nc
