// The faces of a stock that another run, or another clamping, goes on with.
#pragma once

#include <map>
#include <utility>

#include "removal/grid/stock_impl.h"

namespace proveout {

/// The motions that cut the stock so far mean nothing to those that follow, but its faces stay apart: every
/// pair of motion and element becomes an element of the blank.
inline void numberFaces(Stock::Impl& impl) {
  std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint16_t> number;
  for (StockLeaf& leaf : impl.leaves) {
    for (Crossing& c : leaf.crossings) {
      const auto next =
          static_cast<std::uint16_t>(number.size());  // beyond 65,535 faces numbers come again, far away
      c.element = number.try_emplace({c.motion, c.element}, next).first->second;
      c.motion = kNoMotion;
    }
  }
}

}  // namespace proveout
