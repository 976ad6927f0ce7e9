#include "core/nc/linuxcnc/text/lcn_unused.h"

namespace proveout::nc {

std::string_view lcnUnusedWord(Address letter) {
  switch (letter) {
    case 'D':
      return "D word with no G41, G41.1, G42, G42.1, G71, G71.1, G71.2 or G96 to use it";
    case 'E':
      return "E word with no G70, G76, M66, M67 or M68 to use it";
    case 'H':
      return "H word with no G43 or G76 to use it";
    case 'I':
      return "I word with no G2, G3, G5, G5.1, G10, G33.1, G76, or G87 to use it";
    case 'J':
      return "J word with no G2, G3, G5, G5.1, G10, G76 or G87 to use it";
    case 'K':
      return "K word with no G2, G3, G33, G33.1, G76, or G87 to use it";
    case 'L':
      return "L word with no G10, cutter compensation, canned cycle, digital/analog input, M98 or NURBS code";
    case 'P':
      return "P word with no G2 G3 G4 G10 G64 G5 G5.2 G76 G82 G86 G88 G89 or M50 M51 M52 M53 M62 M63 M64 M65 "
             "M66 M98 or user M code to use it";
    case 'Q':
      return "Q word with no G5, G10, G64, G73, G76, G83, M19, M66, M67, M68 or user M code that uses it";
    case 'R':
      return "R word with no g code that uses it";
    case kSpindleNumber:
      return "$ (spindle selection) word with no M3, M4, M5, M19, M51, G33, G33.1, G76, G95, G96 or G97 to "
             "use "
             "it";
    default:
      return "Cannot use axis values without a g code that uses them";
  }
}

}  // namespace proveout::nc
