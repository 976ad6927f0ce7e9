#include "core/nc/wl4/wl4_variables.h"

namespace proveout::nc {

std::optional<double> Wl4Variables::read(int number) const {
  if (number < 1) return std::nullopt;
  if (number > kGlobals) return system_.systemVariable(number);
  const auto n = static_cast<std::size_t>(number);
  return number <= kLocals ? levels_.back()[n].value : globals_[n].value;
}

std::uint32_t Wl4Variables::originOf(int number) const {
  if (number < 1) return 0;
  if (number > kGlobals) return system_.systemOrigin(number);
  const auto n = static_cast<std::size_t>(number);
  return number <= kLocals ? levels_.back()[n].origin : globals_[n].origin;
}

bool Wl4Variables::write(int number, double value, std::uint32_t origin) {
  if (number < 1 || number > kGlobals) return false;
  Held& place = at(number);
  undo_.push_back({number, place});
  place = {value, origin};
  return true;
}

void Wl4Variables::takeBack() {
  for (; !undo_.empty(); undo_.pop_back()) at(undo_.back().number) = undo_.back().held;
}

}  // namespace proveout::nc
