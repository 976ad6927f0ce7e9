// Feeds any bytes to the nct control as a main program, with subprograms cut out of the same bytes. Nothing
// may crash, hang or send a motion that is not finite.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/checking_sink.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::size_t cut = bytes.find('~');
  proveout::MemoryProgramSource source("main.nc", bytes.substr(0, cut));
  for (const char* name : {"O0011.nc", "O0012.nc", "SystemMacros/Channel1/O9010.nct",
                           "SystemMacros/Channel1/O9000.nct", "SystemMacros/Channel1/O9034.nct"}) {
    if (cut == std::string::npos) break;
    const std::size_t end = bytes.find('~', cut + 1);
    source.add(name, bytes.substr(cut + 1, end == std::string::npos ? end : end - cut - 1));
    cut = end;
  }
  proveout::ControlSettings settings;
  settings.parameters = {{"N1704", size % 3 == 0 ? -101.0 : 101.0},
                         {"N1720", 50.0},
                         {"N1746.TM", 1.0},
                         {"N1755.MEQ", size % 2 == 0 ? 1.0 : 0.0},
                         {"N1755.ENC", size % 5 == 0 ? 1.0 : 0.0},
                         {"N1758.USD", 1.0}};
  settings.interrupt_blocks = {10};
  settings.block_limit = 300;
  settings.max_errors = 20;
  settings.lenient = size % 2 == 0;
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.radius_offsets[2] = {-2.0, 0.1};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.work_offsets[1] = proveout::Vec3(100, 20, -3);
  settings.work_rotations_deg[2] = proveout::Vec3(10, 20, 30);
  settings.limits[0] = proveout::AxisLimit{-500, 500};
  proveout::CheckingSink sink;
  proveout::interpret(proveout::ControlId::kNct, source, settings, sink);
  return 0;
}
