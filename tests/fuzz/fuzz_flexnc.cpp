// Feeds any bytes to the FlexNC lathe control. Nothing may crash, hang or send a motion that is not finite.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/checking_sink.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const proveout::MemoryProgramSource source("main.nc",
                                             std::string(reinterpret_cast<const char*>(data), size));
  proveout::ControlSettings settings;
  settings.block_limit = 500;
  settings.max_errors = 20;
  settings.rapid_by_default = size % 2 == 0;
  settings.radius_offsets[2] = {0.1, -0.05};
  settings.parameters = {{"RT.1", 0.8}, {"TIP.1", 3.0}, {"DXW.2", 1.5}, {"DZW.2", -3.0}, {"RT.2", 2.0}};
  if (size % 3 == 0)
    settings.parameters.insert({{"raw_x", 1}, {"arc_view", 1}, {"g52_mode", 1}, {"ring_edge", 1}});
  if (size % 5 == 0) settings.parameters.insert({{"comp_view", 1}, {"MAX_SPEED", 3000}});
  proveout::CheckingSink sink;
  proveout::interpret(proveout::ControlId::kFlexNc, source, settings, sink);
  return 0;
}
