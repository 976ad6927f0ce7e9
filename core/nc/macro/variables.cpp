#include "core/nc/macro/variables.h"

#include <algorithm>

namespace proveout::nc {
namespace {

constexpr int kEmptyConstant = 3100;  ///< #3100, #_EMPTY: vacant as #0 is

}  // namespace

VariableStore::VariableStore() {
  locals_.fill(Value::none());
  globals_.fill(Value::none());
}

bool VariableStore::enter(const Arguments& arguments) {
  if (level_ + 1 >= kLevels) return false;
  ++level_;
  std::copy(arguments.v.begin(), arguments.v.end(), locals_.begin() + static_cast<std::ptrdiff_t>(local(0)));
  return true;
}

void VariableStore::leave() {
  if (level_ > 0) --level_;
}

void VariableStore::clearLocals() {
  level_ = 0;
  std::fill_n(locals_.begin(), kLocalCount + 1, Value::none());
}

void VariableStore::clearGlobals() {
  std::fill_n(globals_.begin(), kFirstKept - kFirstGlobal, Value::none());
}

void VariableStore::protect(int first, int last) {
  protect_first_ = first;
  protect_last_ = last;
}

void VariableStore::addBank(int first, int last, VariableBank& bank) {
  const auto behind = std::upper_bound(banks_.begin(), banks_.end(), first,
                                       [](int number, const Range& range) { return number < range.first; });
  banks_.insert(behind, {first, last, &bank});
}

VariableBank* VariableStore::bankOf(int number) const {
  const auto behind = std::upper_bound(banks_.begin(), banks_.end(), number,
                                       [](int wanted, const Range& range) { return wanted < range.first; });
  if (behind == banks_.begin()) return nullptr;
  const Range& range = *(behind - 1);
  return number <= range.last ? range.bank : nullptr;
}

VariableStatus VariableStore::readOther(int number, Value& out) {
  if (number == 0 || number == kEmptyConstant) {
    out = Value::none();
    return kVariableRead;
  }
  VariableBank* bank = bankOf(number);
  return bank == nullptr ? kUnknownVariable : bank->read(number, out);
}

VariableStatus VariableStore::writeOther(int number, const Value& value) {
  if (number == 0 || number == kEmptyConstant) return kReadOnlyVariable;
  if (number >= kFirstGlobal && number <= kLastGlobal) {
    const bool locked = number >= kFirstKept && number >= protect_first_ && number <= protect_last_;
    if (locked) return kReadOnlyVariable;
    globals_[static_cast<std::size_t>(number - kFirstGlobal)] = value;
    return kVariableRead;
  }
  VariableBank* bank = bankOf(number);
  return bank == nullptr ? kUnknownVariable : bank->write(number, value);
}

}  // namespace proveout::nc
