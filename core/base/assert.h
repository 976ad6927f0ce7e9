// PROVEOUT_ASSERT: a check against our own bugs, on in every build; throws std::logic_error.
#pragma once

#include <stdexcept>

#define PROVEOUT_ASSERT(condition)                                                               \
  do {                                                                                           \
    if (!(condition)) throw std::logic_error("assertion failed: " #condition " (" __FILE__ ")"); \
  } while (false)
