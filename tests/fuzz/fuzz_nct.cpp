// Feeds any bytes to the nct control as a main program, with subprograms cut out of the same bytes. Nothing
// may crash, hang or send a motion that is not finite. Last byte and length choose the machine.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/checking_sink.h"
#include "tests/support/test_machines.h"

namespace {

using namespace proveout;

/// One of the machines of the manual's chapter 25, or none: three axes alone.
void giveMachine(ControlSettings& settings, std::size_t which) {
  if (which % 5 == 0) return;
  const MachineModel machines[] = {test::machineCB(), test::machineCA(), test::trunnion('A'),
                                   test::headTable()};
  const MachineModel& machine = machines[which % 5 - 1];
  for (std::size_t k = 3; k < machine.axes.size(); ++k) {
    AxisSettings axis;
    axis.name = machine.axes[k].name;
    axis.number = static_cast<int>(k) + 1;
    axis.kind = AxisKind::kRotary;
    axis.carries = RotaryCarries::kNothing;
    if (which % 3 == 0) axis.limit = AxisLimit{-110, 110};
    settings.axes.push_back(axis);
  }
  settings.gauge_lengths[1] = 50.0;
  settings.machine = machine;
  settings.work_offsets[0] = Vec3(400, 300, -420);
  settings.parameters["N3212.FOS"] = which % 2 == 0 ? 1.0 : 0.0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::size_t cut = bytes.find('~');
  MemoryProgramSource source("main.nc", bytes.substr(0, cut));
  for (const char* name : {"O0011.nc", "O0012.nc", "SystemMacros/Channel1/O9010.nct",
                           "SystemMacros/Channel1/O9000.nct", "SystemMacros/Channel1/O9034.nct"}) {
    if (cut == std::string::npos) break;
    const std::size_t end = bytes.find('~', cut + 1);
    source.add(name, bytes.substr(cut + 1, end == std::string::npos ? end : end - cut - 1));
    cut = end;
  }
  ControlSettings settings;
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
  settings.work_offsets[1] = Vec3(100, 20, -3);
  settings.work_rotations_deg[2] = Vec3(10, 20, 30);
  giveMachine(settings, bytes.empty() ? 0 : static_cast<unsigned char>(bytes.back()) + size);
  settings.limits[0] = AxisLimit{-500, 500};
  CheckingSink sink;
  interpret(ControlId::kNct, source, settings, sink);
  return 0;
}
