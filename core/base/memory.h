// What memory the program may take, and what says so.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace proveout {

/// How many bytes more the process may take, and the reason: "the machine has so much free".
struct MemoryBound {
  double bytes = 0.0;
  std::string
      reason;  ///< what bounds it, with the way to change that in brackets; empty: the machine's free memory
};

/// The least of what the machine has free, what is left of the limits of this process (address space, data),
/// and of the limit of its control group.
MemoryBound memoryBound();
/// The same without the machine's free memory; infinite where the process has no limit.
MemoryBound processMemoryBound();

/// Bytes of memoryBound.
double availableMemoryBytes();

/// For an allocation that failed: `what`, as in "there is not enough memory for the surface", and the limit
/// of the process where it has one, else `advice`.
Error outOfMemory(std::string_view what, std::string_view advice);

}  // namespace proveout
