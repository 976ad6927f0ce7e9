#include "core/nc/flexnc/flexnc_origins.h"

#include <cmath>

#include "core/nc/flexnc/cycles/cycle_call.h"

namespace proveout::nc {

namespace {

constexpr double kOnDiameter = 1e-6;  ///< mm: rounding of what a template computes

OffsetInForce radiusInForce(const FlexContext& c) {
  OffsetInForce row;
  const auto found = c.settings.radius_offsets.find(c.state.d);
  if (c.state.d == 0 || found == c.settings.radius_offsets.end()) return row;
  row.row = c.state.d;
  row.geometry = found->second.geometry;
  row.wear = found->second.wear;
  return row;
}

}  // namespace

void beginFlexLine(FlexContext& c) {
  const FlowFrame& level = c.levels.back();
  c.recorder.enter(0, static_cast<std::uint16_t>(c.levels.size() - 1), true);
  c.recorder.begin(static_cast<std::uint32_t>(level.block + 1), level.number);
  c.recorder.clear(kBlockKinds);
}

void recordFlexData(FlexContext& c) {
  const FlexState& s = c.state;
  const FlexParameters::Corrector& corrector = c.parameters.corrector(s.d);
  DataInForce data = c.recorder.data();
  data.tool = s.tool;
  data.radius = radiusInForce(c);
  data.nose_tool = s.d;
  data.nose_radius = corrector.nose_radius;
  data.tip = corrector.tip;
  data.tool_offset = Vec3(s.corrector.x(), 0.0, s.corrector.y());
  data.work_system = 1;
  data.work_offset.value = c.settings.work_offsets[0];
  data.common_offset.value = c.settings.common_offset;
  data.shift.value = Vec3(s.shift.x(), 0.0, s.shift.y());
  c.recorder.setData(data);
}

void recordFlexAxis(FlexContext& c, OriginKind kind, const FlexWord* word, bool step) {
  if (word != nullptr) c.recorder.word(kind, word->columns, word->value, word->reads, {step, false});
}

void recordFlexShift(FlexContext& c, const std::array<const FlexWord*, 2>& axes) {
  DataInForce data = c.recorder.data();
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    if (axes[k] == nullptr) continue;
    data.shift.set_by[2 * k] =
        c.recorder.numberOf(OriginKind::kData, axes[k]->columns, axes[k]->value, axes[k]->reads);
  }
  c.recorder.setData(data);
  recordFlexData(c);
}

void recordFlexToolChange(FlexContext& c) {
  c.recorder.put(OriginKind::kTool, c.recorder.slot(OriginKind::kNextTool));
  recordFlexData(c);
}

FlexCycleOrigins::FlexCycleOrigins(FlexContext& c, std::size_t code)
    : c_(c), file_(0), before_(c.recorder.slots()) {
  const FlexWord& word = c.block.words[code];
  const CycleCode cycle = *cycleCode(word.tenths / 10.0);
  file_ = c.program.cycleFile(cycleName(cycle), c.levels.back().block, c.sink);
  c.recorder.clear(KindSet::of(OriginKind::kX, OriginKind::kZ, OriginKind::kMotionCode));
  c.recorder.word(OriginKind::kCycle, word.columns, word.value, word.reads, {});
  record(OriginKind::kCycleStep, 'P', code);
  record(OriginKind::kArcRadius, 'R', code);
  record(OriginKind::kCorner, 'U', code);
  record(OriginKind::kAngle, 'G', code);
  a_ = record(OriginKind::kX, 'A', code);
  x_ = record(OriginKind::kX, 'X', code);
  if (isTemplate(cycle)) y_ = record(OriginKind::kZ, 'Y', code);
  z_ = record(OriginKind::kZ, 'Z', code);
  c.recorder.openCall();
  c.recorder.enter(file_, static_cast<std::uint16_t>(c.levels.size()), false);
}

FlexCycleOrigins::Argument FlexCycleOrigins::record(OriginKind kind, char letter, std::size_t code) {
  for (std::size_t k = code + 1; k < c_.block.words.size(); ++k) {
    const FlexWord& word = c_.block.words[k];
    if (word.address != letter) continue;
    c_.recorder.word(kind, word.columns, word.value, word.reads, {});
    return {word.value, c_.recorder.slot(kind)};
  }
  return {};
}

FlexCycleOrigins::~FlexCycleOrigins() {
  c_.report.inCycle({});
  c_.recorder.closeCall();
  c_.recorder.enter(0, static_cast<std::uint16_t>(c_.levels.size() - 1), true);
  c_.recorder.begin(static_cast<std::uint32_t>(c_.levels.back().block + 1), c_.levels.back().number);
  c_.recorder.restore(before_, {});
  // Where the cycle has left the tool no word tells.
  c_.recorder.clear(KindSet::of(OriginKind::kX, OriginKind::kZ));
}

void FlexCycleOrigins::place(std::uint32_t number) {
  c_.recorder.begin(number, -1);
  c_.report.inCycle({file_, number});
}

void FlexCycleOrigins::move(std::uint32_t number, const CycleMove& move) {
  place(number);
  tellDiameters(2.0 * move.element.to.y());
  const bool cuts = move.role == CycleMove::Role::kContour || move.role == CycleMove::Role::kPass;
  const std::optional<Slot>& along = cuts && y_.slot ? y_.slot : z_.slot;
  if (along) c_.recorder.put(OriginKind::kZ, *along);
}

/// A move that ends on a diameter has it from there. What ends between the two has it from both; a motion has
/// one word of X, so that the other one is told as the depth of the cycle.
void FlexCycleOrigins::tellDiameters(double end) {
  const auto on = [end](const Argument& d) { return d.slot && std::abs(end - d.value) < kOnDiameter; };
  const bool from_a = !x_.slot || (on(a_) && !on(x_)), both = x_.slot && a_.slot && !on(x_) && !on(a_);
  if (const std::optional<Slot>& across = from_a ? a_.slot : x_.slot)
    c_.recorder.put(OriginKind::kX, *across);
  if (both) {
    c_.recorder.put(OriginKind::kCycleDepth, *a_.slot);
  } else {
    c_.recorder.clear(KindSet::of(OriginKind::kCycleDepth));
  }
}

}  // namespace proveout::nc
