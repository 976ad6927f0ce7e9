// Settings of LinuxCNC and its kin: `[control.linuxcnc]` of a job.
#pragma once

#include <cstdint>

#include "core/nc/iso/parameters/parameter_table.h"

namespace proveout::nc {

/// Settings that only this control has.
enum class LinuxCncParam : std::uint16_t {
  kFlavour,           ///< 0 LinuxCNC, 1 GRBL, 2 Mach3, 3 PathPilot, 4 Smoothie, 5 grblHAL
  kUnits,             ///< of the machine: 0 mm, 1 inch
  kLathe,             ///< starts in G18 G8
  kDwellUnit,         ///< of P of G4 in Mach3: 0 s, 1 ms
  kArcCentre,         ///< of Mach3: 0 incremental, 1 absolute
  kArcTolerance,      ///< mm; times the root of 2: what the radii of an arc may differ by
  kArcToleranceInch,  ///< inch; the same in programs that count in inches
  kCount
};
constexpr ParamId paramId(LinuxCncParam p) { return {ParamChapter::kOwn, static_cast<std::uint16_t>(p)}; }

const ParameterTable& linuxCncParameters();

}  // namespace proveout::nc
