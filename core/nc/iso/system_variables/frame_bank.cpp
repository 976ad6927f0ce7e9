#include "core/nc/iso/system_variables/frame_bank.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/system_variables/units.h"

namespace proveout::nc {
namespace {

constexpr int kBasicLow = 5201, kBasicHigh = 100301;        // common, G54 to G59
constexpr int kExtendedLow = 7001, kExtendedHigh = 101001;  // G54.1 P1...
constexpr int kBasicSystems = 7, kLowExtended = 48, kHighExtended = 99;
constexpr int kRotations = 120001, kRotationStep = 10, kRotatedBasic = 6;
constexpr int kRotationLast = kRotations + (kRotatedBasic + kHighExtended - 1) * kRotationStep + 2;
// Dynamic offsets: active number, active value, then the tables.
constexpr int kDynamicLow = 5500, kDynamicHigh = 117000;

constexpr auto kNctFrames = std::to_array<FrameNumbers>({
    {kBasicLow, kBasicSystems, kLowAxes, kLowAxes, 1, 0},
    {kBasicHigh, kBasicSystems, kHighAxes, kHighAxes, 1, 0},
    {kExtendedLow, kLowExtended, kLowAxes, kLowAxes, 1, kFirstExtended},
    {kExtendedHigh, kHighExtended, kHighAxes, kHighAxes, 1, kFirstExtended},
});

}  // namespace

FrameNumbering nctFrames() { return {kNctFrames}; }

void FrameBank::addTo(VariableStore& store) {
  for (const FrameNumbers& row : numbering_.offsets) {
    if (row.axis_step == 1) {
      store.addBank(row.first, row.first + row.systems * row.system_step - 1, *this);
      continue;
    }
    for (int axis = 0; axis < row.axes; ++axis) {
      const int first = row.first + axis * row.axis_step;
      store.addBank(first, first + row.systems * row.system_step - 1, *this);
    }
  }
  if (!numbering_.names) return;
  store.addBank(kRotations, kRotationLast, *this);
  store.addBank(kDynamicLow, kDynamicLow + (kDynamicSystems + 1) * kLowAxes, *this);
  store.addBank(kDynamicHigh, kDynamicHigh + (kDynamicSystems + 1) * kHighAxes, *this);
  store.addSymbol({"WZCMN", kBasicHigh, 1, kHighAxes});
  for (int k = 0; k < kRotatedBasic; ++k) {
    store.addSymbol({fmt::format("WZG{}", 54 + k), kBasicHigh + (k + 1) * kHighAxes, 1, kHighAxes});
    store.addSymbol({fmt::format("WRG{}", 54 + k), kRotations + k * kRotationStep, 1, 3});
  }
  for (int p = 1; p <= kHighExtended; ++p) {
    store.addSymbol({fmt::format("WZP{}", p), kExtendedHigh + (p - 1) * kHighAxes, 1, kHighAxes});
    store.addSymbol({fmt::format("WRP{}", p), kRotations + (kRotatedBasic + p - 1) * kRotationStep, 1, 3});
  }
  store.addSymbol({"FOFSP", kDynamicHigh});
  store.addSymbol({"FOFSVAL", kDynamicHigh + 1, 1, kHighAxes});
  for (int p = 1; p <= kDynamicSystems; ++p) {
    store.addSymbol({fmt::format("FOFS{}", p), kDynamicHigh + 1 + p * kHighAxes, 1, kHighAxes});
  }
}

bool FrameBank::axisOf(int number, Cell& cell) const {
  cell.axis = c_.axes.byNumber(number);
  return cell.axis >= 0;
}

FrameBank::Cell FrameBank::offsetCell(int number) const {
  Cell cell;
  for (const FrameNumbers& row : numbering_.offsets) {
    const int at = number - row.first;
    const int size = row.axis_step == 1 ? row.systems * row.system_step : row.axes * row.axis_step;
    if (at < 0 || at >= size) continue;
    const bool by_axis = row.axis_step != 1;
    const int axis = by_axis ? at / row.axis_step : at % row.system_step;
    const int system = by_axis ? at % row.axis_step : at / row.system_step;
    if (system >= row.systems || axis >= row.axes) continue;
    cell.system = row.first_system + system;
    if (axisOf(axis + 1, cell)) cell.kind = Cell::Kind::kOffset;
    break;
  }
  return cell;
}

FrameBank::Cell FrameBank::dynamicCell(int number) const {
  const bool high = number >= kDynamicHigh;
  const int axes = high ? kHighAxes : kLowAxes;
  const int offset = number - (high ? kDynamicHigh : kDynamicLow);
  Cell cell;
  if (offset == 0) {
    cell.kind = Cell::Kind::kDynamicInForce;
    return cell;
  }
  cell.system = (offset - 1) / axes - 1;
  if (axisOf((offset - 1) % axes + 1, cell)) {
    cell.kind = cell.system < 0 ? Cell::Kind::kDynamicNow : Cell::Kind::kDynamic;
  }
  return cell;
}

namespace {

/// The zero of G54.2 in force, turned with the tables, machine coordinates; 0 while it is off.
AxisPoint dynamicZeroNow(const IsoContext& c) {
  const int p = c.state.five.dynamic_zero;
  if (p == 0) return {};
  AxisPoint now = c.registers.dynamic_zeros[static_cast<std::size_t>(p - 1)];
  now.xyz = c.five_axes.dynamicZero(c.five_axes.at(c.machine), now.xyz, c.five_axes.at(now));
  return now;
}

}  // namespace

FrameBank::Cell FrameBank::find(int number) const {
  if (!numbering_.names) return offsetCell(number);
  if (number >= kRotations) {
    Cell cell;
    const int row = (number - kRotations) / kRotationStep, plane = (number - kRotations) % kRotationStep;
    cell.system = row < kRotatedBasic ? row + 1 : kFirstExtended + row - kRotatedBasic;
    cell.axis = 2 - plane;  // 1 turns in XY about Z, 2 in ZX about Y, 3 in YZ about X
    cell.kind = plane < 3 ? Cell::Kind::kRotation : Cell::Kind::kNone;
    return cell;
  }
  const bool dynamic = number >= kDynamicHigh ||
                       (number >= kDynamicLow && number <= kDynamicLow + (kDynamicSystems + 1) * kLowAxes);
  return dynamic ? dynamicCell(number) : offsetCell(number);
}

VariableStatus FrameBank::read(int number, Value& out) {
  const Cell cell = find(number);
  const WorkFrames& frames = c_.registers.frames;
  out = {};
  switch (cell.kind) {
    case Cell::Kind::kNone:
      return VariableStatus::kUnknown;
    case Cell::Kind::kDynamicInForce:
      out.number = c_.state.five.dynamic_zero;
      break;
    case Cell::Kind::kDynamicNow:
      out.number = dynamicZeroNow(c_)[cell.axis] / unitOf(c_, cell.axis);
      break;
    case Cell::Kind::kOffset:
      out.number = frames.system(cell.system).offset[cell.axis] / unitOf(c_, cell.axis);
      if (cell.axis < kMainAxes)
        out.origin = frames.system(cell.system).offset_by[static_cast<std::size_t>(cell.axis)];
      break;
    case Cell::Kind::kRotation:
      out.number = frames.system(cell.system).angles_deg[cell.axis];
      out.origin = frames.system(cell.system).angles_by[static_cast<std::size_t>(cell.axis)];
      break;
    case Cell::Kind::kDynamic:
      out.number = c_.registers.dynamic_zeros[static_cast<std::size_t>(cell.system)][cell.axis] /
                   unitOf(c_, cell.axis);
      break;
  }
  return VariableStatus::kDone;
}

VariableStatus FrameBank::write(int number, const Value& value) {
  const Cell cell = find(number);
  if (cell.kind == Cell::Kind::kNone) return VariableStatus::kUnknown;
  if (cell.kind == Cell::Kind::kDynamicInForce || cell.kind == Cell::Kind::kDynamicNow)
    return VariableStatus::kReadOnly;
  if (!(std::abs(value.number) <= kMaxValue)) return VariableStatus::kLimit;
  const double amount = value.vacant ? 0.0 : value.number;
  if (cell.kind == Cell::Kind::kDynamic) {
    c_.registers.dynamic_zeros[static_cast<std::size_t>(cell.system)][cell.axis] =
        amount * unitOf(c_, cell.axis);
    return VariableStatus::kDone;
  }
  if (!c_.flushPipe()) return VariableStatus::kReported;
  WorkSystem& system = c_.registers.frames.system(cell.system);
  if (cell.kind == Cell::Kind::kRotation) {
    system.angles_deg[cell.axis] = amount;
    system.angles_by[static_cast<std::size_t>(cell.axis)] = value.origin;
  } else {
    system.offset[cell.axis] = amount * unitOf(c_, cell.axis);
    if (cell.axis < kMainAxes) system.offset_by[static_cast<std::size_t>(cell.axis)] = value.origin;
  }
  c_.chain = c_.chainOf(c_.state);
  c_.position = c_.chain.programOf(c_.machine);
  recordFrames(c_, c_.state);
  c_.rebasePipe();
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
