// Worker threads where the system may not give any.
#pragma once

#include <optional>

#include "core/base/thread_limit.h"

namespace proveout {

/// Limits work to `threads` threads (0: all cores), and to those that can be started, while it lives. The
/// results do not depend on their number.
class ThreadSupply {
 public:
  explicit ThreadSupply(int threads);
  int count() const { return count_; }

 private:
  int count_ = 1;
  std::optional<ThreadLimit> limit_;
};

}  // namespace proveout
