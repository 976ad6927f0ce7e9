// The variables of a channel: locals by level, globals, and banks for the system variables.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/macro/value.h"
#include "core/nc/origins/intern_table.h"

namespace proveout::nc {

/// Arguments of a macro call: v[n] is what #n starts with. v[0] is not used.
struct Arguments {
  std::array<Value, kLocalCount + 1> v;
  Arguments() { v.fill(Value::none()); }
};

/// How an access went.
enum class VariableStatus : std::uint8_t {
  kDone,
  kUnknown,   ///< the control has no variable of that number
  kReadOnly,  ///< it may not be written
  kLimit,     ///< it does not take such a value
  kReported   ///< it failed, and the error was reported already
};

/// A range of system variables. Numbers handed in lie in the range that the bank was added with.
class VariableBank {
 public:
  virtual ~VariableBank() = default;
  virtual VariableStatus read(int number, Value& out) = 0;
  virtual VariableStatus write(int number, const Value& value) = 0;
  /// Does the variable take a text behind the value, or instead of one?
  virtual bool takesText(int /*number*/) const { return false; }
};

/// A name of system variables: `#_NAME`, or `#_NAME[index]` where count > 0.
struct VariableSymbol {
  std::string name;     ///< upper case, without "#_"
  int number = 0;       ///< of the first variable
  int first_index = 0;  ///< the index that means it
  int count = 0;        ///< variables; 0: the name takes no index
};

/// #0 is vacant for ever. #1-#33: locals of the level in force, 0 (main) to 16. #100-#499 and #500-#999:
/// globals. #3100 to #3102 are constants. Everything else is asked of the banks. Vacant until written.
class VariableStore {
 public:
  static constexpr int kLevels = 17;  ///< level 0 and one for each nested macro call
  static constexpr int kFirstGlobal = 100, kFirstKept = 500, kLastGlobal = 999;

  VariableStore();

  VariableStatus read(int number, Value& out) {
    if (number >= 1 && number <= kLocalCount) {
      out = locals_[local(number)];
      return VariableStatus::kDone;
    }
    if (isGlobal(number)) {
      out = global(number);
      return VariableStatus::kDone;
    }
    return readOther(number, out);
  }
  VariableStatus write(int number, const Value& value) {
    if (number >= 1 && number <= kLocalCount) {
      put(locals_[local(number)], value);
      return VariableStatus::kDone;
    }
    return writeOther(number, value);
  }
  /// The same while all variables have the same values and no bank is asked: what a bank tells may change by
  /// itself.
  std::uint64_t fingerprint() const { return values_ + bank_accesses_ * 0x9E3779B97F4A7C15u; }

  /// The value of a local or global variable; false: it is another one. For messages.
  bool peek(int number, Value& out) const {
    const bool is_local = number >= 1 && number <= kLocalCount;
    if (!is_local && !isGlobal(number)) return false;
    out = is_local ? locals_[local(number)] : global(number);
    return true;
  }

  /// Opens a level of locals with the arguments. False: no level is left; nothing changes.
  bool enter(const Arguments& arguments);
  /// Closes the level; the caller's locals are in force again. Level 0 stays.
  void leave();
  int level() const { return level_; }

  /// #100 to #(99 + low) and #500 to #(499 + kept) are those of `owner` from here on (N1700, N1701: variables
  /// that all channels share). `owner` must outlive this and share with none itself.
  void share(VariableStore& owner, int low, int kept);

  /// #100 to #last are the globals in front of #500; without this call up to #499.
  void endLowGlobals(int last) { low_end_ = last; }
  /// #first to #last, within 500-999, refuse to be written (N1702, N1703); first > last: none.
  void protect(int first, int last);
  /// Hands the numbers first..last to a bank, which must live as long as the store. Ranges do not overlap.
  void addBank(int first, int last, VariableBank& bank);
  /// Asked for all numbers that no other bank has or knows.
  void setFallback(VariableBank& bank) { fallback_ = &bank; }
  /// The rest of the line behind the assignment in hand, for banks that take a text: #3000=1(TEXT).
  bool takesText(int number) const {
    const VariableBank* bank = bankOf(number);
    return bank != nullptr && bank->takesText(number);
  }
  std::string_view note() const { return note_; }
  void setNote(std::string_view note) { note_ = note; }
  /// Makes a name known. Names are unique.
  void addSymbol(VariableSymbol symbol);
  /// The longest name that `text` starts with, letters of either case; `length` gets its characters. Null:
  /// none.
  const VariableSymbol* symbolAt(std::string_view text, std::size_t& length) const;
  /// A name that the program gives a variable (SETVN), letters of either case; its last name holds.
  void setName(std::string_view name, int number) { names_[upperCase(name)] = number; }
  /// The variable of that name, or -1.
  int named(std::string_view name) const {
    if (names_.empty()) return -1;
    const auto found = names_.find(upperCase(name));
    return found == names_.end() ? -1 : found->second;
  }

 private:
  static std::string upperCase(std::string_view name);
  bool isGlobal(int number) const {
    return number >= kFirstGlobal && number <= kLastGlobal && (number <= low_end_ || number >= kFirstKept);
  }
  void put(Value& place, const Value& value) {
    if (!(place.number == value.number && place.vacant == value.vacant)) {
      const auto at = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(&place));
      values_ += hashOf(at, value) - hashOf(at, place);
    }
    place = value;
  }
  static std::uint64_t hashOf(std::uint64_t place, const Value& value) {
    return mixBits(place ^ mixBits(std::bit_cast<std::uint64_t>(value.number) + (value.vacant ? 1 : 0)));
  }
  std::size_t local(int number) const {
    return static_cast<std::size_t>(level_ * (kLocalCount + 1) + number);
  }
  bool isCommon(int number) const {
    return number < common_low_end_ || (number >= kFirstKept && number < common_kept_end_);
  }
  const Value& global(int number) const {
    return (isCommon(number) ? common_ : globals_.data())[number - kFirstGlobal];
  }
  Value& global(int number) { return (isCommon(number) ? common_ : globals_.data())[number - kFirstGlobal]; }
  VariableStatus readOther(int number, Value& out);
  VariableStatus writeOther(int number, const Value& value);
  VariableBank* bankOf(int number) const;

  struct Range {
    int first, last;
    VariableBank* bank;
  };
  int level_ = 0;
  std::uint64_t values_ = 0, bank_accesses_ = 0;  ///< values_: sum over what is in all places
  int protect_first_ = 1, protect_last_ = 0;
  std::array<Value, static_cast<std::size_t>(kLevels) * (kLocalCount + 1)> locals_;
  std::array<Value, kLastGlobal - kFirstGlobal + 1> globals_;
  std::string_view note_;
  Value* common_ = nullptr;  ///< globals of the owner
  int common_low_end_ = 0, common_kept_end_ = 0;
  int low_end_ = kFirstKept - 1;
  VariableBank* fallback_ = nullptr;
  std::map<std::string, int> names_;
  std::vector<Range> banks_;             ///< by first number
  std::vector<VariableSymbol> symbols_;  ///< by name
};

}  // namespace proveout::nc
