#include "core/nc/iso/system_variables/plc_bank.h"

#include <cmath>

namespace proveout::nc {
namespace {

constexpr int kInputs = 1000, kOutputs = 1100;
constexpr int kBits = 32, kWord = 32, kNumbers = 3;  // offsets: bits, all bits as one number, numbers

}  // namespace

bool bitValue(const Value& value, bool& bit) {
  const double number = value.vacant ? 0.0 : value.number;
  if (!(number >= 0.0 && number <= 1.0)) return false;
  bit = number > 0.0;
  return true;
}

PlcBank::PlcBank(const Operator& person) {
  for (unsigned k = 0; k < kBits; ++k) in_.bits |= person.plc_bits[k] ? 1u << k : 0u;
  in_.numbers = person.plc_numbers;
}

void PlcBank::addTo(VariableStore& store) {
  store.addBank(kInputs, kInputs + kWord + kNumbers, *this);
  store.addBank(kOutputs, kOutputs + kWord + kNumbers, *this);
  store.addSymbol({"UI", kInputs, 0, kBits});
  store.addSymbol({"UIL", kInputs + kWord, 0, kNumbers + 1});
  store.addSymbol({"UO", kOutputs, 0, kBits});
  store.addSymbol({"UOL", kOutputs + kWord, 0, kNumbers + 1});
}

VariableStatus PlcBank::read(int number, Value& out) {
  const Port& port = number < kOutputs ? in_ : out_;
  const int index = number - (number < kOutputs ? kInputs : kOutputs);
  if (index < kBits) {
    out = {static_cast<double>(port.bits >> static_cast<unsigned>(index) & 1u)};
  } else if (index == kWord) {
    out = {static_cast<double>(port.bits)};
  } else {
    out = {port.numbers[static_cast<std::size_t>(index - kWord - 1)]};
  }
  return VariableStatus::kDone;
}

VariableStatus PlcBank::write(int number, const Value& value) {
  if (number < kOutputs) return VariableStatus::kReadOnly;
  const int index = number - kOutputs;
  const double amount = value.vacant ? 0.0 : value.number;
  if (index < kBits) {
    bool bit = false;
    if (!bitValue(value, bit)) return VariableStatus::kLimit;
    const std::uint32_t mask = 1u << static_cast<unsigned>(index);
    out_.bits = bit ? out_.bits | mask : out_.bits & ~mask;
  } else if (index == kWord) {
    constexpr double kModulus = 4294967296.0;
    const double whole = std::round(amount);
    if (!(std::abs(whole) < kModulus)) return VariableStatus::kLimit;
    out_.bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));  // negative ones modulo 2^32
  } else {
    out_.numbers[static_cast<std::size_t>(index - kWord - 1)] = amount;
  }
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
