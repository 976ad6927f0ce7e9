// Feeds any bytes to the wire EDM control. Nothing may crash, hang or send a motion that is not finite.
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
  settings.parameters = {{"H.1", 0.1}, {"H.2", -0.5}, {"T", 20}, {"MAX_TILT", size % 2 == 0 ? 0.0 : 30.0}};
  if (size % 3 == 0) settings.parameters.insert({{"ZM", 20}, {"ZS", 0}, {"UV_UPPER", 1}, {"TAPER_ARC", 1}});
  proveout::CheckingSink sink;
  proveout::interpret(proveout::ControlId::kWedm, source, settings, sink);
  return 0;
}
