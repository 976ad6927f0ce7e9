#include "core/nc/linuxcnc/program/lcn_system_values.h"

#include <array>
#include <utility>

#include "core/nc/iso/context/words.h"
#include "core/nc/linuxcnc/model/channel.h"

namespace proveout::nc {
namespace {

constexpr std::string_view kLcnAxisLetters = "xyzabcuvw";

/// Index of the axis of the k-th letter in the channel, or -1.
int lcnAxis(const IsoContext& c, std::size_t k) {
  return k < 3 ? static_cast<int>(k) : c.axes.names().axisOfLetter(upper(kLcnAxisLetters[k]));
}

/// Position of an axis in the units of the program, degrees for rotary ones.
double lcnPosition(const IsoContext& c, const AxisPoint& at, std::size_t k) {
  const int axis = lcnAxis(c, k);
  if (axis < 0) return 0.0;
  return c.axes.at(axis).rotary() ? at[axis] : at[axis] / c.state.unitScale();
}

/// Where the program stands, in the sub of a contour too.
const AxisPoint& lcnPlace(const IsoContext& c) {
  const auto& contour = linuxCncChannel(c).contour_at;
  return contour ? *contour : c.position;
}

double active(const IsoContext& c, IsoGroup group) {
  return static_cast<double>(c.state.active[static_cast<std::size_t>(group)]);
}
double truth(bool holds) { return holds ? 1.0 : 0.0; }

/// G1 is 10; a cycle counts as its code, and no motion as G80.
double motionMode(const IsoContext& c) { return active(c, c.state.inCycle() ? kGroupCycle : kGroupMotion); }

double lcnFrameNumber(const IsoContext& c) {
  const int id = c.state.work_system;
  return id < kFirstExtended ? id : id - kFirstExtended + 7;
}

/// Of frames 1 to 9: 540 to 590 in tens, then 591 to 593.
double frameCode(const IsoContext& c) {
  const double n = lcnFrameNumber(c);
  return n <= 6.0 ? 530.0 + 10.0 * n : 584.0 + n;
}

using LcnName = double (*)(const IsoContext&, const LcnRunState&);
constexpr auto kLcnNames = std::to_array<std::pair<std::string_view, LcnName>>({
    {"_feed", [](const IsoContext& c, const LcnRunState&) { return c.state.feed; }},
    {"_rpm", [](const IsoContext& c, const LcnRunState&) { return c.state.spindle_rpm; }},
    {"_current_tool", [](const IsoContext& c, const LcnRunState&) { return double(c.state.tool); }},
    {"_current_pocket", [](const IsoContext& c, const LcnRunState&) { return double(c.state.tool); }},
    {"_selected_tool",
     [](const IsoContext& c,
        const LcnRunState&) { return c.state.next_tool < 0 ? 0.0 : double(c.state.next_tool); }},
    {"_selected_pocket", [](const IsoContext& c, const LcnRunState&) { return double(c.state.next_tool); }},
    {"_tool_offset",
     [](const IsoContext& c,
        const LcnRunState&) { return truth(active(c, kGroupLengthComp) != gcode::kLengthOff); }},
    {"_plane", [](const IsoContext& c, const LcnRunState&) { return active(c, kGroupPlane); }},
    {"_motion_mode", [](const IsoContext& c, const LcnRunState&) { return motionMode(c); }},
    {"_ccomp", [](const IsoContext& c, const LcnRunState&) { return active(c, kGroupRadiusComp); }},
    {"_metric", [](const IsoContext& c, const LcnRunState&) { return truth(c.state.unitScale() == 1.0); }},
    {"_imperial", [](const IsoContext& c, const LcnRunState&) { return truth(c.state.unitScale() != 1.0); }},
    {"_absolute", [](const IsoContext& c, const LcnRunState&) { return truth(!c.state.incremental()); }},
    {"_incremental", [](const IsoContext& c, const LcnRunState&) { return truth(c.state.incremental()); }},
    {"_inverse_time",
     [](const IsoContext& c, const LcnRunState&) { return truth(active(c, kGroupFeedMode) == 930.0); }},
    {"_units_per_minute",
     [](const IsoContext& c, const LcnRunState&) { return truth(active(c, kGroupFeedMode) == 940.0); }},
    {"_units_per_rev",
     [](const IsoContext& c, const LcnRunState&) { return truth(active(c, kGroupFeedMode) == 950.0); }},
    {"_coord_system", [](const IsoContext& c, const LcnRunState&) { return frameCode(c); }},
    // The other way round in the documentation; so in runs.
    {"_retract_r_plane",
     [](const IsoContext& c, const LcnRunState&) { return truth(active(c, kGroupReturn) == 990.0); }},
    {"_retract_old_z",
     [](const IsoContext& c, const LcnRunState&) { return truth(active(c, kGroupReturn) == 980.0); }},
    {"_spindle_on",
     [](const IsoContext& c, const LcnRunState&) { return truth(c.state.spindle_direction != 0); }},
    {"_spindle_cw",
     [](const IsoContext& c, const LcnRunState&) { return truth(c.state.spindle_direction > 0); }},
    {"_spindle_rpm_mode",
     [](const IsoContext& c,
        const LcnRunState&) { return truth(active(c, kGroupSurfaceSpeed) != gcode::kSurfaceSpeed); }},
    {"_spindle_css_mode",
     [](const IsoContext& c,
        const LcnRunState&) { return truth(active(c, kGroupSurfaceSpeed) == gcode::kSurfaceSpeed); }},
    {"_lathe_diameter_mode",
     [](const IsoContext& c, const LcnRunState&) { return truth(c.state.axes.diameter[0]); }},
    {"_lathe_radius_mode",
     [](const IsoContext& c, const LcnRunState&) { return truth(!c.state.axes.diameter[0]); }},
    {"_mist", [](const IsoContext&, const LcnRunState& run) { return truth(run.mist); }},
    {"_flood", [](const IsoContext&, const LcnRunState& run) { return truth(run.flood); }},
    {"_line", [](const IsoContext& c, const LcnRunState&) { return double(c.calls.top().block + 1); }},
    {"_call_level", [](const IsoContext& c, const LcnRunState&) { return double(c.calls.depth()) - 1.0; }},
    {"_value", [](const IsoContext&, const LcnRunState& run) { return run.value; }},
    {"_value_returned", [](const IsoContext&, const LcnRunState& run) { return truth(run.value_returned); }},
    {"_vmajor", [](const IsoContext&, const LcnRunState&) { return 2.9; }},
    {"_vminor", [](const IsoContext&, const LcnRunState&) { return 0.0; }},
    {"_task", [](const IsoContext&, const LcnRunState&) { return 0.0; }},
    {"_remap_level", [](const IsoContext&, const LcnRunState&) { return 0.0; }},
    {"_speed_override", [](const IsoContext&, const LcnRunState&) { return 1.0; }},
    {"_feed_override", [](const IsoContext&, const LcnRunState&) { return 1.0; }},
    {"_adaptive_feed", [](const IsoContext&, const LcnRunState&) { return 0.0; }},
    {"_feed_hold", [](const IsoContext&, const LcnRunState&) { return 1.0; }},
});

}  // namespace

std::optional<double> lcnSystemValue(const IsoContext& c, int number) {
  if (number == 5220) return lcnFrameNumber(c);
  if (number == 5400) return static_cast<double>(c.state.tool);
  if (number >= 5420 && number <= 5428)
    return lcnPosition(c, lcnPlace(c), static_cast<std::size_t>(number - 5420));
  return {};
}

bool lcnReadOnly(int number) {
  return (number >= 5400 && number <= 5413) || (number >= 5420 && number <= 5428);
}

std::optional<double> lcnPredefined(const IsoContext& c, const LcnRunState& run, std::string_view name) {
  if (name.size() < 2 || name[0] != '_') return {};
  for (const auto& [known, value] : kLcnNames)
    if (known == name) return value(c, run);
  const bool absolute = name.starts_with("_abs_");
  const std::string_view letter = name.substr(absolute ? 5 : 1);
  const std::size_t k = letter.size() == 1 ? kLcnAxisLetters.find(letter[0]) : std::string_view::npos;
  if (k == std::string_view::npos) return {};
  return lcnPosition(c, absolute ? c.machine : lcnPlace(c), k);
}

}  // namespace proveout::nc
