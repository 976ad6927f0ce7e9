// What a report comes to in one word.
#pragma once

#include <cstdint>
#include <string_view>

namespace proveout {

struct Report;

enum class Verdict : std::uint8_t { kPass, kFail, kError };
std::string_view verdictName(Verdict verdict);  ///< "pass", "fail", "error"

/// kError if the program raised an alarm (a finding of kind kAlarm or an error among the diagnostics), kFail
/// if a finding that is not known has severity error or the comparison is undecided, else kPass.
Verdict verdictOf(const Report& report);

}  // namespace proveout
