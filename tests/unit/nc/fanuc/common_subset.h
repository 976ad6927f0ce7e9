// Random programs of what Fanuc-like mills and LinuxCNC have in common, each in both writings.
#pragma once

#include <string>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {

struct CommonProgram {
  std::string fanuc, linuxcnc;
};
/// By its number: motions and arcs in all planes, both units, frames, shifts, lengths, cycles, formulas. The
/// same on every machine.
CommonProgram commonProgram(unsigned number);

/// Tool 1 is 50 mm long, straight rapids, pecks return by LinuxCNC's 0.254 mm; the tool starts at (0, 0, 0).
ControlSettings commonSettings(ControlId control);

}  // namespace proveout::test
