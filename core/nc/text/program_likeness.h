// Whether a text can be an NC program at all, of whatever control.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/nc/text/source_text.h"

namespace proveout::nc {

/// Whose language the text is in where no control here has it: "a dialogue program of Heidenhain (...)";
/// empty: of none that is known.
std::string foreignLanguage(const std::vector<std::string_view>& lines);

/// False where the text is obviously none, or in the language of other controls: not one of its lines, or
/// hardly one, could be a block of any control (words of letters and numbers, a statement of a macro
/// language), or it is full of control characters. A text without any line but comments and blanks may be a
/// program. Asked only where something is wrong with the text, so that what it takes for none is told
/// otherwise, and nothing else.
bool mayBeProgram(const std::vector<std::string_view>& lines);

/// The same of a text in hand; those of the control itself are programs.
inline bool mayBeProgram(const SourceText& text) { return text.builtIn() || mayBeProgram(text.lines()); }

}  // namespace proveout::nc
