// What bodies of one motion say of a column, for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "removal/sweep/swept_body.h"

namespace proveout::test {

/// A body tells blocks around a column of no less than it covers there.
inline void expectReach(const SweptBody& body, double x, double y, double lo, double hi) {
  FourBlocks blocks{};
  blocks.half_width = 0.7;
  for (int i = 0; i < 4; ++i) {
    blocks.x[i] = x + (i & 1 ? 0.6 : -0.6), blocks.y[i] = y + (i & 2 ? 0.6 : -0.6);
    blocks.z_low[i] = -1e3, blocks.z_high[i] = 1e3;
  }
  double low[4], high[4];
  body.reach(blocks, low, high);
  for (int i = 0; i < 4; ++i) {
    EXPECT_LE(low[i], lo);
    EXPECT_GE(high[i], hi);
  }
  EXPECT_GE(body.highestReach(), hi);
}

/// A body says that it takes something from a leaf with one column of material, from z0 to `top`.
inline void expectHit(const SweptBody& body, double x, double y, double z0, double top) {
  constexpr int kColumn = 21;
  LeafColumns leaf{};
  leaf.h = (top - z0) / 8.0;
  for (int i = 0; i < 64; ++i) {
    leaf.x[i] = x + 0.2 * ((i & 7) - (kColumn & 7)), leaf.y[i] = y + 0.2 * ((i >> 3) - (kColumn >> 3));
    leaf.top[i] = i == kColumn ? top : z0;
  }
  for (int z = 0; z < 8; ++z) leaf.z[z] = z0 + z * leaf.h;
  leaf.layers = 8;
  EXPECT_NE(body.hits(leaf, 15, top) >> kColumn / kQuarter & 1, 0u)
      << x << ' ' << y << ' ' << z0 << ' ' << top;
}

/// The intervals of a column, low and high; those that are no farther from each other than `gap` are one.
inline std::vector<std::array<double, 2>> columnSpans(const std::vector<SweptBody>& bodies, double x,
                                                      double y, double gap) {
  std::vector<std::array<double, 2>> out;
  for (const SweptBody& body : bodies) {
    std::array<double, 8> xs, ys, lo, hi;
    xs.fill(x), ys.fill(y);
    body.columns(xs.data(), ys.data(), 1, lo.data(), hi.data());
    if (!(lo[0] < hi[0])) continue;
    out.push_back({lo[0], hi[0]});
    expectReach(body, x, y, lo[0], hi[0]);
    // By the least: from above, and from below what stands over it.
    const double least = std::min(1e-4, 0.5 * (hi[0] - lo[0]));
    expectHit(body, x, y, lo[0] - 0.5, lo[0] + least);
    expectHit(body, x, y, hi[0] - least, hi[0] + 0.7);
  }
  std::sort(out.begin(), out.end());
  std::size_t kept = 0;
  for (const auto& s : out) {
    if (kept > 0 && s[0] <= out[kept - 1][1] + gap) {
      out[kept - 1][1] = std::max(out[kept - 1][1], s[1]);
    } else {
      out[kept++] = s;
    }
  }
  out.resize(kept);
  return out;
}

}  // namespace proveout::test
