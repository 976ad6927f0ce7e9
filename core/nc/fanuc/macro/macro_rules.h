// Calls of subprograms and macros, arguments, ROUND (sections 11 and 12 of the rows).
#pragma once

#include <array>
#include <map>
#include <string>

#include "core/nc/iso/model/dialect.h"

namespace proveout::nc {

/// M98 and M198 with P, L, Q or <NAME>; see IsoDialect::subprogram.
bool fanucSubprogram(IsoContext& c, int code, SubprogramCall& call);

/// Arguments I and II: of two words of one variable the later one holds; see IsoDialect::arguments. Alarm
/// 129.
bool fanucArguments(IsoContext& c, const ArgumentRules& rules, Arguments& out);

/// Least increments of a unit: 1000 of lengths and angles (inch 10000), 1 of numbers.
double fanucStepsPerUnit(const IsoContext& c, Address address);

/// T, S and B that call O9000, O9029 and O9028 with their value in #149, #147 and #146.
inline constexpr std::array<SystemLetter, 3> kFanucLetters{
    {{'T', paramBehind(MacroParam::kLetterA, 4), 9000, 149},
     {'S', paramBehind(MacroParam::kLetterA, 3), 9029, 147},
     {'B', paramBehind(MacroParam::kLetterA, 1), 9028, 146}}};

/// Sets what calls, the macro language and system variables of a dialect follow.
void takeMacroRules(IsoDialect& dialect, bool lathe);

/// The dialect as the settings of the job have its macro language: `atan_range`. It lives as long
/// as the process, and so must `base`.
const IsoDialect& macroVariant(const IsoDialect& base, const std::map<std::string, double>& settings);

}  // namespace proveout::nc
