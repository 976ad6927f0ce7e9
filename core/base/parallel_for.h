// The one parallel loop. Whoever includes it links TBB::tbb; include it in .cpp files only.
#pragma once

#include <tbb/parallel_for.h>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace proveout {

#if defined(__SANITIZE_THREAD__)
// TBB's library is not instrumented: the thread sanitizer does not see that a loop hands its data to the
// workers and waits for them, and would call each of these handovers a race. The two marks say so. They order
// the calls with what stands before and after the loop but not with each other, so that a race between two
// calls is found.
template <typename Body>
class MarkedBody {
 public:
  MarkedBody(const Body& body, char& fork, char& join) : body_(&body), fork_(&fork), join_(&join) {}
  // Not instrumented: TBB has copied this object from another thread, which is a handover as well.
  template <typename Index>
  __attribute__((no_sanitize_thread, noinline)) void operator()(Index i) const {
    __tsan_acquire(fork_);
    (*body_)(i);
    __tsan_release(join_);
  }

 private:
  const Body* body_;
  char* fork_;
  char* join_;
};
#endif

/// Calls `body(i)` for each i in first..last-1, on any threads and in any order; returns when all are done.
/// `body` may run a loop itself. What it throws reaches the caller.
template <typename Index, typename Body>
void parallelFor(Index first, Index last, const Body& body) {
#if defined(__SANITIZE_THREAD__)
  char fork = 0, join = 0;
  __tsan_release(&fork);
  tbb::parallel_for(first, last, MarkedBody<Body>(body, fork, join));
  __tsan_acquire(&join);
#else
  tbb::parallel_for(first, last, body);
#endif
}

}  // namespace proveout
