// The file that a program writes.
#pragma once

#include <cstddef>
#include <string>

#include "core/nc/control/control_host.h"

namespace proveout::nc {

/// The file that a program has open, and where its bytes go.
struct OutputFile {
  MemoryOutput unkept;     ///< takes the bytes where the host has no output
  bool open = false;       ///< between an opening and a closing statement
  bool periphery = false;  ///< opened by POPEN: the first DPRNT is the name of the file
  std::string name;        ///< empty: not named yet
  std::size_t bytes = 0;   ///< written since it was opened
};

}  // namespace proveout::nc
