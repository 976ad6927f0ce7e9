// Settings of Fanuc-like controls: `[control.fanuc]` of a job, numbers are Fanuc's parameters.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/nc/iso/parameters/parameter_table.h"

namespace proveout::nc {

/// Settings that only these controls have. Those of the shared rules are in iso/parameters.
enum class FanucParam : std::uint16_t {
  kFlavour,           ///< 0 Fanuc, 1 Haas
  kDecimal,           ///< 3401#0 DPI: 0 a number without a point counts in units, 1 in least increments
  kRigidAlways,       ///< 5200#0: G84 and G74 are rigid without M29
  kRigidPeck,         ///< 5200#5 PCP: 0 pecks of rigid taps go back a little, 1 out to R
  kBoreShift,         ///< 5101#4,5: direction of Q of G76 and G87: +u -u +v -v of the plane
  kSetting9,          ///< of Haas: power-on unit, 0 mm, 1 inch
  kLocalShift,        ///< Setting 33 of Haas: 0 G52 shifts every system, 1 it is a system of its own
  kSubprogramForm,    ///< 0 the last four digits of P are the number, 1 all are
  kAtanRange,         ///< 6004#0 NAT: 360 or 180
  kV15,               ///< 6000#3
  kUnknownVariables,  ///< 0 errors, 1 vacant
  kRapid,             ///< 1401#1 LRP: 0 each axis at its own rate, 1 straight
  kPowerOnPlane,      ///< 17, 18, 19; 0: 17 of mills, 18 of lathes
  kStrictM,           ///< 1: M functions that nobody knows are errors
  kOverrun,           ///< of axes: 5440, mm or deg, signed
  kPark,              ///< of axes: machine coordinate, mm or deg
  kKeepG52,
  kKeepG92,  ///< 1: the shift of G52, G92 stays at the end of a program
  // Lathes, parameters/lathe_rows.cpp.
  kGcodeSystem,  ///< 3401#6,7: 0 A, 1 B, 2 C
  kLatheT,       ///< 0 four digits, 1 two
  kGeometryBy,   ///< 5002#1 LGN: 0 by the number of the offset, 1 by that of the tool
  kOffsetX,      ///< by offset number, 1 to 32, like those that follow
  kOffsetZ,
  kWearX,
  kWearZ,
  kNoseRadius,
  kTip,
  kG71Depth,
  kG71Escape,
  kG71Levels,
  kG73X,
  kG73Z,
  kG73Passes,
  kG74Return,
  kThreadChamfer,
  kThreadChamferAngle,
  kG76Min,
  kG76Finish,
  kG76Repeat,
  kG76Angle,
  kPeckToR,  ///< 5101#2 RTR
  kLiveCw,   ///< M codes of live tools, like those that follow; 0: none
  kLiveCcw,
  kLiveStop,
  kAxisOn,  ///< the main spindle is the C axis
  kAxisOff,
  kWearMoves,        ///< 5002#6 LWM: 0 with the next motion of the axis, 1 with the block of T
  kOffsetMemory,     ///< 0 A one table, 1 B geometry and wear, 2 C with H and D apart
  kDiameterOffsets,  ///< 5004#2 ODI: D holds 0 radii, 1 diameters
  kDefaultD,         ///< a D without a row is 0 the tool's own radius, 1 nothing
  kLengthType,       ///< 5001#0 TLC, #1 TLB: 0 A on Z, 1 B across the plane, 2 C on the axis named
  kCompStartUp,      ///< 5003#0 SUP, #1 SUV: 0 A, 1 B, 2 C
  kRotationAdds,     ///< 5400#0 RIN: R of G68 under G91 adds
  kScaleUnit,        ///< 5400#7 SCR: factors of G51 without a point count in it
  kCount
};
inline constexpr double kHaasFlavour = 1.0;  ///< FanucParam::kFlavour
constexpr ParamId paramId(FanucParam p) { return {ParamChapter::kOwn, static_cast<std::uint16_t>(p)}; }

const ParameterTable& fanucParameters();
/// A setting of the job, before there is a channel to ask: its value, or the default.
double fanucSetting(const std::map<std::string, double>& settings, FanucParam p);
/// Adds the rows of calls and of the macro language.
void addMacroRows(ParameterTable& table);
/// Adds the rows of lathes.
void addLatheRows(ParameterTable& table);

}  // namespace proveout::nc
