#include "app/session/forecast/thread_supply.h"

#include <algorithm>

#include "core/base/startable_threads.h"

namespace proveout {

ThreadSupply::ThreadSupply(int threads) {
  const int cores = std::max(1, tbb::info::default_concurrency());
  const int wanted = threads > 0 ? threads : cores, most = std::max(wanted, cores);
  const int startable = 1 + startableThreads(most - 1);
  // A shortage stays for good: where a limit goes, TBB starts the threads that were missing, and where it
  // cannot it ends the process.
  if (startable < most) static_cast<void>(new ThreadLimit(startable));
  count_ = std::min(wanted, startable);
  limit_.emplace(count_);
}

}  // namespace proveout
