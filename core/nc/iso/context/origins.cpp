#include "core/nc/iso/context/origins.h"

#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

/// Stands for a word that no motion depends on.
constexpr OriginKind kNothing = OriginKind::kVariable;

/// Do the axis words of a code say where the tool goes?
bool goesThere(const GCode& code) {
  if (code.group == kGroupMotion) return true;
  if (code.group == kGroupCycle) return code.code10 != gcode::kCycleCancel;
  if (code.group != kOneShot) return false;
  switch (code.code10) {
    case gcode::kReference:
    case gcode::kNumberedReference:
    case gcode::kSkip:
    case gcode::kMeasureLength:
    case gcode::kMachineMove:
      return true;
    default:
      return false;
  }
}

bool turnsSpindle(int m) { return mcode::turns(m) || m == mcode::kSpindleStop || m == mcode::kOrient; }

/// What the letters of a block are for.
class BlockWords {
 public:
  BlockWords(IsoContext& c, const BlockPlan& plan)
      : c_(c),
        plan_(plan),
        goes_(goesThere(*plan.governor)),
        arc_(plan.governor->code10 == gcode::kArcClockwise ||
             plan.governor->code10 == gcode::kArcCounterClockwise),
        cycle_(goes_ && plan.governor->group == kGroupCycle),
        drills_(cycle_ && c.anyAxisWord()),
        thread_(plan.next.active[kGroupMotion] == gcode::kThread && !plan.next.inCycle()),
        inch_(plan.next.active[kGroupUnits] == gcode::kInch) {}

  bool cycle() const { return cycle_; }
  void record();
  /// Of a plain motion block: all of its words.
  void kindsOf(KindSet& kinds, KindSet& steps) const;

 private:
  OriginKind kindOf(const Word& w) const;
  OriginKind kindOfLetter(Address address) const;
  OriginKind kindOfAxis(const Word& w) const;
  bool isStep(const Word& w, OriginKind kind) const;
  bool shownByText(OriginKind kind) const;
  void recordOne(const Word& w, OriginKind kind);
  void recordCodes();

  IsoContext& c_;
  const BlockPlan& plan_;
  bool goes_, arc_, cycle_, drills_, thread_, inch_;
};

OriginKind BlockWords::kindOf(const Word& w) const {
  if (w.axis >= 0 || (w.address >= 'U' && w.address <= 'W')) return goes_ ? kindOfAxis(w) : kNothing;
  if (w.spindle >= 0) return w.spindle < kSpindleNames ? OriginKind::kSpindle : kNothing;
  return kindOfLetter(w.address);
}

OriginKind BlockWords::kindOfLetter(Address address) const {
  switch (address) {
    case 'F':
      return thread_ ? OriginKind::kThreadLead : OriginKind::kFeed;
    case 'E':
      return thread_ && goes_ ? OriginKind::kThreadLead : kNothing;
    case 'S':
      return plan_.governor->code10 == gcode::kSetPosition ? kNothing
                                                           : OriginKind::kSpindle;  // there it is a limit
    case 'T':
      return OriginKind::kNextTool;
    case 'H':
      return OriginKind::kLengthOffset;
    case 'D':
      return OriginKind::kRadiusOffset;
    case 'I':
    case 'J':
    case 'K':
      if (arc_) return static_cast<OriginKind>(static_cast<int>(OriginKind::kI) + address - 'I');
      return drills_ ? OriginKind::kCycleShift : kNothing;
    case 'R':
      return arc_ ? OriginKind::kArcRadius : drills_ ? OriginKind::kCyclePlane : kNothing;
    case 'Q':
      return drills_ ? OriginKind::kCycleStep : kNothing;
    case kCommaDirection:
      return OriginKind::kAngle;
    case kCommaChamfer:
    case kCommaRounding:
      return OriginKind::kCorner;
    default:
      return kNothing;
  }
}

OriginKind BlockWords::kindOfAxis(const Word& w) const {
  AxisWord word;
  if (!axisWord(plan_, w, word)) return kNothing;
  if (cycle_ && word.axis == plan_.next.cycle.drill_axis) return OriginKind::kCycleDepth;
  return word.axis < kMainAxes ? static_cast<OriginKind>(word.axis) : axisKind(c_.axes.at(word.axis).name);
}

bool BlockWords::isStep(const Word& w, OriginKind kind) const {
  AxisWord word;
  if (kind == OriginKind::kCyclePlane) return w.incremental || plan_.next.incremental();
  return axisWord(plan_, w, word) && word.step;
}

/// Whether findWord() knows the address of the kind.
bool BlockWords::shownByText(OriginKind kind) const {
  if (kind == OriginKind::kCycleDepth) return plan_.next.cycle.drill_axis == 2;
  return kind != OriginKind::kOtherAxis;
}

