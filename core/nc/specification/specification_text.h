// The lists of the manuals' rows as text: lines of chapter, class and names, in the manuals' order.
#pragma once

namespace proveout::specification_text {

extern const char* const kNct;
extern const char* const kWl4;
extern const char* const kFlexnc;
extern const char* const kWedm;
extern const char* const kFanuc;  ///< rows of haas too
extern const char* const kLinuxCnc;

}  // namespace proveout::specification_text
