#include "app/session/findings/control_datum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/nc/control/control_info.h"

namespace proveout {
namespace {

/// Names by LatheDatum, of controls with a grammar of their own and of the ISO family.
constexpr std::array<std::array<std::string_view, 2>, 4> kNames{
    {{"RT", "nose_radius"}, {"TIP", "tip"}, {"DXW", "offset_x"}, {"DZW", "offset_z"}}};

}  // namespace

std::string_view latheDatumName(std::string_view control, LatheDatum datum) {
  const auto& names = kNames[static_cast<std::size_t>(datum)];
  const Result<ControlId> id = findControl(control);
  if (!id) return names[0];
  const auto table = parameterTable(*id);
  const bool own =
      std::any_of(table.begin(), table.end(), [&](const ParameterInfo& p) { return p.name == names[1]; });
  return names[own ? 1 : 0];
}

std::string latheDatumKey(std::string_view control, LatheDatum datum, int number) {
  const auto& all = controls();
  const auto info =
      std::find_if(all.begin(), all.end(), [&](const ControlInfo& one) { return one.name == control; });
  const bool shared = info != all.end() && !info->settings_table.empty();
  return fmt::format("control.{}.{}.{}", shared ? info->settings_table : control,
                     latheDatumName(control, datum), number);
}

}  // namespace proveout
