// Feeds any bytes to LinuxCNC and its kin, with a file of a subroutine cut out of the same bytes. Nothing may
// crash, hang or send a motion that is not finite. The length chooses the flavour and the settings.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/checking_sink.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace proveout;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = bytes.find('~');
  MemoryProgramSource source("main.ngc", bytes.substr(0, cut));
  if (cut != std::string::npos) source.add("sub.ngc", bytes.substr(cut + 1));
  ControlSettings settings;
  settings.block_limit = 400;
  settings.max_errors = 20;
  settings.tool = size % 5 == 0 ? 1 : 0;
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.radius_offsets[2] = {0.4, 0.0};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.work_offsets[1] = Vec3(100, 20, -3);
  settings.limits[0] = AxisLimit{-500, 500};
  for (const ParameterInfo& p : parameterTable(ControlId::kLinuxCnc)) {
    const bool flavour = p.name == "flavour";
    if (flavour && size % 3 == 0) settings.parameters["flavour"] = static_cast<double>(size / 3 % 6);
    if (!flavour && p.count == 0 && (size + p.name.size()) % 4 == 0)
      settings.parameters[std::string(p.name)] = size % 2 == 0 ? p.max : p.min;
  }
  CheckingSink sink;
  interpret(ControlId::kLinuxCnc, source, settings, sink);
  return 0;
}
