// Values of the parameters of a control that the simulation knows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/nc/iso/parameters/axis.h"
#include "core/nc/iso/parameters/comp.h"
#include "core/nc/iso/parameters/cycles.h"
#include "core/nc/iso/parameters/data.h"
#include "core/nc/iso/parameters/feeds.h"
#include "core/nc/iso/parameters/five_axis.h"
#include "core/nc/iso/parameters/functions.h"
#include "core/nc/iso/parameters/machine.h"
#include "core/nc/iso/parameters/macro.h"
#include "core/nc/iso/parameters/motion.h"
#include "core/nc/iso/parameters/parameter_table.h"
#include "core/nc/iso/parameters/parameter_types.h"
#include "core/nc/iso/parameters/program.h"
#include "core/nc/iso/parameters/safety.h"
#include "core/nc/iso/parameters/spindle.h"
#include "core/nc/iso/parameters/tools.h"

namespace proveout::nc {

/// How an access by number went.
enum class ParamStatus {
  kOk,
  kUnknown,     ///< no such parameter here
  kNeedsBit,    ///< the parameter consists of bits
  kNeedsIndex,  ///< it belongs to an axis or a spindle
  kBadIndex,    ///< there is no such channel, axis or spindle
  kOutOfRange,  ///< the value
  kRestart      ///< takes effect at power-on only (2193)
};

/// Values of all parameters of a channel. Lengths mm. Reading costs two indexed loads.
class IsoParameters {
 public:
  /// `table` must outlive the parameters.
  explicit IsoParameters(const ParameterTable& table);

  /// `number` counts from 1 and is that of the axis or spindle; other scopes take no notice of it.
  template <class Enum>
  double value(Enum p, int number = 1) const {
    return values_[slot(paramId(p), number)];
  }
  template <class Enum>
  bool flag(Enum p, int number = 1) const {
    return value(p, number) != 0.0;
  }
  template <class Enum>
  double operator[](Enum p) const {
    return value(p);
  }
  /// Whether set() or write() gave the parameter a value.
  template <class Enum>
  bool given(Enum p, int number = 1) const {
    return given_[slot(paramId(p), number)] != 0;
  }

  /// The control's name of a parameter, "N0607.ORI"; with the value that is said to be in force there,
  /// "N0607.ORI = 0".
  template <class Enum>
  std::string_view name(Enum p) const {
    return table_.row(p).name;
  }
  template <class Enum>
  std::string nameWith(Enum p, int value) const {
    return std::string(name(p)) + " = " + std::to_string(value);
  }

  /// Overwrites defaults by name; "N0107.REN.4" is that of axis 4, "N0107.REN" those of all. Error: unknown
  /// name (names the nearest) or value out of range.
  Status set(const std::map<std::string, double>& values);

  /// By number, for programs. `bit` is 0..7 or kWholeParam, `index` the axis or spindle number (0: none
  /// given; channel parameters have number 1 too). With `add` the value is added. On anything but kOk nothing
  /// changes.
  ParamStatus write(int number, int bit, int index, double value, bool add);
  ParamStatus read(int number, int bit, int index, double& out) const;
  /// For what the job says elsewhere.
  template <class Enum>
  void put(Enum p, double value) {
    put(slot(paramId(p), 1), value);
  }
  /// From here on write() of a global parameter changes those of `others` too: the control has it once.
  void shareGlobals(std::vector<IsoParameters*> others) { others_ = std::move(others); }
  const ParameterTable& table() const { return table_; }
  /// Parameters with a value by set() that have no effect in the simulation.
  std::vector<std::string_view> notedNames() const;
  /// Grows with every change: what is worked out from parameters is kept until then.
  std::uint32_t revision() const { return revision_; }

 private:
  struct Row {
    std::uint32_t first = 0;  ///< slot of number 1
    std::uint32_t count = 1;  ///< slots
  };
  std::size_t slot(ParamId id, int number) const {
    const Row& row = rows_[chapter_first_[static_cast<std::size_t>(id.chapter)] + id.row];
    const auto index = static_cast<std::uint32_t>(number - 1);
    return row.first + (index < row.count ? index : 0);
  }
  ParamStatus find(int number, int bit, int index, std::size_t& row, std::size_t& slot) const;
  Status setOne(const std::string& name, double value);
  void put(std::size_t slot, double value);

  std::string nearestTo(std::string_view name) const;

  const ParameterTable& table_;
  std::array<std::size_t, static_cast<std::size_t>(ParamChapter::kCount)> chapter_first_{};
  std::vector<const ParamInfo*> infos_;  ///< of every row
  std::vector<Row> rows_;
  std::vector<double> values_;       ///< by slot
  std::vector<std::uint8_t> given_;  ///< by slot
  std::uint32_t revision_ = 1;
  std::vector<IsoParameters*> others_;  ///< of the other channels
  std::vector<std::size_t> by_number_;  ///< rows by number and bit
};

}  // namespace proveout::nc