void BlockWords::recordOne(const Word& w, OriginKind kind) {
  c_.origins.word(kind, w.columns, w.value, w.reads, {isStep(w, kind), inch_});
}

void BlockWords::kindsOf(KindSet& kinds, KindSet& steps) const {
  for (const Word& w : c_.block.words) {
    const OriginKind kind = kindOf(w);
    if (kind == kNothing) continue;
    kinds.add(kind);
    if (isStep(w, kind)) steps.add(kind);
  }
  kinds.add(plan_.code_kinds);
}

void BlockWords::record() {
  OriginRecorder& o = c_.origins;
  const bool by_text = c_.block.plain && o.byText();
  KindSet literal, steps;
  for (const Word& w : c_.block.words) {
    const OriginKind kind = kindOf(w);
    if (kind == kNothing) continue;
    if (!by_text || !shownByText(kind)) {
      recordOne(w, kind);
      continue;
    }
    literal.add(kind);
    if (isStep(w, kind)) steps.add(kind);
  }
  if (by_text) {
    KindSet codes = plan_.code_kinds;
    if (!goes_ && plan_.governor->code10 == gcode::kSetPosition && !c_.anyAxisWord())
      codes.remove(OriginKind::kShift);
    for (int i = 0; i < plan_.m_count; ++i) {
      if (turnsSpindle(plan_.m_value[static_cast<std::size_t>(i)])) codes.add(OriginKind::kSpindleDirection);
    }
    o.literals(literal | codes, steps, inch_);
  } else {
    recordCodes();
  }
}

/// G and M words with their columns.
void BlockWords::recordCodes() {
  for (const Word& w : c_.block.words) {
    if (w.address == 'M' && turnsSpindle(mNumber(w)))
      c_.origins.word(OriginKind::kSpindleDirection, w.columns, w.value, w.reads, {});
    if (w.address != 'G') continue;
    const GCode* code = c_.codes.g(code10Of(w));
    if (code == nullptr || (code->code10 == gcode::kSetPosition && !c_.anyAxisWord())) continue;
    (code->kinds & plan_.code_kinds).each([&](OriginKind kind) {
      c_.origins.word(kind, w.columns, w.value, w.reads, {});
    });
  }
}

OffsetInForce rowInForce(const OffsetTables& table, OffsetColumn column, int row) {
  OffsetInForce in_force;
  if (row == 0) return in_force;
  const OffsetValue& value = table.value(column, row);
  const OffsetTables::SetBy& by = table.setBy(column, row);
  return {row, value.geometry, value.wear, by.geometry, by.wear};
}

/// The radius that compensation counts with: of a row, or of a word or a tool beside the tables.
OffsetInForce radiusInForce(const OffsetTables& table, const IsoState& next) {
  OffsetInForce radius = rowInForce(table, OffsetColumn::kRadius, next.d);
  if (radius.value() == next.d_radius) return radius;
  radius.geometry = next.d_radius;
  radius.wear = 0.0;
  return radius;
}

/// What T of a lathe has chosen.
void takeNose(DataInForce& data, const IsoState& next) {
  constexpr int kCentre = 9;
  data.nose_tool = next.next_tool >= 0 ? next.next_tool : next.tool;
  data.nose_radius = next.d_radius;
  data.tip = next.d_tip;
  data.at_center = next.d_tip == 0 || next.d_tip == kCentre;
  data.tool_offset = next.length.xyz;
}

/// The rows that H and D of the block have read, or T where it names them.
void recordRows(IsoContext& c, const IsoState& next) {
  const OffsetTables& table = c.registers.offsets;
  DataInForce data = c.origins.data();
  if (c.block.present.has('H')) {
    data.length = rowInForce(table, OffsetColumn::kLength, next.h);
    data.length_x = rowInForce(table, OffsetColumn::kX, next.h);
    data.length_y = rowInForce(table, OffsetColumn::kY, next.h);
  }
  if (c.dialect.rules.offsets_by_tool)
    takeNose(data, next);
  else
    data.radius = radiusInForce(table, next);
  c.origins.setData(data);
}

/// Modes that end in the block, and words that the block before had for itself.
void endModes(IsoContext& c, const BlockPlan& plan) {
  OriginRecorder& o = c.origins;
  if (o.any(kBlockKinds)) o.clear(kBlockKinds);
  if (c.state.inCycle() && !plan.next.inCycle()) o.clear(kCycleKinds | OriginKind::kCycleReturn);
}

WordPattern patternOf(const IsoContext& c, const BlockPlan& plan) {
  return {c.block.present, plan.code_kinds, plan.governor, plan.next.active[kGroupDistance],
          plan.next.active[kGroupUnits]};
}

