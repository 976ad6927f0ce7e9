#include "app/session/programs/wire_heights.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "app/session/programs/placed_path.h"
#include "core/nc/control/control_info.h"
#include "removal/wire/falls/wire_work.h"

namespace proveout {
namespace {

constexpr double kSameHeight = 1e-3;  ///< mm

struct WireHeight {
  const char* parameter;
  double blank_mm;
};

bool cutsWithWire(const Job& job) {
  const Result<ControlId> control = findControl(job.control);
  return control && *control == ControlId::kWedm;
}

/// As the control counts heights.
std::array<WireHeight, 2> heightsOf(const ControlSettings& settings, const Box3& blank) {
  const double down = pathIntoWorkpiece(settings).translation.z();
  return {{{"T", blank.size().z()}, {"ZB", blank.min.z() - down}}};
}

void warn(std::string message, Toolpath& path) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.code = "wedm-heights";
  warning.message = std::move(message);
  path.diagnostics.add(std::move(warning));
}

}  // namespace

void giveWireHeights(const Job& job, const Box3& blank, ControlSettings& settings) {
  if (!cutsWithWire(job)) return;
  for (const WireHeight& height : heightsOf(settings, blank))
    settings.parameters.try_emplace(height.parameter, height.blank_mm);
}

void noteWireHeights(const Job& setup, std::size_t k, const Box3& blank, Toolpath& path) {
  if (!cutsWithWire(setup)) return;
  const auto& given = setup.settings.parameters;
  const auto heights = heightsOf(setup.settings, blank);
  if (k > 0) {
    const bool open = given.count("T") == 0 && given.count("ZS") + given.count("ZM") < 2;
    if (open && !standsUpright(path))
      warn(fmt::format(
               "the wire leans by the heights of the blank, T {:g} and ZB {:g}: what the setups before took "
               "off it is not counted; give T and ZB in [control.wedm]",
               heights[0].blank_mm, heights[1].blank_mm),
           path);
    return;
  }
  for (const WireHeight& height : heights) {
    const auto own = given.find(height.parameter);
    if (own == given.end() || std::abs(own->second - height.blank_mm) < kSameHeight) continue;
    warn(height.parameter[0] == 'T' ? fmt::format("T is {:g} mm in a plate of {:g} mm: planes, guides and "
                                                  "speeds are those of T; leave it out "
                                                  "of [control.wedm] where the plate is meant",
                                                  own->second, height.blank_mm)
                                    : fmt::format("ZB is {:g} mm where the bottom of the plate is at {:g}: "
                                                  "planes and guides are those of ZB; "
                                                  "leave it out of [control.wedm] where the plate is meant",
                                                  own->second, height.blank_mm),
         path);
  }
}

}  // namespace proveout
