// The parameters of LinuxCNC: numbers 1 to 5601, of Mach3 0 to 10320, and names.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/macro/value.h"

namespace proveout::nc {

/// The store alone: what the control tells by numbers and names of its own is asked elsewhere
/// (LcnSystemValues). Numbers never written are 0. Those that the control keeps between programs (5161 to
/// 5390) are in machine units.
class LcnVariables {
 public:
  static constexpr int kLast = 5601;
  static constexpr int kMost = 10320;  ///< of Mach3
  static constexpr int kLocals = 30;   ///< #1 to #30 belong to a call

  static bool exists(int number) { return number >= 1 && number <= kLast; }
  /// `number` exists; so below.
  const Value& at(int number) const { return values_[static_cast<std::size_t>(number)]; }
  double number(int number) const { return at(number).number; }
  void put(int number, const Value& value);
  void put(int number, double value) { put(number, Value{value}); }

  /// A name in small letters without < >; one that begins with _ is global. Null: not defined.
  const Value* named(std::string_view name) const;
  void putNamed(std::string_view name, const Value& value);

  /// A call: #1 to #30 become the arguments, others of them 0, and names begin anew.
  void enter(const std::vector<Value>& arguments);
  /// The caller's are in force again.
  void leave();
  std::size_t levels() const { return levels_.size(); }

  /// The same while all have the same values.
  std::uint64_t fingerprint() const { return fingerprint_; }

 private:
  using Names = std::map<std::string, Value, std::less<>>;
  struct Level {
    std::array<Value, kLocals + 1> saved;  ///< #1 to #30 of the caller
    Names saved_names;
    std::uint64_t names_print = 0;
  };
  static std::uint64_t hashOf(std::uint64_t place, const Value& value);
  Names& namesOf(std::string_view name) { return name.starts_with('_') ? globals_ : locals_; }

  std::array<Value, kMost + 1> values_{};
  Names globals_, locals_;
  std::vector<Level> levels_;
  std::uint64_t fingerprint_ = 0, locals_print_ = 0;
};

}  // namespace proveout::nc
