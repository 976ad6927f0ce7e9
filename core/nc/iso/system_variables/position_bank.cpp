#include "core/nc/iso/system_variables/position_bank.h"

#include <array>

#include "core/nc/iso/context/words.h"
#include "core/nc/iso/system_variables/units.h"

namespace proveout::nc {
namespace {

enum class Reading {
  kBlockEnd,     ///< programmed
  kMachine,      ///< with all compensations
  kPresent,      ///< work coordinates, with all compensations
  kSkip,         ///< the same where a measuring move stopped
  kSkipOther,    ///< the same in the system that N1755.PCS does not choose
  kSkipMachine,  ///< machine coordinates
  kLength,       ///< length offset in force
  kNothing,      ///< always 0 here: lag of the servos, shift of the handwheel, distance to go
};
struct Row {
  int low;  ///< number of axis 0, or -1
  int high;
  Reading reading;
  const char* name;  ///< or null
  bool only_nct = false;
};
constexpr auto kRows = std::to_array<Row>({
    {5000, 100000, Reading::kBlockEnd, "ABSIO"},
    {5020, 100050, Reading::kMachine, "ABSMT"},
    {5040, 100100, Reading::kPresent, "ABSOT"},
    {5060, 100150, Reading::kSkip, "ABSKP"},
    {5080, 100200, Reading::kLength, "TOFS"},
    {5100, 100250, Reading::kNothing, "SVERR"},
    {-1, 100650, Reading::kNothing, "MIRTP", true},
    {5180, 100800, Reading::kNothing, "DIST"},
    {-1, 151000, Reading::kSkipOther, nullptr, true},
    {-1, 151100, Reading::kSkipMachine, nullptr, true},
});

/// Coordinates without (`tip`) or with the length offset, of the tilted plane that is programmed in or of the
/// workpiece (manual 25.19).
struct Shown {
  bool tip = false, tilted = false;
};
CoordinateChain chainOf(const IsoContext& c, const Shown& shown) {
  IsoState state = c.state;
  if (!shown.tip) {
    state.length = AxisPoint();
    state.five.along_tool = false;
  }
  if (!shown.tilted) {
    state.five.tilt = FrameStep();
    state.five.tilted = false;
    state.five.rotations = 0;
  }
  return c.chainOf(state);
}

AxisPoint standing(const IsoContext& c) {
  return c.state.compOn() || c.stages.virtual_plane.linked() ? c.standing() : c.machine;
}

/// Where the machine is, in program coordinates; during G12.1 and G7.1 those of the plane.
AxisPoint present(const IsoContext& c, const Shown& shown) {
  const AxisPoint machine = standing(c);
  return chainOf(c, shown).programOf(c.stages.virtual_plane.linked() ? c.stages.virtual_plane.shown(machine)
                                                                     : machine);
}

/// The length offset on the axes, the one along the tool (G43.1, G43.4, G43.5) with what heads add to it.
AxisPoint lengthInForce(const IsoContext& c) {
  AxisPoint length = c.state.length;
  if (!c.state.five.along_tool) return length;
  const AxisPoint without =
      chainOf(c, {false, true}).machineOf(chainOf(c, {true, true}).programOf(c.machine));
  length.xyz = c.machine.xyz - without.xyz;
  return length;
}

/// What one unit of a value tells. In the plane of G12.1 and G7.1 the rotary axis counts as its words do.
double unitOfReading(const IsoContext& c, Reading reading, int axis) {
  const AxisModal& modal = c.state.axes;
  const bool programmed = reading == Reading::kBlockEnd || reading == Reading::kPresent;
  if (!programmed || modal.mode == VirtualMode::kOff || axis != modal.rotary) return unitOf(c, axis);
  return modal.mode == VirtualMode::kPolar ? c.state.unitScale() : modal.mmPerDegree();
}

AxisPoint pointOf(const IsoContext& c, Reading reading, bool probe_tip) {
  const bool tip = (probe_tip && reading == Reading::kSkip) || c.parameters.flag(DataParam::kTipPositions),
             tilted = c.parameters.flag(DataParam::kProgramCoordinates);
  const SkipPosition& skip = c.registers.skip;
  switch (reading) {
    case Reading::kBlockEnd:
      return c.position;
    case Reading::kMachine:  // of the machine's own axes during G12.1 and G7.1 too
      return c.state.axes.mode == VirtualMode::kOff ? standing(c) : c.stages.virtual_plane.machine();
    case Reading::kPresent:
      return present(c, {tip, tilted});
    case Reading::kSkip:
      return skip.at[tilted ? 1 : 0][tip ? 1 : 0];
    case Reading::kSkipOther:
      return skip.at[tilted ? 0 : 1][tip ? 1 : 0];
    case Reading::kSkipMachine:
      return tip ? skip.machine_tip : skip.machine;
    case Reading::kLength:
      return lengthInForce(c);
    case Reading::kNothing:
      break;
  }
  return {};
}

}  // namespace

void recordSkip(IsoContext& c, const AxisPoint& machine) {
  SkipPosition& skip = c.registers.skip;
  skip.machine = machine;
  // The tip's coordinates with the length taken away: on machine axes, and along the tool too.
  skip.machine_tip = chainOf(c, {false, true}).machineOf(chainOf(c, {true, true}).programOf(machine));
  for (const bool tilted : {false, true}) {
    for (const bool tip : {false, true})
      skip.at[tilted ? 1 : 0][tip ? 1 : 0] = chainOf(c, {tip, tilted}).programOf(machine);
  }
}

void PositionBank::addTo(VariableStore& store) {
  for (const Row& row : kRows) {
    if (row.only_nct && !rules_.nct_numbers) continue;
    if (row.low >= 0) store.addBank(row.low + 1, row.low + kLowAxes, *this);
    store.addBank(row.high + 1, row.high + kHighAxes, *this);
    if (row.name) store.addSymbol({row.name, row.high + 1, 1, kHighAxes});
  }
}

VariableStatus PositionBank::read(int number, Value& out) {
  for (const Row& row : kRows) {
    const bool low = row.low >= 0 && number > row.low && number <= row.low + kLowAxes;
    if (!low && (number <= row.high || number > row.high + kHighAxes)) continue;
    const int axis = c_.axes.byNumber(number - (low ? row.low : row.high));
    if (axis < 0) return VariableStatus::kUnknown;
    const double value = pointOf(c_, row.reading, rules_.probe_tip)[axis];
    const double shown = row.reading == Reading::kLength ? value : shownPosition(c_, axis, value);
    out = {shown / unitOfReading(c_, row.reading, axis)};
    const bool programmed = row.reading == Reading::kBlockEnd || row.reading == Reading::kPresent;
    if (programmed) out.origin = c_.origins.wordOf(axisKind(c_.axes.at(axis).name));
    return VariableStatus::kDone;
  }
  return VariableStatus::kUnknown;
}

}  // namespace proveout::nc
