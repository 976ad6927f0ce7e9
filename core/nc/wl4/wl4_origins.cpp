// Where the words of a WL4 program were written: told to the recorder, block by block.
#include <algorithm>
#include <limits>
#include <utility>

#include "core/nc/wl4/wl4_control.h"

namespace proveout::nc {

namespace {

using Slot = OriginRecorder::Slot;

/// The kind of word that a G code is; nothing: no motion depends on it, or it is told elsewhere.
std::optional<OriginKind> kindOf(const Wl4GCode& code) {
  switch (code.group) {
    case Wl4Group::kMotion:
      return OriginKind::kMotionCode;
    case Wl4Group::kPlane:
      return OriginKind::kPlane;
    case Wl4Group::kRadius:
      return OriginKind::kCompensation;
    case Wl4Group::kLength:
      return OriginKind::kLengthCode;
    case Wl4Group::kSystem:
      return OriginKind::kWorkOffset;
    case Wl4Group::kCycle:
      return OriginKind::kCycle;
    case Wl4Group::kDistance:
      return OriginKind::kDistance;
    case Wl4Group::kFeed:
      return OriginKind::kFeedMode;
    case Wl4Group::kSpeed:
      return OriginKind::kSpindleMode;
    case Wl4Group::kDeed:
      if (code.code == 92) return OriginKind::kWorkOffset;
      return std::nullopt;
    case Wl4Group::kFlag:
      if (code.code == 50 || code.code == 51) return OriginKind::kMirror;
      return std::nullopt;
    case Wl4Group::kStop:
      return std::nullopt;
  }
  return std::nullopt;
}

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

void Wl4Control::beginBlock(std::string_view line) {
  const SourceRef at = place();
  origins_.enter(at.file, at.depth, !levels_.back().program->text->builtIn());
  origins_.begin(at.line, blockNumberOf(line));
}

bool Wl4Control::shownByText() const { return block_.plain && origins_.byText(); }

void Wl4Control::recordLetter(char letter, OriginKind kind, bool step, bool by_text) {
  if (!block_.has(letter)) return;
  if (by_text && shownByText()) {
    plain_words_.kinds.add(kind);
    if (step) plain_words_.steps.add(kind);
  } else {
    origins_.word(kind, block_.at(letter), block_.value(letter), block_.readsOf(letter), {step, false});
  }
}

void Wl4Control::recordCode(const Wl4Block::Code& code, OriginKind kind) {
  if (shownByText()) {
    plain_words_.kinds.add(kind);
  } else {
    origins_.word(kind, code.columns, code.number, code.reads, {});
  }
}

/// Plain words of the block take effect all at once: blocks that are alike then cost next to nothing.
void Wl4Control::tellPlainWords() {
  told_shape_.reset();
  const PlainWords words = std::exchange(plain_words_, {});
  if (words.kinds.empty() || (words == told_words_ && origins_.again())) return;
  origins_.literals(words.kinds, words.steps, false);
  told_words_ = words;
}

/// Nothing: other words or modes may change with the block.
std::optional<Wl4Control::BlockShape> Wl4Control::shapeOf(const Plan& p) const {
  constexpr AddressSet kLetters = "XYZABCIJKRF";
  if (!block_.plain || p.deed != 0 || block_.g.count > 1 || block_.m.count > 0 ||
      !block_.present.without(kLetters).empty())
    return std::nullopt;
  const int g = block_.g.count == 1 ? block_.g.at[0].number : -1;
  if (g > 3) return std::nullopt;
  return BlockShape{block_.present, p.named, g, p.next.motion, p.next.distance, p.chamfer > 0.0};
}

void Wl4Control::recordWords(const Plan& p) {
  const std::optional<BlockShape> shape = shapeOf(p);
  if (shape && shape == told_shape_ && origins_.again()) return;
  recordBlock(p);
  told_shape_ = shape;
}

void Wl4Control::recordBlock(const Plan& p) {
  const bool contour = isContourCycle(p.deed);
  const bool thread = p.deed == 31 || block_.hasCode(32) || block_.hasCode(33);
  const bool arc = p.deed == 0 && (p.next.motion == 2 || p.next.motion == 3);
  origins_.clear(kBlockKinds);
  recordCodes(contour);
  recordLetter('T', OriginKind::kNextTool);
  recordLetter('D', OriginKind::kRadiusOffset);
  if (p.next.length != 49) recordLetter('H', OriginKind::kLengthOffset);
  if (!block_.hasCode(51)) recordLetter('S', OriginKind::kSpindle);  // there it is a limit
  if (!contour) {
    recordLetter('F', OriginKind::kFeed);
    if (thread) recordLetter('F', OriginKind::kThreadLead);
    recordAxes(p);
  }
  if (arc) {
    recordLetter('I', OriginKind::kI);
    recordLetter('J', OriginKind::kJ);
    recordLetter('K', OriginKind::kK);
    recordLetter('R', OriginKind::kArcRadius);
  }
  if (p.chamfer > 0.0) recordLetter('B', OriginKind::kCorner);
  tellPlainWords();
  const bool data = block_.has('T') || block_.has('D') || block_.has('H') || p.deed == 92 ||
                    p.next.length != state_.length || p.next.system != state_.system || !data_told_;
  if (data) recordData(p);
}

void Wl4Control::recordCodes(bool contour) {
  for (const Wl4Block::Code& word : block_.g) {
    const Wl4GCode& code = *wl4GCode(word.number);
    const std::optional<OriginKind> kind = kindOf(code);
    if (code.code == 80) origins_.clear(kCycleKinds);
    if (!kind || code.code == 80) continue;
    if (contour && *kind == OriginKind::kCompensation) continue;           // on during the cycle alone
    if (code.code == 51 && (block_.present & "XYZABC").empty()) continue;  // a limit of the speed
    recordCode(word, *kind);
  }
  for (const Wl4Block::Code& word : block_.m) {
    if (word.number == 3 || word.number == 4 || word.number == 5 || word.number == 19)
      recordCode(word, OriginKind::kSpindleDirection);
  }
}

/// Words of the axes that the block names as positions.
void Wl4Control::recordAxes(const Plan& p) {
  for (int axis = 0; axis < axes_.count(); ++axis) {
    if (!p.named[static_cast<std::size_t>(axis)]) continue;
    const std::string& name = axes_.at(axis).name;
    const char absolute = name[0];
    const char incremental = axis < 3 ? kIncrements[static_cast<std::size_t>(axis)] : '\0';
    const bool both = block_.has(absolute) && incremental != '\0' && block_.has(incremental);
    const bool by_increment = !block_.has(absolute) || (both && block_.later(incremental, absolute));
    const bool step = by_increment || p.next.distance == 91;
    recordLetter(by_increment ? incremental : absolute, axisKind(name), step, !both);
  }
}

void Wl4Control::recordData(const Plan& p) {
  const Wl4State& s = p.next;
  data_told_ = true;
  DataInForce data = origins_.data();
  data.tool = s.tool;
  data.length = s.length == 49 ? OffsetInForce() : rowInForce(settings_.length_offsets, s.h);
  data.length_offset = Vec3(s.length_offset[0], s.length_offset[1], s.length_offset[2]);
  data.radius = rowInForce(settings_.radius_offsets, s.d);
  if (lathe_) {
    const Wl4Parameters::Tool& tool = parameters_.tool(s.selected_tool);
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
    data.common_offset.value = settings_.common_offset;
    data.work_offset.value = settings_.work_offsets[static_cast<std::size_t>(s.system - 54)];
  } else if (s.system == 92) {
    data.work_offset.value = s.system_offset.xyz;
    if (p.deed == 92) recordSetters();
    data.work_offset.set_by = system_by_;
  }
  origins_.setData(data);
}

/// The words of G92.
void Wl4Control::recordSetters() {
  if (state_.system != 92) system_by_ = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const char letter = "XYZ"[k];
    if (!block_.has(letter)) continue;
    system_by_[k] =
        origins_.numberOf(OriginKind::kData, block_.at(letter), block_.value(letter), block_.readsOf(letter));
  }
}

void Wl4Control::recordToolChange() {
  origins_.put(OriginKind::kTool, origins_.slot(OriginKind::kNextTool));
  DataInForce data = origins_.data();
  data.tool = state_.tool;
  origins_.setData(data);
}

/// What the programs %81 to %89 take from variables.
void Wl4Control::recordFixedCycle() {
  origins_.put(OriginKind::kCyclePlane, slotOf(variables_.originOf(2)));
  origins_.put(OriginKind::kCycleDepth, slotOf(variables_.originOf(3)));
  origins_.put(OriginKind::kCycleStep, slotOf(state_.cycle == 83 ? variables_.originOf(5) : 0));
}

/// Words of the block of G76 to G78 that all passes share.
void Wl4Control::recordContourCycle(const Plan& p) {
  const auto tell = [&](char letter, OriginKind kind) { recordLetter(letter, kind, false, false); };
  for (const char letter : {'R', 'I', 'K'}) tell(letter, OriginKind::kAllowance);
  if (p.deed == 76) {
    for (const char letter : {'U', 'W', 'C'}) tell(letter, OriginKind::kCycleDepth);
  }
  tell('E', OriginKind::kCycleStep);
  tell('F', OriginKind::kFeed);
  for (const Wl4Block::Code& word : block_.g) {
    if (word.number == p.deed) recordCode(word, OriginKind::kCycle);
    if (word.number == 41 || word.number == 42) recordCode(word, OriginKind::kCompensation);
  }
  tellPlainWords();
}

Wl4Control::ContourWords Wl4Control::wordsInPlane(const WorkPlane& plane) const {
  ContourWords words;
  words.u = origins_.slot(axisKind(axes_.at(plane.u).name));
  words.v = origins_.slot(axisKind(axes_.at(plane.v).name));
  return words;
}

/// The whole block of a contour, and what gave the end of its element.
Wl4Control::ContourWords Wl4Control::recordContourBlock(const WorkPlane& plane) {
  ContourWords words = wordsInPlane(plane);
  const std::size_t first = block_.text.find_first_not_of(" \t");
  const std::size_t last = block_.text.find_last_not_of(" \t\r");
  const Columns whole{static_cast<int>(first) + 1, static_cast<int>(last) + 2};
  words.block =
      slotOf(origins_.numberOf(OriginKind::kContour, whole, std::numeric_limits<double>::quiet_NaN(), 0));
  return words;
}

void Wl4Control::recordPass(const WorkPlane& plane, const ContourWords& words) {
  origins_.put(axisKind(axes_.at(plane.u).name), words.u);
  origins_.put(axisKind(axes_.at(plane.v).name), words.v);
  origins_.put(OriginKind::kContour, words.block);
}

std::uint32_t Wl4Control::systemOrigin(int number) const {
  switch (number) {
    case 120:
      return origins_.wordOf(OriginKind::kSpindle);
    case 121:
      return origins_.wordOf(OriginKind::kNextTool);
    case 130:
    case 131:
      return origins_.wordOf(OriginKind::kX);
    case 132:
    case 133:
      return origins_.wordOf(OriginKind::kY);
    case 134:
    case 135:
      return origins_.wordOf(OriginKind::kZ);
    case 139:
      return origins_.wordOf(OriginKind::kFeed);
    case 141:
      return origins_.wordOf(OriginKind::kRadiusOffset);
    default:
      return 0;
  }
}

}  // namespace proveout::nc
