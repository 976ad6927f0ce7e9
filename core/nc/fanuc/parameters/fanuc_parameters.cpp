#include "core/nc/fanuc/parameters/fanuc_parameters.h"

#include "core/nc/iso/parameters/cycles.h"
#include "core/nc/iso/parameters/motion.h"
#include "core/nc/iso/parameters/parameter_rows.h"

namespace proveout::nc {

const ParameterTable& fanucParameters() {
  using namespace param_rows;
  static const ParameterTable kTable = [] {
    ParameterTable table("fanuc", static_cast<std::size_t>(FanucParam::kCount));
    table.add(FanucParam::kFlavour, choice("flavour", kNoNumber, 0, "fanuc haas", "whose rows hold"))
        .add(FanucParam::kDecimal, choice("decimal", 3401, 0, "calculator increment",
                                          "words without a point: 50 is 50 mm, or 0.050 mm"))
        .add(MotionParam::kDefaultG20,
             choice("power_on_units", 3402, 0, "mm inch", "unit where the program does not say"))
        .add(MotionParam::kRadiusDifference,
             number("arc_radius_tolerance", 3410, kChannel, 0.01, 0, 1e3,
                    "difference of start and end radius that an arc may have, mm; 0: not checked"))
        .add(CycleParam::kChipBreakReturn,
             number("g73_retract", 5114, kChannel, 0.5, 0, 1e3, "rise between the pecks of G73, mm"))
        .add(CycleParam::kPeckClearance, number("g83_clearance", 5115, kChannel, 0.5, 0, 1e3,
                                                "rapid ends so far above the last depth, mm"))
        .add(FanucParam::kRigidAlways,
             choice("g84_rigid", 5200, 0, "M29 always", "whether G84 and G74 are rigid behind M29 only"))
        .add(FanucParam::kRigidPeck,
             choice("rigid_peck", 5200, 0, "fast full", "pecks of rigid taps: a little back, or out to R"))
        .add(CycleParam::kRigidChipBreakReturn, number("rigid_retract", 5213, kChannel, 0.5, 0, 1e3,
                                                       "way back between the pecks of rigid taps, mm"))
        .add(FanucParam::kBoreShift,
             choice("g76_shift", 5101, 0, "+X -X +Y -Y", "direction of Q of G76 and G87, as in G17"))
        .add(FanucParam::kLocalShift, choice("setting_33", kNoNumber, 0, "fanuc yasnac",
                                             "Haas: G52 shifts every work system, or is one of its own"));
    addMacroRows(table);
    return table;
  }();
  return kTable;
}

}  // namespace proveout::nc
