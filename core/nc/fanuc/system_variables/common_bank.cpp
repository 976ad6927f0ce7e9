#include "core/nc/fanuc/system_variables/common_bank.h"

namespace proveout::nc {
namespace {

constexpr int kSettings = 3005;

}  // namespace

void CommonBank::addTo(VariableStore& store) {
  constexpr int kSmallFirst = 98000, kSmallLast = 98499, kLargeFirst = 900000, kLargeLast = 999999;
  store.addBank(kSmallFirst, kSmallLast, *this);
  store.addBank(kLargeFirst, kLargeLast, *this);
  store.addBank(kSettings, kSettings, *this);
}

VariableStatus CommonBank::read(int number, Value& out) {
  const auto found = values_.find(number);
  out = found != values_.end() ? found->second : number == kSettings ? Value{0.0} : Value::none();
  return VariableStatus::kDone;
}

void CommonBank::addTo(std::map<int, double>& kept) const {
  for (const auto& [number, value] : values_) {
    if (!value.vacant) kept[number] = value.number;
  }
}

VariableStatus CommonBank::write(int number, const Value& value) {
  values_[number] = value;
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