/// Does the block have the same letters and codes as the one before, in the same modes? It is a plain motion
/// block then, as that one was.
bool repeats(const IsoContext& c, const BlockPlan& plan) {
  const WordPatterns::Entry* last = c.word_patterns.last;
  return last != nullptr && c.block.plain && !c.block.steps && last->pattern == patternOf(c, plan);
}

/// A motion outside of cycles by plain letters that set nothing else.
bool isPlainMove(const IsoContext& c, const BlockPlan& plan) {
  constexpr AddressSet kLetters = "GXYZABCUVWIJKRF";
  return c.block.plain && !c.block.steps && plan.governor->group == kGroupMotion && !c.state.inCycle() &&
         !plan.frames_changed && c.block.present.without(kLetters).empty() && c.origins.byText();
}

void recordPlainMove(IsoContext& c, const BlockPlan& plan) {
  const WordPattern pattern = patternOf(c, plan);
  WordPatterns& patterns = c.word_patterns;
  const std::uint64_t hash = (pattern.letters.bits() ^ pattern.codes.bits() << 7) * 0x9E3779B97F4A7C15u;
  WordPatterns::Entry& entry = patterns.entries[hash >> 60];
  if (entry.pattern != pattern) {
    entry = {pattern, {}, {}};
    BlockWords(c, plan).kindsOf(entry.kinds, entry.steps);
  }
  patterns.last = &entry;
  if (c.origins.any(kBlockKinds)) c.origins.clear(kBlockKinds);
  c.origins.literals(entry.kinds, entry.steps, pattern.units == gcode::kInch);
}

}  // namespace

void recordWords(IsoContext& c, const BlockPlan& plan) {
  if (c.block.words.empty() || (repeats(c, plan) && c.origins.again())) return;
  if (isPlainMove(c, plan)) return recordPlainMove(c, plan);
  c.word_patterns.last = nullptr;
  endModes(c, plan);
  BlockWords words(c, plan);
  const int drill = plan.next.cycle.drill_axis;
  if (words.cycle() && (!c.state.inCycle() || c.state.cycle.drill_axis != drill)) {
    c.cycle_start = c.origins.slot(axisKind(c.axes.at(drill).name));
  }
  words.record();
  const bool radius = plan.next.d != c.state.d || plan.next.d_radius != c.state.d_radius;
  if (radius || c.block.present.has('H') || c.block.present.has('D')) recordRows(c, plan.next);
  if (plan.frames_changed) recordFrames(c, plan.next);
}

void recordCycleLevel(IsoContext& c, int drill_axis, OriginKind level) {
  OriginRecorder& o = c.origins;
  using As = OriginRecorder::Reading::As;
  OriginRecorder::Slot slot = level == OriginKind::kCycleReturn ? c.cycle_start : o.slot(level);
  if (level == OriginKind::kCyclePlane)
    slot.reading = {slot.reading.incremental(), slot.reading.inch(), As::kCyclePlane};
  if (level == OriginKind::kCycleStep)
    slot.reading = {slot.reading.incremental(), slot.reading.inch(), As::kCycleStep};
  o.put(axisKind(c.axes.at(drill_axis).name), slot);
}

void recordToolChange(IsoContext& c) {
  OriginRecorder& o = c.origins;
  o.put(OriginKind::kTool, o.slot(OriginKind::kNextTool));
  DataInForce data = o.data();
  data.tool = c.state.tool;
  o.setData(data);
}

void recordFrames(IsoContext& c, const IsoState& state) {
  const WorkFrames& frames = c.registers.frames;
  const WorkSystem system = frames.system(state.work_system);
  DataInForce data = c.origins.data();
  data.length_offset = state.length.xyz;
  if (state.five.along_tool) {  // as with all axes at 0
    const bool minus = state.active[kGroupLengthComp] == gcode::kLengthMinus;
    data.length_offset = (minus ? -state.h_value : state.h_value) * c.five_axes.tool;
  }
  data.work_system = state.work_system;
  data.work_offset = {system.offset.xyz, system.offset_by};
  data.work_rotation = {system.angles_deg, system.angles_by};
  data.common_offset = {frames.common.offset.xyz, frames.common.offset_by};
  data.shift = {frames.shift92.xyz + frames.shift52.xyz, frames.shift_by};
  c.origins.setData(data);
}

std::uint32_t numberOf(IsoContext& c, const Word& w, OriginKind kind) {
  return c.origins.numberOf(kind, w.columns, w.value, w.reads);
}

std::uint32_t numberOfAxisWord(IsoContext& c, const BlockPlan& plan, int axis) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word) && word.axis == axis) return numberOf(c, w, OriginKind::kData);
  }
  return 0;
}

}  // namespace proveout::nc
