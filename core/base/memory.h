// What the machine has free.
#pragma once

namespace proveout {

/// Bytes that a program can take without swapping; all of the machine's where the system does not say.
double availableMemoryBytes();

}  // namespace proveout
