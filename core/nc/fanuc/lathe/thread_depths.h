// Infeeds of the thread cycle G76 (section 16). No control.
#pragma once

#include <vector>

namespace proveout::nc {

struct ThreadInfeed {
  double height = 0.0;  ///< k, mm, > 0
  double first = 0.0;   ///< d1, depth of the first pass, mm, > 0
  double least = 0.0;   ///< a pass takes no less than this, but for the last ones, mm
  double finish = 0.0;  ///< d, left for the finish passes, mm, 0 <= d < k
  int repeats = 0;      ///< finish passes at the full height
  bool equal = false;   ///< each pass is as deep as the first; false: of equal sections
};
inline constexpr std::size_t kMostThreadPasses = 5000;

/// Depths of all passes, rising, the last one k. Empty: more than kMostThreadPasses.
std::vector<double> threadDepths(const ThreadInfeed& infeed);

}  // namespace proveout::nc
