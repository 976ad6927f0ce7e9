// Checks against our own bugs; they throw std::logic_error.
#pragma once

#include <stdexcept>

/// On in every build.
#define PROVEOUT_ASSERT(condition)                                                               \
  do {                                                                                           \
    if (!(condition)) throw std::logic_error("assertion failed: " #condition " (" __FILE__ ")"); \
  } while (false)

namespace proveout {
#ifdef PROVEOUT_DEAR_ASSERTIONS
inline constexpr bool kDearAssertions = true;
#else
inline constexpr bool kDearAssertions = false;
#endif
}  // namespace proveout

/// The same for what would slow a run down, as a look at a whole mesh does: compiled always, run in the
/// presets dev and asan (PROVEOUT_DEAR_ASSERTIONS).
#define PROVEOUT_ASSERT_DEAR(condition)                                    \
  do {                                                                     \
    if constexpr (::proveout::kDearAssertions) PROVEOUT_ASSERT(condition); \
  } while (false)
