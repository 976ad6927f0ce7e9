#include "core/nc/macro/variables.h"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/base/assert.h"
#include "core/base/characters.h"

namespace proveout::nc {
namespace {

constexpr int kEmptyConstant = 3100;  ///< #3100, #_EMPTY: vacant as #0 is
constexpr int kPiConstant = 3101, kEulerConstant = 3102;

constexpr bool isConstant(int number) {
  return number == 0 || (number >= kEmptyConstant && number <= kEulerConstant);
}

constexpr bool isNameCharacter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

VariableStore::VariableStore() {
  locals_.fill(Value::none());
  globals_.fill(Value::none());
  addSymbol({"EMPTY", kEmptyConstant});
  addSymbol({"PI", kPiConstant});
  addSymbol({"E", kEulerConstant});
}

bool VariableStore::enter(const Arguments& arguments) {
  if (level_ + 1 >= kLevels) return false;
  ++level_;
  for (int k = 0; k <= kLocalCount; ++k) put(locals_[local(k)], arguments.v[static_cast<std::size_t>(k)]);
  return true;
}

void VariableStore::leave() {
  if (level_ > 0) --level_;
}

void VariableStore::share(VariableStore& owner, int low, int kept) {
  PROVEOUT_ASSERT(&owner != this && owner.common_ == nullptr);
  common_ = owner.globals_.data();
  common_low_end_ = kFirstGlobal + low;
  common_kept_end_ = kFirstKept + kept;
}

void VariableStore::protect(int first, int last) {
  protect_first_ = first;
  protect_last_ = last;
}

void VariableStore::addBank(int first, int last, VariableBank& bank) {
  const auto behind = std::upper_bound(banks_.begin(), banks_.end(), first,
                                       [](int number, const Range& range) { return number < range.first; });
  PROVEOUT_ASSERT(first <= last && (behind == banks_.end() || last < behind->first));
  PROVEOUT_ASSERT(behind == banks_.begin() || std::prev(behind)->last < first);
  banks_.insert(behind, {first, last, &bank});
}

void VariableStore::addSymbol(VariableSymbol symbol) {
  const auto at =
      std::lower_bound(symbols_.begin(), symbols_.end(), symbol.name,
                       [](const VariableSymbol& s, const std::string& name) { return s.name < name; });
  PROVEOUT_ASSERT(at == symbols_.end() || at->name != symbol.name);
  symbols_.insert(at, std::move(symbol));
}

const VariableSymbol* VariableStore::symbolAt(std::string_view text, std::size_t& length) const {
  constexpr std::size_t kLongest = 24;
  std::array<char, kLongest> upper;
  std::size_t n = 0;
  for (; n < std::min(text.size(), kLongest); ++n) {
    const char c = text[n] >= 'a' && text[n] <= 'z' ? static_cast<char>(text[n] - 32) : text[n];
    if (!isNameCharacter(c)) break;
    upper[n] = c;
  }
  for (; n > 0; --n) {  // a keyword may follow without a blank
    const std::string_view name(upper.data(), n);
    const auto at =
        std::lower_bound(symbols_.begin(), symbols_.end(), name,
                         [](const VariableSymbol& s, std::string_view wanted) { return s.name < wanted; });
    if (at == symbols_.end() || at->name != name) continue;
    length = n;
    return &*at;
  }
  return nullptr;
}

std::string VariableStore::upperCase(std::string_view name) {
  std::string out(name);
  for (char& c : out) c = upper(c);
  return out;
}

VariableBank* VariableStore::bankOf(int number) const {
  const auto behind = std::upper_bound(banks_.begin(), banks_.end(), number,
                                       [](int wanted, const Range& range) { return wanted < range.first; });
  if (behind == banks_.begin()) return fallback_;
  const Range& range = *(behind - 1);
  return number <= range.last ? range.bank : fallback_;
}

VariableStatus VariableStore::readOther(int number, Value& out) {
  if (isConstant(number)) {
    out = number == kPiConstant      ? Value{std::numbers::pi}
          : number == kEulerConstant ? Value{std::numbers::e}
                                     : Value::none();
    return VariableStatus::kDone;
  }
  VariableBank* bank = bankOf(number);
  ++bank_accesses_;
  const VariableStatus status = bank == nullptr ? VariableStatus::kUnknown : bank->read(number, out);
  if (status != VariableStatus::kUnknown || fallback_ == nullptr || bank == fallback_) return status;
  return fallback_->read(number, out);
}

VariableStatus VariableStore::writeOther(int number, const Value& value) {
  if (isConstant(number)) return VariableStatus::kReadOnly;
  if (isGlobal(number)) {
    const bool locked = number >= kFirstKept && number >= protect_first_ && number <= protect_last_;
    if (locked) return VariableStatus::kReadOnly;
    put(global(number), value);
    return VariableStatus::kDone;
  }
  VariableBank* bank = bankOf(number);
  ++bank_accesses_;
  const VariableStatus status = bank == nullptr ? VariableStatus::kUnknown : bank->write(number, value);
  if (status != VariableStatus::kUnknown || fallback_ == nullptr || bank == fallback_) return status;
  return fallback_->write(number, value);
}

}  // namespace proveout::nc
