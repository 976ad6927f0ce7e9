// Feeds any bytes to the WL4 control, as a mill or a lathe. Nothing may crash, hang or send a motion that is
// not finite.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/checking_sink.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = bytes.find('~');
  proveout::MemoryProgramSource source("main.nc", bytes.substr(0, cut));
  if (cut != std::string::npos) source.add("81.nc", bytes.substr(cut + 1));
  proveout::ControlSettings settings;
  settings.block_limit = 500;
  settings.max_errors = 20;
  settings.radius_offsets[1] = {2.0, 0.0};
  settings.radius_offsets[2] = {-1.0, 0.1};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.work_offsets[1] = proveout::Vec3(100, 20, -3);
  settings.parameters = {{"CONDITIONAL", size % 2 == 0 ? 1.0 : 0.0}, {"DELT_L", 0.01}};
  const bool lathe = size % 3 != 0;
  if (lathe)
    settings.parameters.insert({{"RT.1", 0.8}, {"TIP.1", 3.0}, {"G18_ZX", size % 5 == 0 ? 1.0 : 0.0}});
  proveout::CheckingSink sink;
  proveout::interpret(lathe ? proveout::ControlId::kWl4Lathe : proveout::ControlId::kWl4Mill, source,
                      settings, sink);
  return 0;
}
