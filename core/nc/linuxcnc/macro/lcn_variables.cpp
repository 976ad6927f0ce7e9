#include "core/nc/linuxcnc/macro/lcn_variables.h"

#include <bit>
#include <functional>
#include <utility>

#include "core/nc/origins/intern_table.h"

namespace proveout::nc {

std::uint64_t LcnVariables::hashOf(std::uint64_t place, const Value& value) {
  return mixBits(place ^ mixBits(std::bit_cast<std::uint64_t>(value.number)));
}

void LcnVariables::put(int number, const Value& value) {
  Value& place = values_[static_cast<std::size_t>(number)];
  const auto at = static_cast<std::uint64_t>(number);
  if (place.number != value.number) fingerprint_ += hashOf(at, value) - hashOf(at, place);
  place = value;
}

const Value* LcnVariables::named(std::string_view name) const {
  const Names& names = name.starts_with('_') ? globals_ : locals_;
  const auto found = names.find(name);
  return found == names.end() ? nullptr : &found->second;
}

void LcnVariables::putNamed(std::string_view name, const Value& value) {
  Names& names = namesOf(name);
  auto found = names.find(name);
  const std::uint64_t at = std::hash<std::string_view>{}(name) | 0x10000u;
  std::uint64_t change = hashOf(at, value);
  if (found == names.end()) {
    found = names.emplace(std::string(name), value).first;
  } else {
    change -= hashOf(at, found->second);
    found->second = value;
  }
  fingerprint_ += change;
  if (&names == &locals_) locals_print_ += change;
}

void LcnVariables::enter(const std::vector<Value>& arguments) {
  Level level;
  for (int n = 1; n <= kLocals; ++n) {
    const auto k = static_cast<std::size_t>(n);
    level.saved[k] = values_[k];
    put(n, k <= arguments.size() ? arguments[k - 1] : Value());
  }
  level.saved_names = std::exchange(locals_, Names());
  fingerprint_ -= locals_print_;
  level.names_print = std::exchange(locals_print_, 0);
  levels_.push_back(std::move(level));
}

void LcnVariables::leave() {
  if (levels_.empty()) return;
  Level& level = levels_.back();
  for (int n = 1; n <= kLocals; ++n) put(n, level.saved[static_cast<std::size_t>(n)]);
  locals_ = std::move(level.saved_names);
  fingerprint_ += level.names_print - locals_print_;
  locals_print_ = level.names_print;
  levels_.pop_back();
}

}  // namespace proveout::nc
