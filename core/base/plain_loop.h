// The parallel loop of builds with the thread sanitizer.
//
// TBB's library is not instrumented: the sanitizer sees neither that a loop hands its data to the workers nor that it
// waits for them, and calls each handover, and each reuse of the stack behind a loop that is over, a race. Threads of
// the standard library it knows.
#pragma once

#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace proveout {

/// Whether this thread is in a loop already: loops inside run on their own thread, or threads would multiply.
inline thread_local bool insidePlainLoop = false;

/// As `parallelFor`, with threads that live for this loop. Four at most, which is enough to find races, and no more
/// than `ThreadLimit` allows; two at least where it allows them, however few cores there are.
template <typename Index, typename Body>
void plainLoop(Index first, Index last, const Body& body) {
  if (!(first < last)) return;
  std::atomic<Index> next{first};
  std::mutex guard;
  std::exception_ptr thrown;
  const auto work = [&] {
    const bool outer = insidePlainLoop;
    insidePlainLoop = true;
    try {
      // Relaxed: the count must not order the calls, which would hide a race between them.
      for (Index i; (i = next.fetch_add(1, std::memory_order_relaxed)) < last;) body(i);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(guard);
      if (!thrown) thrown = std::current_exception();
      next.store(last, std::memory_order_relaxed);
    }
    insidePlainLoop = outer;
  };
  const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const auto calls = static_cast<unsigned long long>(last - first);
  const auto threads = insidePlainLoop ? 1 : std::min<unsigned long long>({std::max<std::size_t>(allowed, 1), calls, 4});
  std::vector<std::thread> others;
  for (unsigned long long t = 1; t < threads; ++t) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace proveout
