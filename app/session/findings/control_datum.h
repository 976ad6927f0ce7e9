// What a lathe's control keeps of its tools, as a job names it.
#pragma once

#include <string>
#include <string_view>

namespace proveout {

enum class LatheDatum { kNoseRadius, kTip, kOffsetX, kOffsetZ };

/// The control's own name of it: "RT" of wl4-lathe, "nose_radius" of fanuc-lathe. `control` is one of the
/// list.
std::string_view latheDatumName(std::string_view control, LatheDatum datum);
/// As the job writes that of row `number`: "control.wl4-lathe.RT.3", "control.fanuc.nose_radius.3".
std::string latheDatumKey(std::string_view control, LatheDatum datum, int number);

}  // namespace proveout
