#include "core/nc/flexnc/cycles/cycle_checks.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout::nc {

namespace {

constexpr double kLargestValue = 1e6;    ///< mm or degrees
constexpr double kMostPasses = 20000.0;  ///< of a block; 0.01 mm over 200 mm

CycleNote signNote(CycleCode code, char letter, double value, const char* rule) {
  return {"fnc-param-sign", fmt::format("{}: {}{:g} {}", cycleName(code), addressText(letter), value, rule)};
}

}  // namespace

std::optional<CycleNote> checkLetters(CycleCode code, const CycleArguments& arguments, AddressSet required,
                                      AddressSet optional) {
  const std::string name = cycleName(code);
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const bool there = arguments.has(letter);
    if (!there && required.has(letter)) {
      return CycleNote{"fnc-param-missing",
                       fmt::format("{} needs {}: it is missing", name, addressText(letter))};
    }
    if (there && !required.has(letter) && !optional.has(letter)) {
      return CycleNote{"fnc-param-extra",
                       fmt::format("{} has no {} in this form: leave it out", name, addressText(letter))};
    }
    if (there && !(std::abs(arguments.value(letter)) <= kLargestValue)) {
      return CycleNote{"fnc-num", fmt::format("{}: {} is too large", name, addressText(letter))};
    }
  }
  return std::nullopt;
}

std::optional<CycleNote> checkSigns(CycleCode code, const CycleArguments& arguments, AddressSet above,
                                    AddressSet not_below) {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const std::optional<double> value = arguments.find(letter);
    if (!value) continue;
    if (above.has(letter) && !(*value > 0.0)) return signNote(code, letter, *value, "has to be above 0");
    if (not_below.has(letter) && !(*value >= 0.0)) {
      return signNote(code, letter, *value, "must not be below 0");
    }
  }
  return std::nullopt;
}

std::optional<CycleNote> checkPasses(CycleCode code, double passes, const char* what) {
  if (passes <= kMostPasses) return std::nullopt;
  return CycleNote{"fnc-passes",
                   fmt::format("{}: {} would make {:.0f} passes, at most {:.0f} are cut: larger",
                               cycleName(code), what, passes, kMostPasses)};
}

double stepsOver(double way, double step) { return std::max(std::ceil(way / step - 1e-9), 0.0); }

}  // namespace proveout::nc
