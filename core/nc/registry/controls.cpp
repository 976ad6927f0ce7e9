#include "core/nc/registry/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "core/base/nearest_name.h"
#include "core/nc/fanuc/fanuc_row.h"
#include "core/nc/flexnc/flexnc_row.h"
#include "core/nc/linuxcnc/linuxcnc_row.h"
#include "core/nc/nct/nct_row.h"
#include "core/nc/wedm/wedm_row.h"
#include "core/nc/wl4/wl4_row.h"

namespace proveout {
namespace nc {

std::span<const ControlRow* const> controlRows() {
  static const std::array kRows{&nctRow(),  &wl4MillRow(),   &wl4LatheRow(),   &flexncRow(),
                                &wedmRow(), &fanucMillRow(), &fanucLatheRow(), &linuxCncRow()};
  return kRows;
}

const ControlRow& rowOf(ControlId control) {
  const auto rows = controlRows();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const ControlRow* row) { return row->id == control; });
  PROVEOUT_ASSERT(found != rows.end());
  return **found;
}

}  // namespace nc

const std::vector<ControlInfo>& controls() {
  static const std::vector<ControlInfo> kControls = [] {
    std::vector<ControlInfo> all;
    for (const nc::ControlRow* row : nc::controlRows())
      all.push_back({row->id, row->name, row->summary, row->run != nullptr, row->process,
                     row->settings_table.empty() ? row->name : row->settings_table});
    return all;
  }();
  return kControls;
}

std::vector<std::string> builtControlNames() {
  std::vector<std::string> names;
  for (const ControlInfo& control : controls()) {
    if (control.built) names.emplace_back(control.name);
  }
  return names;
}

Result<ControlId> findControl(std::string_view name) {
  for (const ControlInfo& control : controls()) {
    if (control.name != name) continue;
    if (control.built) return control.id;
    return inputError(fmt::format("control {} is known but this version cannot run it yet", name));
  }
  std::string word(name);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::vector<std::string> built = builtControlNames();
  return inputError(fmt::format("unknown control {}{}; there are {}", name,
                                didYouMean(nearestName(word, built)), fmt::join(built, ", ")));
}

std::string_view coverageStatus(std::string_view cls) {
  return cls == "SIM"     ? "simulated"
         : cls == "TIME"  ? "timed"
         : cls == "STATE" ? "tracked"
         : cls == "HOST"  ? "noted"
                          : "refused";
}

CoverageRow coverageRow(std::string code, int group, std::string_view cls, std::string_view ids,
                        std::string_view meaning, bool served) {
  return {std::move(code),  group,
          std::string(cls), std::string(served ? coverageStatus(cls) : "refused"),
          std::string(ids), std::string(meaning)};
}

Result<std::vector<CoverageRow>> coverageTable(ControlId control) {
  if (const auto table = nc::rowOf(control).coverage) return table();
  return inputError(nc::kNotBuilt);
}

std::span<const TextSetting> textSettings(ControlId control) { return nc::rowOf(control).texts; }

std::vector<ParameterInfo> parameterTable(ControlId control) {
  const auto table = nc::rowOf(control).parameters;
  return table != nullptr ? table() : std::vector<ParameterInfo>{};
}

bool limitsTravel(ControlId control, const ControlSettings& settings) {
  const auto& limits = settings.limits;
  const auto& axes = settings.axes;
  if (std::any_of(limits.begin(), limits.end(), [](const auto& limit) { return limit.has_value(); }) ||
      std::any_of(axes.begin(), axes.end(), [](const AxisSettings& axis) { return axis.limit.has_value(); }))
    return true;
  const auto by_parameters = nc::rowOf(control).limits_travel;
  return by_parameters != nullptr && by_parameters(settings.parameters);
}

}  // namespace proveout
