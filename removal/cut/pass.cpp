#include "removal/cut/pass.h"

#include <algorithm>

namespace proveout {

void uniteChords(const PassTable& table, std::span<const Reach> list, ReachList& out) {
  out.clear();
  const Sweep* last = nullptr;
  for (const Reach& reach : list) {
    const Pass& pass = table.passes[reach.pass];
    if (!pass.cuts()) continue;
    const Sweep* curve = pass.body.helix();
    if (curve != nullptr && curve == last) {
      out.back().low = std::min(out.back().low, reach.low);
      out.back().high = std::max(out.back().high, reach.high);
    } else {
      out.push_back(reach);
    }
    last = curve;
  }
}

}  // namespace proveout
