// How many threads this process may have.
#pragma once

namespace proveout {

/// How many threads the system lets this process start beside the calling one, `wanted` at most: a limit on
/// processes or on memory may allow fewer.
int startableThreads(int wanted);

}  // namespace proveout
