#include "core/nc/wl4/wl4_origins.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/nc/wl4/wl4_codes.h"

namespace proveout::nc {

namespace {

using Slot = OriginRecorder::Slot;

Slot slotOf(std::uint32_t word) {
  Slot slot;
  slot.word = word;
  slot.state = word == 0 ? Slot::State::kNone : Slot::State::kWord;
  return slot;
}

OffsetInForce rowInForce(const std::map<int, OffsetValue>& table, int row) {
  OffsetInForce in_force;
  const auto found = table.find(row);
  if (row == 0) return in_force;
  in_force.row = row;
  if (found != table.end()) {
    in_force.geometry = found->second.geometry;
    in_force.wear = found->second.wear;
  }
  return in_force;
}

constexpr std::string_view kIncrements = "UVW";

}  // namespace

void Wl4Origins::beginBlock(std::string_view line) {
  const SourceRef at = placeOf(levels_);
  recorder_.enter(at.file, at.depth, !levels_.back().program->text->builtIn());
  recorder_.begin(at.line, blockNumberOf(line));
}

bool Wl4Origins::shownByText() const { return block_.plain && recorder_.byText(); }

void Wl4Origins::recordLetter(char letter, OriginKind kind, bool step, bool by_text) {
  if (!block_.has(letter)) return;
  if (by_text && shownByText()) {
    plain_words_.kinds.add(kind);
    if (step) plain_words_.steps.add(kind);
  } else {
    recorder_.word(kind, block_.at(letter), block_.value(letter), block_.readsOf(letter), {step, false});
  }
}

void Wl4Origins::recordCode(const Wl4Block::Code& code, OriginKind kind) {
  if (shownByText()) {
    plain_words_.kinds.add(kind);
  } else {
    recorder_.word(kind, code.columns, code.number, code.reads, {});
  }
}

void Wl4Origins::recordCodesOf(int number, OriginKind kind) {
  for (const Wl4Block::Code& word : block_.g) {
    if (word.number == number) recordCode(word, kind);
  }
}

/// Plain words of the block take effect all at once: blocks that are alike then cost next to nothing.
void Wl4Origins::tellPlainWords() {
  told_shape_.reset();
  const PlainWords words = std::exchange(plain_words_, {});
  if (words.kinds.empty() || (words == told_words_ && recorder_.again())) return;
  recorder_.literals(words.kinds, words.steps, false);
  told_words_ = words;
}

/// Nothing: other words or modes may change with the block.
std::optional<Wl4Origins::BlockShape> Wl4Origins::shapeOf(const Wl4BlockPlan& p) const {
  constexpr AddressSet kLetters = "XYZABCIJKRF";
  if (!block_.plain || p.deed != nullptr || block_.g.count > 1 || block_.m.count > 0 ||
      !block_.present.without(kLetters).empty())
    return std::nullopt;
  const int g = block_.g.count == 1 ? block_.g.at[0].number : -1;
  if (g > 3) return std::nullopt;
  return BlockShape{block_.present, p.named, g, p.next.motion, p.next.distance, p.chamfer > 0.0};
}

void Wl4Origins::recordWords(const Wl4BlockPlan& p) {
  const std::optional<BlockShape> shape = shapeOf(p);
  if (shape && shape == told_shape_ && recorder_.again()) return;
  recordBlock(p);
  told_shape_ = shape;
}

void Wl4Origins::recordBlock(const Wl4BlockPlan& p) {
  recorder_.clear(kBlockKinds);
  recordCodes(p);
  recordLetter('T', OriginKind::kNextTool);
  recordLetter('D', OriginKind::kRadiusOffset);
  if (p.next.length != 49) recordLetter('H', OriginKind::kLengthOffset);
  if (!p.mirror) recordLetter('S', OriginKind::kSpindle);  // there it is a limit
  if (!p.contour) {
    recordLetter('F', OriginKind::kFeed);
    if (p.thread) recordLetter('F', OriginKind::kThreadLead);
    recordAxes(p);
  }
  if (p.arc()) {
    recordLetter('I', OriginKind::kI);
    recordLetter('J', OriginKind::kJ);
    recordLetter('K', OriginKind::kK);
    recordLetter('R', OriginKind::kArcRadius);
  }
  if (p.chamfer > 0.0) recordLetter('B', OriginKind::kCorner);
  tellPlainWords();
  const bool data = block_.has('T') || block_.has('D') || block_.has('H') || p.sets_system ||
                    p.next.length != state_.length || p.next.system != state_.system || !data_told_;
  if (data) recordData(p);
}

void Wl4Origins::recordCodes(const Wl4BlockPlan& p) {
  for (const Wl4Block::Code& word : block_.g) {
    const Wl4GCode& code = *wl4GCode(word.number);
    if (code.code == 80) recorder_.clear(kCycleKinds);
    if (!code.kind || code.code == 80) continue;
    if (p.contour && *code.kind == OriginKind::kCompensation) continue;    // on during the cycle alone
    if (code.code == 51 && (block_.present & "XYZABC").empty()) continue;  // a limit of the speed
    recordCode(word, *code.kind);
  }
  for (const Wl4Block::Code& word : block_.m) {
    if (const Wl4MCode& code = wl4MCode(word.number); code.kind) recordCode(word, *code.kind);
  }
}

/// Words of the axes that the block names as positions.
void Wl4Origins::recordAxes(const Wl4BlockPlan& p) {
  for (int axis = 0; axis < setup_.axes.count(); ++axis) {
    if (!p.named[static_cast<std::size_t>(axis)]) continue;
    const std::string& name = setup_.axes.at(axis).name;
    const char absolute = name[0];
    const char incremental = axis < 3 ? kIncrements[static_cast<std::size_t>(axis)] : '\0';
    const bool both = block_.has(absolute) && incremental != '\0' && block_.has(incremental);
    const bool by_increment = !block_.has(absolute) || (both && block_.later(incremental, absolute));
    const bool step = by_increment || p.next.distance == 91;
    recordLetter(by_increment ? incremental : absolute, axisKind(name), step, !both);
  }
}

void Wl4Origins::recordData(const Wl4BlockPlan& p) {
  const Wl4State& s = p.next;
  data_told_ = true;
  DataInForce data = recorder_.data();
  data.tool = s.tool;
  data.length = s.length == 49 ? OffsetInForce() : rowInForce(setup_.settings.length_offsets, s.h);
  data.length_offset = Vec3(s.length_offset[0], s.length_offset[1], s.length_offset[2]);
  data.radius = rowInForce(setup_.settings.radius_offsets, s.d);
  if (setup_.lathe) {
    const Wl4Parameters::Tool& tool = setup_.parameters.tool(s.selected_tool);
    data.nose_tool = s.selected_tool;
    data.nose_radius = tool.nose_radius;
    data.tip = tool.tip;
    data.at_center = tool.at_center;
    data.tool_offset = Vec3(s.tool_offset[0], s.tool_offset[1], s.tool_offset[2]);
  }
  const bool from_job = s.system >= 54 && s.system <= 59;
  data.work_system = from_job ? s.system - 53 : 0;
  data.common_offset = {};
  data.work_offset = {};
  if (from_job) {
    data.common_offset.value = setup_.settings.common_offset;
    data.work_offset.value = setup_.settings.work_offsets[static_cast<std::size_t>(s.system - 54)];
  } else if (s.system == 92) {
    data.work_offset.value = s.system_offset.xyz;
    if (p.sets_system) recordSetters();
    data.work_offset.set_by = system_by_;
  }
  recorder_.setData(data);
}

/// The words of G92.
void Wl4Origins::recordSetters() {
  if (state_.system != 92) system_by_ = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const char letter = "XYZ"[k];
    if (!block_.has(letter)) continue;
    system_by_[k] = recorder_.numberOf(OriginKind::kData, block_.at(letter), block_.value(letter),
                                       block_.readsOf(letter));
  }
}

