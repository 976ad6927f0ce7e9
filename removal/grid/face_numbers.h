// The faces of a stock that another run, or another clamping, goes on with, and of meshes.
#pragma once

#include <cmath>
#include <map>
#include <utility>

#include "removal/grid/stock_impl.h"

namespace proveout {

/// The element of a mesh's triangle with this normal (unit): groups those of one flat face, in steps of about
/// a degree.
inline std::uint16_t flatFaceOf(const Vec3& n) {
  const auto q = [](double v) { return static_cast<unsigned>(std::lround((v + 1.0) * 60.0)); };
  return static_cast<std::uint16_t>((q(n.x()) * 121u + q(n.y())) * 121u + q(n.z()));
}

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
