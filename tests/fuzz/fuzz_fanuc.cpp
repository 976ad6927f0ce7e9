// Feeds any bytes to the Fanuc-like controls, as a mill or a lathe, of Fanuc or of Haas, with a file of
// subprograms cut out of the same bytes. Nothing may crash, hang or send a motion that is not finite. The
// length chooses the machine and its settings.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/checking_sink.h"

namespace {

using namespace proveout;

/// Settings by words are numbers here: 0 is the default.
void giveSettings(ControlSettings& settings, ControlId control, std::size_t which) {
  std::size_t left = which;
  for (const ParameterInfo& p : parameterTable(control)) {
    const bool chosen = left % 3 == 1;
    left = left / 3 + (left % 3) * 1000003 + 7;
    if (chosen && p.count == 0) settings.parameters[std::string(p.name)] = left % 2 == 0 ? p.max : p.min;
  }
  settings.parameters["flavour"] = which % 2 == 0 ? 0.0 : 1.0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = bytes.find('~');
  MemoryProgramSource source("main.nc", bytes.substr(0, cut));
  if (cut != std::string::npos) source.add("O0012.nc", bytes.substr(cut + 1));
  const ControlId control = size % 3 == 0 ? ControlId::kFanucLathe : ControlId::kFanucMill;
  ControlSettings settings;
  settings.block_limit = 400;
  settings.max_errors = 20;
  settings.lenient = size % 5 == 0;
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.radius_offsets[2] = {-2.0, 0.1};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.work_offsets[1] = Vec3(100, 20, -3);
  if (size % 7 == 0) settings.reference_points[0] = Vec3(400, 300, 500);
  settings.limits[0] = AxisLimit{-500, 500};
  if (size % 4 != 0) giveSettings(settings, control, size + (bytes.empty() ? 0U : data[size - 1]));
  CheckingSink sink;
  interpret(control, source, settings, sink);
  return 0;
}
