// What GRBL 1.1 refuses, by its own numbers of errors and in its own order.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {

/// An error of GRBL in the text of a line; number 0: there is none.
struct GrblFault {
  int number = 0;
  std::size_t begin = 0, end = 0;  ///< of the word, indices into the text
};
/// The words of a line without blanks and comments, in small letters, from left to right: letters, numbers,
/// codes, groups, repeats. `axes`: letters of axes beside X, Y, Z. Takes M6 too, which GRBL has not: posts
/// write it.
GrblFault grblLineFault(std::string_view text, std::string_view axes);
/// Has GRBL 1.1 that G code, tenfold, or that M code? M6 counts.
bool grblHasG(int code10);
bool grblHasM(int code);
/// What an error says.
std::string_view grblMeaning(int number);

/// The words of the block in hand together, with the state that they meet. False: reported.
bool grblTakesBlock(IsoContext& c, const BlockPlan& plan);
/// Whether the codes of the block use all of its words: GRBL looks for that at last. False: reported.
bool grblUsesWords(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
