#include "core/nc/wl4/macro/wl4_variables.h"

#include <bit>

#include "core/nc/origins/intern_table.h"

namespace proveout::nc {

std::optional<double> Wl4Variables::read(int number) const {
  if (number < 1) return std::nullopt;
  if (number > kGlobals) {
    ++system_reads_;
    return system_.systemVariable(number);
  }
  const auto n = static_cast<std::size_t>(number);
  return number <= kLocals ? levels_.back()[n].value : globals_[n].value;
}

std::uint32_t Wl4Variables::originOf(int number) const {
  if (number < 1) return 0;
  if (number > kGlobals) return system_.systemOrigin(number);
  const auto n = static_cast<std::size_t>(number);
  return number <= kLocals ? levels_.back()[n].origin : globals_[n].origin;
}

void Wl4Variables::put(int number, const Held& held) {
  const auto hash = [&](double value) {
    return mixBits(static_cast<std::uint64_t>(number) ^ mixBits(std::bit_cast<std::uint64_t>(value)));
  };
  Held& place = at(number);
  (number <= kLocals ? levels_values_.back() : globals_values_) += hash(held.value) - hash(place.value);
  place = held;
}

bool Wl4Variables::write(int number, double value, std::uint32_t origin) {
  if (number < 1 || number > kGlobals) return false;
  undo_.push_back({number, at(number)});
  put(number, {value, origin});
  return true;
}

void Wl4Variables::takeBack() {
  for (; !undo_.empty(); undo_.pop_back()) put(undo_.back().number, undo_.back().held);
}

}  // namespace proveout::nc
