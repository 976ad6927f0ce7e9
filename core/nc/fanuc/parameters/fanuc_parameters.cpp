#include "core/nc/fanuc/parameters/fanuc_parameters.h"

#include "core/nc/iso/parameters/cycles.h"
#include "core/nc/iso/parameters/feeds.h"
#include "core/nc/iso/parameters/motion.h"
#include "core/nc/iso/parameters/parameter_rows.h"

namespace proveout::nc {
namespace {

/// Offsets, compensation, transforms (iso-fanuc, sections 6 to 9).
void addOffsetRows(ParameterTable& table) {
  using namespace param_rows;
  table
      .add(FanucParam::kOffsetMemory,
           choice("offset_memory", kNoNumber, 2, "A B C",
                  "A one table, B geometry and wear, C geometry and wear with H and D apart"))
      .add(FanucParam::kDiameterOffsets,
           atBit(choice("d_is", 5004, 0, "radius diameter",
                        "what D holds for the program (G10, variables); the job's rows are radii"),
                 2))
      .add(FanucParam::kDefaultD,
           choice("d_default", kNoNumber, 0, "tool zero", "what a D without a row in the job stands for"))
      .add(FanucParam::kLengthType,
           choice("length_type", kNoNumber, 0, "A B C",
                  "axis of G43: A always Z, B across the plane, C the axis beside the code (5001#0, #1)"))
      .add(FanucParam::kCompStartUp,
           choice("comp_startup", kNoNumber, 0, "A B C",
                  "start-up of cutter compensation (5003#0, #1): A square, B by the corner, C at once"))
      .add(FanucParam::kRotationAdds,
           bit("g68_r_incremental", 5400, 0, kChannel, 0, "R of G68 under G91 adds to the angle before"))
      .add(FanucParam::kScaleUnit, number("scale_unit", kNoNumber, kChannel, 0.001, 0.00001, 0.001,
                                          "factors of G51 without a point count in it (5400#7)"))
      .fix(FeedParam::kInsideArcLeast, 1);  // F is of the tool centre
}

}  // namespace

const ParameterTable& fanucParameters() {
  using namespace param_rows;
  static const ParameterTable kTable = [] {
    ParameterTable table("fanuc", static_cast<std::size_t>(FanucParam::kCount));
    table.add(FanucParam::kFlavour, choice("flavour", kNoNumber, 0, "fanuc haas", "whose rows hold"))
        .add(FanucParam::kDecimal, atBit(choice("decimal", 3401, 0, "calculator increment",
                                                "words without a point: 50 is 50 mm, or 0.050 mm"),
                                         0))
        .add(MotionParam::kDefaultG20,
             choice("power_on_units", kNoNumber, 0, "mm inch", "unit where the program does not say"))
        .add(FanucParam::kPowerOnPlane, number("power_on_plane", kNoNumber, kChannel, 0, 0, 19,
                                               "plane where the program does not say: 17, 18 or 19 (3402#1, "
                                               "#2); 0: 17 of mills, 18 of lathes"))
        .add(MotionParam::kDefaultG1,
             atBit(choice("power_on_motion", 3402, 0, "G0 G1", "motion where the program does not say"), 0))
        .add(MotionParam::kDefaultG91, atBit(choice("power_on_distance", 3402, 0, "G90 G91",
                                                    "coordinates where the program does not say"),
                                             3))
        .add(FanucParam::kRapid,
             atBit(choice("rapid", 1401, 0, "dogleg linear", "each axis at its own rate, or a straight way"),
                   1))
        .add(FanucParam::kStrictM,
             number("strict_m", kNoNumber, kChannel, 0, 0, 1, "M functions that nobody knows are errors"))
        .add(FanucParam::kOverrun,
             number("g60_overrun", 5440, kAxis, 0, -1e3, 1e3, "overrun of G60, signed, mm or degrees"))
        .add(FanucParam::kPark, number("park", kNoNumber, kAxis, 0, -1e6, 1e6,
                                       "where an axis goes by G28, G30, G53 if nothing tells machine zero, "
                                       "machine coordinates; not given: it stays"))
        .add(FanucParam::kKeepG52,
             atBit(choice("g52_at_end", 1202, 0, "clear keep", "shift of G52 at the end"), 3))
        .add(FanucParam::kKeepG92,
             choice("g92_at_end", kNoNumber, 1, "clear keep", "shift of G92 at the end"))
        .add(MotionParam::kRadiusDifference,
             number("arc_radius_tolerance", 3410, kChannel, 0.01, 0, 1e3,
                    "difference of start and end radius that an arc may have, mm; 0: not checked"))
        .add(CycleParam::kChipBreakReturn,
             number("g73_retract", 5114, kChannel, 0.5, 0, 1e3, "rise between the pecks of G73, mm"))
        .add(CycleParam::kPeckClearance, number("g83_clearance", 5115, kChannel, 0.5, 0, 1e3,
                                                "rapid ends so far above the last depth, mm"))
        .add(FanucParam::kRigidAlways, atBit(choice("g84_rigid", 5200, 0, "M29 always",
                                                    "whether G84 and G74 are rigid behind M29 only"),
                                             0))
        .add(FanucParam::kRigidPeck, atBit(choice("rigid_peck", 5200, 0, "fast full",
                                                  "pecks of rigid taps: a little back, or out to R"),
                                           5))
        .add(CycleParam::kRigidChipBreakReturn, number("rigid_retract", 5213, kChannel, 0.5, 0, 1e3,
                                                       "way back between the pecks of rigid taps, mm"))
        .add(FanucParam::kBoreShift, choice("g76_shift", kNoNumber, 0, "+X -X +Y -Y",
                                            "direction of Q of G76 and G87, as in G17 (5101#4, #5)"))
        .add(FanucParam::kSetting9,
             atPowerOn(choice("setting_9", kNoNumber, 0, "mm inch",
                              "Haas: unit where neither the program nor power_on_units "
                              "says it")))
        .add(FanucParam::kLocalShift, choice("setting_33", kNoNumber, 0, "fanuc yasnac",
                                             "Haas: G52 shifts every work system, or is one of its own"));
    addMacroRows(table);
    addLatheRows(table);
    addOffsetRows(table);
    return table;
  }();
  return kTable;
}

double fanucSetting(const std::map<std::string, double>& settings, FanucParam p) {
  const ParamInfo& row = fanucParameters().row(p);
  const auto given = settings.find(std::string(row.name));
  return given == settings.end() ? row.default_value : given->second;
}

}  // namespace proveout::nc
