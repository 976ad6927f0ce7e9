#include "core/nc/linuxcnc/model/channel.h"

namespace proveout::nc {

LinuxCncChannel::LinuxCncChannel(IsoContext& c) : comp(c.pipe, c.alarms, c) {
  home28 = AxisPoint(c.settings.reference_points[0].value_or(Vec3::Zero()));
  homes_known = c.settings.reference_points[0].has_value();
  home30 = AxisPoint(c.settings.reference_points[1].value_or(Vec3::Zero()));
}

std::unique_ptr<MakerData> makeLinuxCncChannel(IsoContext& c) { return std::make_unique<LinuxCncChannel>(c); }

}  // namespace proveout::nc
