// The lists of the manuals' rows as text: lines of chapter, class and names, in the manuals' order.
#pragma once

namespace proveout::specification_text {

extern const char* const kNct;
extern const char* const kWl4;
extern const char* const kFlexnc;
extern const char* const kWedm;

}  // namespace proveout::specification_text
