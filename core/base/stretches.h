// A loop over very many short tasks. Include it in .cpp files only.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/parallel_for.h"

namespace proveout {

/// Calls body(i) for each i below `count`: stretches of them on any threads, those of one stretch in order.
template <typename Body>
void forEachBelow(std::size_t count, const Body& body) {
  constexpr std::size_t kStretch = 2048;
  parallelFor(std::size_t{0}, (count + kStretch - 1) / kStretch, [&](std::size_t stretch) {
    for (std::size_t i = stretch * kStretch; i < std::min(count, (stretch + 1) * kStretch); ++i) body(i);
  });
}

}  // namespace proveout
