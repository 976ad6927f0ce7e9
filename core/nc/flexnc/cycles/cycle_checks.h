// Checks of letters that cycles of the FlexNC control share.
#pragma once

#include <optional>
#include <string>

#include "core/nc/flexnc/cycles/cycle_call.h"

namespace proveout::nc {

/// All of `required` are there, and nothing besides them and `optional`; all are numbers of a machine.
std::optional<CycleNote> checkLetters(CycleCode code, const CycleArguments& arguments, AddressSet required,
                                      AddressSet optional);
/// Each letter of `above` is above 0, each of `not_below` not below it, where it is there.
std::optional<CycleNote> checkSigns(CycleCode code, const CycleArguments& arguments, AddressSet above,
                                    AddressSet not_below);
/// Is it a number of passes that a program can mean? `what`: the letters that make it.
std::optional<CycleNote> checkPasses(CycleCode code, double passes, const char* what);

/// The first that is there; all later checks may rely on the earlier ones.
template <typename... Checks>
std::optional<CycleNote> firstNote(Checks&&... checks) {
  std::optional<CycleNote> note;
  static_cast<void>(((note = checks()).has_value() || ...));
  return note;
}

/// How many steps of `step` cover `way`: rounding makes no step of its own. Not above 0: none.
double stepsOver(double way, double step);

}  // namespace proveout::nc
