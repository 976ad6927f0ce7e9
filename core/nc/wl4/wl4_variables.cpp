#include "core/nc/wl4/wl4_variables.h"

namespace proveout::nc {

std::optional<double> Wl4Variables::read(int number) const {
  if (number < 1) return std::nullopt;
  if (number > kGlobals) return system_.systemVariable(number);
  const auto n = static_cast<std::size_t>(number);
  return number <= kLocals ? levels_.back()[n] : globals_[n];
}

bool Wl4Variables::write(int number, double value) {
  if (number < 1 || number > kGlobals) return false;
  double& place = at(number);
  undo_.push_back({number, place});
  place = value;
  return true;
}

void Wl4Variables::takeBack() {
  for (; !undo_.empty(); undo_.pop_back()) at(undo_.back().number) = undo_.back().value;
}

}  // namespace proveout::nc
