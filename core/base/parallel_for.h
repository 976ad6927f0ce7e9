// The one parallel loop. Whoever includes it links TBB::tbb; include it in .cpp files only.
#pragma once

#include <tbb/parallel_for.h>

#if defined(__SANITIZE_THREAD__)
#include "core/base/plain_loop.h"
#endif

namespace proveout {

/// Calls `body(i)` for each i in first..last-1, on any threads and in any order; returns when all are done.
/// `body` may run a loop itself. What it throws reaches the caller.
template <typename Index, typename Body>
void parallelFor(Index first, Index last, const Body& body) {
#if defined(__SANITIZE_THREAD__)
  plainLoop(first, last, body);
#else
  tbb::parallel_for(first, last, body);
#endif
}

}  // namespace proveout
