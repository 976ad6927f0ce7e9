// How much memory this process may take while it reads.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"

namespace proveout {

/// How much this process may hold while it reads files and programs, bytes; behind that, predictions hold.
/// There is one for the process, since what is counted is all of it: it is in force as long as the object
/// lives that has set it.
class MemoryLimit {
 public:
  explicit MemoryLimit(double bytes = 0.0) { set(bytes); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit();
  /// The first one that is above 0 counts, as 64 MB at least. Not from several threads.
  void set(double bytes);

 private:
  bool own_ = false;  ///< the limit in force is this object's
};

/// Error (kResourceLimit): `more` bytes on top of what is held would go over the limit. `what` begins its
/// message: "a.nc: the program". Any thread.
Status memoryFor(double more, const std::string& what);

/// Whether the limit is passed. Takes some microseconds. Any thread.
bool memorySpent();

/// The first error of memoryFor() since the limit was set. Any thread.
std::optional<Error> memoryRefusal();

}  // namespace proveout
