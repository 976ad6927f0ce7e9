#include "removal/cut/pass.h"

#include <algorithm>

namespace proveout {

void unitePieces(const PassTable& table, std::span<const Reach> list, ReachList& out) {
  out.clear();
  const SweptBody* last = nullptr;
  for (const Reach& reach : list) {
    const Pass& pass = table.passes[reach.pass];
    if (!pass.cuts()) continue;
    const SweptBody* whole = pass.body.isAskedWhole() ? &pass.body : nullptr;
    if (whole != nullptr && last != nullptr && whole->isPieceWith(*last)) {
      out.back().low = std::min(out.back().low, reach.low);
      out.back().high = std::max(out.back().high, reach.high);
    } else {
      out.push_back(reach);
    }
    last = whole;
  }
}

}  // namespace proveout
