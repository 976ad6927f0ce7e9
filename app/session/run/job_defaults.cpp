#include "app/session/run/job_defaults.h"

#include <cmath>
#include <sstream>

#include "core/nc/control/control_info.h"
#include "core/nc/control/text_settings.h"

namespace proveout {
namespace {

/// Height of the default start above the blank, mm: above any clamp and any clearance plane that programs
/// use.
constexpr double kStartClearance = 100.0;

}  // namespace

JobNames jobNames() {
  JobNames names;
  for (const ControlInfo& control : controls()) {
    if (!control.built) continue;
    names.controls.emplace_back(control.name);
    names.settings_tables[std::string(control.name)] = control.settings_table;
    const auto texts = textSettings(control.id);
    names.texts[std::string(control.name)].assign(texts.begin(), texts.end());
    auto& ranges = names.parameters[std::string(control.name)];
    for (const ParameterInfo& p : parameterTable(control.id)) {
      ranges.push_back({std::string(p.name), p.min, p.max, p.count});
      std::istringstream words{std::string(p.choices)};
      for (std::string word; words >> word;) ranges.back().choices.push_back(word);
    }
  }
  return names;
}

double defaultResolution(const Box3& blank) {
  const double wanted = blank.size().maxCoeff() / 400.0;
  if (!(wanted > 0) || !std::isfinite(wanted)) return 0.2;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (wanted <= step * decade * (1 + 1e-9)) return step * decade;
  }
  return 10.0 * decade;
}

Vec3 defaultStart(const Box3& blank) {
  const bool zero_above =
      blank.min.x() <= 0 && blank.max.x() >= 0 && blank.min.y() <= 0 && blank.max.y() >= 0;
  const Vec3 center = blank.center();
  return {zero_above ? 0.0 : center.x(), zero_above ? 0.0 : center.y(), blank.max.z() + kStartClearance};
}

}  // namespace proveout
