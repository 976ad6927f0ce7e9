// Number of worker threads of a piece of work.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>

namespace proveout {

/// Limits TBB while it lives. 0: all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads)
      : control_(
            tbb::global_control::max_allowed_parallelism,
            static_cast<std::size_t>(threads > 0 ? threads : std::max(1, tbb::info::default_concurrency()))) {
  }

 private:
  tbb::global_control control_;
};

}  // namespace proveout
