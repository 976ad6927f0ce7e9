#include "core/nc/fanuc/lathe/thread_depths.h"

#include <algorithm>
#include <cmath>

namespace proveout::nc {

std::vector<double> threadDepths(const ThreadInfeed& infeed) {
  constexpr double kSameDepthMm = 1e-9;
  const double rough = infeed.height - infeed.finish;
  std::vector<double> depths;
  for (double n = 1.0, before = 0.0;; n += 1.0) {
    double depth = infeed.first * (infeed.equal ? n : std::sqrt(n));
    if (n > 1.0 && depth - before < infeed.least) depth = before + infeed.least;
    if (!(depth < rough - kSameDepthMm)) break;
    if (depths.size() >= kMostThreadPasses) return {};
    depths.push_back(depth);
    before = depth;
  }
  depths.push_back(rough);
  const int repeats = std::max(infeed.repeats, infeed.finish > kSameDepthMm ? 1 : 0);
  for (int k = 0; k < repeats; ++k) depths.push_back(infeed.height);
  return depths;
}

}  // namespace proveout::nc
