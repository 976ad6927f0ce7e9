#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"

#include "core/nc/iso/parameters/cycles.h"
#include "core/nc/iso/parameters/parameter_rows.h"

namespace proveout::nc {

const ParameterTable& linuxCncParameters() {
  using namespace param_rows;
  constexpr double kPeckRise = 0.254;  // 0.010 inch, of the interpreter
  static const ParameterTable kTable = [] {
    ParameterTable table("linuxcnc", static_cast<std::size_t>(LinuxCncParam::kCount));
    table
        .add(LinuxCncParam::kFlavour,
             choice("flavour", kNoNumber, 0, "linuxcnc grbl mach3 pathpilot smoothie grblhal",
                    "whose rows hold"))
        .add(LinuxCncParam::kUnits,
             choice("units", kNoNumber, 0, "mm inch", "of the machine: tool table, parameters 5161 to 5390"))
        .add(LinuxCncParam::kLathe, bit("lathe", kNoNumber, kNamedBit, kChannel, 0, "starts in G18 and G8"))
        .add(LinuxCncParam::kDwellUnit, choice("dwell_unit", kNoNumber, 0, "s ms", "of P of G4 in Mach3"))
        .add(LinuxCncParam::kArcCentre,
             choice("arc_centre", kNoNumber, 0, "incremental absolute", "what I, J, K count from in Mach3"))
        .add(LinuxCncParam::kArcTolerance,
             number("arc_tolerance", kNoNumber, kChannel, 0.02, 0.0, 10.0,
                    "mm, CENTER_ARC_RADIUS_TOLERANCE: times the root of 2 the radii of an arc may differ"))
        .add(LinuxCncParam::kArcToleranceInch,
             number("arc_tolerance_inch", kNoNumber, kChannel, 0.002, 0.0, 0.4,
                    "inch, CENTER_ARC_RADIUS_TOLERANCE_INCH: the same in G20"))
        .fix(CycleParam::kChipBreakReturn, kPeckRise)
        .fix(CycleParam::kPeckClearance, kPeckRise);
    return table;
  }();
  return kTable;
}

}  // namespace proveout::nc
