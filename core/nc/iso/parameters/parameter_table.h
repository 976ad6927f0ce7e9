// The parameters that one control has.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"
#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

/// A parameter of the control that is not set by its number here: its whole number, and what says it instead.
struct ElsewhereParam {
  std::string_view name;     ///< "N2101"; bits and numbers of axes follow behind a dot
  std::string_view instead;  ///< "write couple = ..."
};

/// Rows for what the shared code asks of parameters. A control says which of them it has, under its own names
/// and numbers. Nobody can set the others: they are as most machines have them, that is 0 but for those in
/// which 0 would mean a machine without something (parameter_table.cpp).
class ParameterTable {
 public:
  /// `control`: its name, for messages; `own_rows`: of ParamChapter::kOwn.
  explicit ParameterTable(std::string_view control, std::size_t own_rows = 0);
  /// All rows of a chapter, in the order of its enumeration.
  ParameterTable& add(ParamChapter chapter, std::span<const ParamInfo> rows);
  template <class Enum>
  ParameterTable& add(Enum p, const ParamInfo& row) {
    return addRow(paramId(p), row);
  }
  /// A parameter that the control does not have and that always has this value.
  template <class Enum>
  ParameterTable& fix(Enum p, double value) {
    ParamInfo row;
    row.default_value = row.min = row.max = value;
    return addRow(paramId(p), row);
  }

  /// The list must outlive the table.
  ParameterTable& tellElsewhere(std::span<const ElsewhereParam> list) {
    elsewhere_ = list;
    return *this;
  }
  /// What says a parameter of that name instead of it; empty: nothing is known of it.
  std::string_view insteadOf(std::string_view name) const;

  std::string_view control() const { return control_; }
  const std::vector<ParamInfo>& chapter(ParamChapter chapter) const {
    return chapters_[static_cast<std::size_t>(chapter)];
  }
  template <class Enum>
  const ParamInfo& row(Enum p) const {
    const ParamId id = paramId(p);
    return chapter(id.chapter)[id.row];
  }
  /// What the control has, for the job reader.
  std::vector<ParameterInfo> list() const;

 private:
  ParameterTable& addRow(ParamId id, const ParamInfo& row);

  std::string_view control_;
  std::span<const ElsewhereParam> elsewhere_;
  std::array<std::vector<ParamInfo>, static_cast<std::size_t>(ParamChapter::kCount)> chapters_;
};

}  // namespace proveout::nc
