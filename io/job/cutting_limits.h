// What the machine and its tools can take: programs are held against it. The controls know nothing of it.
#pragma once

#include <map>

namespace proveout {

/// 0: not given, and not looked at.
struct ToolLimits {
  double max_rpm = 0.0;             ///< 1/min
  double max_feed_per_tooth = 0.0;  ///< mm; given together with `teeth`
  int teeth = 0;                    ///< cutting edges around the tool
};

/// 0: not given, and not looked at.
struct CuttingLimits {
  double max_feed = 0.0;                 ///< mm/min, of feed motions
  double max_rpm = 0.0;                  ///< 1/min, of the spindle
  std::map<int, ToolLimits> tools = {};  ///< by tool number; of those that have any
};

}  // namespace proveout
