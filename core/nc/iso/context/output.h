// Files that programs write: POPEN PCLOS FOPEN FCLOS BPRNT DPRNT (manual 23.2.13).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace proveout::nc {

struct IsoContext;

/// Carries out the output statement of the block in hand. False: an error was reported.
bool outputStatement(IsoContext& c);
/// The program ends: an open file is closed, with a warning. False: an error was reported.
bool endOutput(IsoContext& c);

/// `#n[cd]` from text[i] on, appended to `out` as DPRNT writes it; `i` moves behind it. False: an error was
/// reported.
bool printedVariable(IsoContext& c, std::string_view text, std::size_t& i, std::string& out);
/// A number with `decimals` digits behind the point. Without `compact` the sign has a column of its own and
/// what `digits` leaves is filled with spaces; values that need more digits get them.
std::string decimalText(double value, int digits, int decimals, bool compact);
/// Four bytes of value * 10^decimals, most significant first, negative ones in two's complement. False: the
/// value is too large.
bool binaryBytes(double value, int decimals, std::string& out);

/// The name of a file that a program may write: relative to the folder of the results, '/' between folders.
/// Empty: it leads elsewhere or holds what no file name may.
std::string outputName(std::string_view written);

}  // namespace proveout::nc
