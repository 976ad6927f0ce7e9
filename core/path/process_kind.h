// The manufacturing processes that a control drives.
#pragma once

#include <cstdint>

namespace proveout {

enum class ProcessKind : std::uint8_t {
  kMilling,  ///< the tool turns, the workpiece stands
  kTurning,  ///< the workpiece turns about Z: X of the path is a radius
  kWire,     ///< a wire cuts through the workpiece: the path is of wire motions
};

}  // namespace proveout