void Wl4Origins::recordToolChange() {
  recorder_.put(OriginKind::kTool, recorder_.slot(OriginKind::kNextTool));
  DataInForce data = recorder_.data();
  data.tool = state_.tool;
  recorder_.setData(data);
}

void Wl4Origins::recordFixedCycle() {
  recorder_.put(OriginKind::kCyclePlane, slotOf(variables_.originOf(2)));
  recorder_.put(OriginKind::kCycleDepth, slotOf(variables_.originOf(3)));
  recorder_.put(OriginKind::kCycleStep, slotOf(state_.cycle == 83 ? variables_.originOf(5) : 0));
}

void Wl4Origins::recordOpenCycle(const Wl4BlockPlan& p) {
  recordCodesOf(p.deed->code, OriginKind::kCycle);
  tellPlainWords();
}

void Wl4Origins::recordContourCycle(const Wl4BlockPlan& p) {
  const auto tell = [&](char letter, OriginKind kind) { recordLetter(letter, kind, false, false); };
  for (const char letter : {'R', 'I', 'K'}) tell(letter, OriginKind::kAllowance);
  if (p.deed->code == 76) {  // the stock
    for (const char letter : {'U', 'W', 'C'}) tell(letter, OriginKind::kCycleDepth);
  }
  tell('E', OriginKind::kCycleStep);
  tell('F', OriginKind::kFeed);
  for (const Wl4Block::Code& word : block_.g) {
    if (word.number == p.deed->code) recordCode(word, OriginKind::kCycle);
    if (word.number == 41 || word.number == 42) recordCode(word, OriginKind::kCompensation);
  }
  tellPlainWords();
}

Wl4ContourWords Wl4Origins::wordsInPlane(const WorkPlane& plane) const {
  Wl4ContourWords words;
  words.u = recorder_.slot(axisKind(setup_.axes.at(plane.u).name));
  words.v = recorder_.slot(axisKind(setup_.axes.at(plane.v).name));
  return words;
}

void Wl4Origins::recordContourAxes(const Wl4BlockPlan& p) {
  recordAxes(p);
  tellPlainWords();
}

Wl4ContourWords Wl4Origins::recordContourBlock(const WorkPlane& plane) {
  Wl4ContourWords words = wordsInPlane(plane);
  const std::size_t first = block_.text.find_first_not_of(" \t");
  const std::size_t last = block_.text.find_last_not_of(" \t\r");
  const Columns whole{static_cast<int>(first) + 1, static_cast<int>(last) + 2};
  words.block =
      slotOf(recorder_.numberOf(OriginKind::kContour, whole, std::numeric_limits<double>::quiet_NaN(), 0));
  return words;
}

void Wl4Origins::recordPass(const WorkPlane& plane, const Wl4ContourWords& words) {
  recorder_.put(axisKind(setup_.axes.at(plane.u).name), words.u);
  recorder_.put(axisKind(setup_.axes.at(plane.v).name), words.v);
  recorder_.put(OriginKind::kContour, words.block);
}

}  // namespace proveout::nc
