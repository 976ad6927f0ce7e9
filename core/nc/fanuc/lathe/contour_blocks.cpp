#include "core/nc/fanuc/lathe/contour_blocks.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/text/lexer.h"

namespace proveout::nc {
namespace {

constexpr std::size_t kMostContourLines = 5000;
/// What roughing leaves out of a contour's blocks (section 16): it holds for G70 alone.
constexpr AddressSet kFinishWords = "FSTMD";

/// Takes what the pipe makes of the contour's blocks, chamfers and corners included.
class ContourCapture final : public PathStage {
 public:
  ContourCapture(BlockContour& contour, const Vec2& from)
      : PathStage(StageSlot::kVirtual), contour_(contour), at_(from) {}
  bool push(PathItem& item) override {
    if (item.function() || item.kind == PathItem::Kind::kStay) return true;
    const Vec2 to(item.to[2], item.to[0]);
    if (item.kind == PathItem::Kind::kArc) {
      add(arcElement(item.center.head<2>(), at_, to, item.sweep), item);
    } else if ((to - at_).norm() > 1e-9) {
      add(lineElement(at_, to), item);
    }
    at_ = to;
    return true;
  }

 private:
  void add(ContourElement e, const PathItem& item) {
    e.source = static_cast<int>(contour_.sources.size());
    contour_.elements.push_back(e);
    contour_.sources.push_back(item.source);
    contour_.rapids.push_back(item.rapid);
  }

  BlockContour& contour_;
  Vec2 at_;
};

/// What the contour's blocks change, for the cycle to find it as it was.
class ControlAside {
 public:
  explicit ControlAside(IsoContext& c)
      : c_(c),
        block_(c.block),
        state_(c.state),
        position_(c.position),
        machine_(c.machine),
        line_(c.calls.lineIndex()),
        words_(c.origins.slots()) {}
  ControlAside(const ControlAside&) = delete;
  ControlAside& operator=(const ControlAside&) = delete;
  ~ControlAside() {
    c_.origins.restore(words_, {});
    c_.word_patterns.last = nullptr;
    c_.block = block_;
    c_.state = state_;
    c_.position = position_;
    c_.machine = machine_;
    c_.setBlock(line_, block_.number);
  }

 private:
  IsoContext& c_;
  const Block block_;
  const IsoState state_;
  const AxisPoint position_, machine_;
  const std::size_t line_;
  const OriginRecorder::Slots words_;
};

bool isFinishCode(const GCode& code) {
  return code.group == kGroupRadiusComp || code.group == kGroupSurfaceSpeed || code.group == kGroupFeedMode ||
         code.code10 == 40 || code.code10 == gcode::kExactStop || code.group == kGroupCutting;
}

bool isContourCode(const GCode& code) {
  return (code.group == kGroupMotion && code.code10 <= gcode::kArcCounterClockwise) ||
         code.group == kGroupDistance;
}

/// Codes that a contour may not have; those of feeds and compensation are left out.
bool checkCodes(IsoContext& c) {
  for (const Word& w : c.block.words) {
    if (w.address == 'G') {
      const GCode* const code = c.codes.g(code10Of(w));
      if (code != nullptr && (isContourCode(*code) || isFinishCode(*code))) continue;
      return c.failWord("066", fmt::format("improper code in the contour of a turning cycle: G{:g}", w.value),
                        w);
    }
    const bool call = w.address == 'M' && (w.value == mcode::kCall || w.value == mcode::kReturn ||
                                           w.value == mcode::kEnd || w.value == mcode::kEndAndRewind);
    if (call)
      return c.failWord("066", fmt::format("improper code in the contour of a turning cycle: M{:g}", w.value),
                        w);
  }
  return true;
}

void leaveOut(IsoContext& c) {
  const bool dwell = std::any_of(c.block.words.begin(), c.block.words.end(),
                                 [](const Word& w) { return w.address == 'G' && code10Of(w) == 40; });
  std::erase_if(c.block.words, [&](const Word& w) {
    if (kFinishWords.has(w.address) || dwell) return true;
    const GCode* const code = w.address == 'G' ? c.codes.g(code10Of(w)) : nullptr;
    return code != nullptr && isFinishCode(*code);
  });
  c.block.present = {};
  for (const Word& w : c.block.words) c.block.present.add(w.address);
}

bool hasG(const IsoContext& c, int code10) {
  return std::any_of(c.block.words.begin(), c.block.words.end(), [&](const Word& w) {
    const GCode* const code = w.address == 'G' ? c.codes.g(code10Of(w)) : nullptr;
    return code != nullptr && code->group == kGroupMotion && code->code10 == code10;
  });
}

/// The first block: G0 or G1, and which axes it names.
bool checkFirst(IsoContext& c, BlockContour& contour) {
  if (!hasG(c, gcode::kRapid) && !hasG(c, gcode::kLine)) {
    return c.fail(
        "065",
        "the first block of a contour (P of the cycle) needs G00 or G01 in it: write G00 or G01 there");
  }
  contour.names_x = c.block.present.has('X') || c.block.present.has('U');
  contour.names_z = c.block.present.has('Z') || c.block.present.has('W');
  return true;
}

class ContourReader {
 public:
  ContourReader(IsoContext& c, const BlockPlan& plan, const ContourLines& lines, BlockContour& contour)
      : c_(c), plan_(plan), lines_(lines), contour_(contour), lexer_(rules(c), c.dialect.alarms) {}

  bool read() {
    const std::vector<std::string_view>& text = c_.calls.top().text->lines();
    for (std::size_t k = lines_.first; k <= lines_.last; ++k) {
      if (!readLine(text[k], k)) return false;
    }
    return true;
  }

 private:
  static LexRules rules(IsoContext& c) {
    LexRules rules = c.dialect.lexing;
    rules.expressions = &c.macro;
    rules.names = &c.axes.names();
    return rules;
  }

  bool readLine(std::string_view line, std::size_t index) {
    Block& block = c_.block;
    block.number = -1;
    const bool lexed = lexer_.lex(line, block);
    c_.setBlock(index, block.number);
    if (block.skip > 0 && c_.settings.skip_switches[static_cast<std::size_t>(block.skip - 1)]) return true;
    if (!lexed) return c_.fail(lexer_.error());
    if (block.kind == LineKind::kAssignment) return assign();
    if (block.kind != LineKind::kBlock)
      return c_.fail("066", "jumps and loops cannot stand in the contour of a turning cycle");
    if (block.empty()) return true;
    if (!c_.dialect.take_words(c_) || !checkRepeats(c_) || !checkCodes(c_)) return false;
    if (index == lines_.first && !checkFirst(c_, contour_)) return false;
    const bool corner = block.present.has(kCommaChamfer) || block.present.has(kCommaRounding);
    if (index == lines_.last && corner)
      return c_.fail("069", "the last block of a contour ends in no chamfer or corner");
    leaveOut(c_);
    return block.empty() || runBlock();
  }

  bool assign() {
    LexError error;
    std::size_t pos = c_.block.statement;
    return c_.macro.assign(c_.block.text, pos, error) || (!error.code.empty() && c_.fail(error));
  }

  bool runBlock() {
    BlockPlan plan(c_.state);
    plan.next.active[kGroupRadiusComp] = gcode::kCompOff;
    if (plan.next.feed <= 0.0) plan.next.feed = 1.0;  // the cycle has its own
    if (!c_.dialect.plan(c_, plan)) return false;
    recordWords(c_, plan);
    if (plan.perform != nullptr && !performMove(c_, plan)) return false;
    c_.state = plan.next;
    return true;
  }

  IsoContext& c_;
  const BlockPlan& plan_;
  const ContourLines lines_;
  BlockContour& contour_;
  Lexer lexer_;
};

}  // namespace

bool findContour(IsoContext& c, const BlockPlan& plan, const std::string& code, ContourLines& lines) {
  SourceText& text = *c.calls.top().text;
  std::int64_t numbers[2] = {0, 0};
  for (const int k : {0, 1}) {
    const Word* w = c.ownWord(plan, "PQ"[k]);
    if (w == nullptr)
      return c.fail("061",
                    fmt::format("{} needs P and Q, the numbers of the contour's first and last block", code));
    if (!integerWord(c, *w, 0, 99999999, numbers[k])) return false;
  }
  const auto find = [&](std::int64_t number, std::size_t from, std::size_t& line) {
    const SourceText::Label label = text.label(number, from);
    if (label.line_index == SourceText::kNoLabel)
      return c.fail("063", fmt::format("{}: block N{} of the contour not found", code, number));
    line = static_cast<std::size_t>(label.line_index);
    return true;
  };
  if (!find(numbers[0], c.calls.lineIndex() + 1, lines.first) || !find(numbers[1], lines.first, lines.last))
    return false;
  if (lines.last <= lines.first)
    return c.fail("063",
                  fmt::format("{}: block N{} does not stand behind N{}", code, numbers[1], numbers[0]));
  const std::size_t here = c.calls.lineIndex();
  if (here >= lines.first && here <= lines.last)
    return c.fail("063", fmt::format("{} stands inside its own contour", code));
  if (lines.last - lines.first > kMostContourLines)
    return c.fail("063", fmt::format("{}: a contour of more than {} lines", code, kMostContourLines));
  return true;
}

bool readContour(IsoContext& c, const BlockPlan& plan, const ContourLines& lines, BlockContour& contour) {
  if (plan.next.axes.mode != VirtualMode::kOff)
    return c.fail("066", "cycles of turning cannot run in a plane with a rotary axis");
  if (!c.pipe.flush(FlushReason::kBuffer)) return false;
  bool good = false;
  {
    const ControlAside aside(c);
    c.state = plan.next;
    c.state.active[kGroupRadiusComp] = gcode::kCompOff;
    c.state.active[kGroupMotion] = gcode::kLine;
    const AxisPoint from = c.chain.workOf(c.position);
    ContourCapture capture(contour, Vec2(from[2], from[0]));
    c.pipe.link(capture);
    good = ContourReader(c, plan, lines, contour).read() && c.pipe.flush(FlushReason::kBuffer);
    c.pipe.unlink(capture);
  }
  if (!good) c.pipe.clear();
  c.rebasePipe();
  if (!good) return false;
  return contour.elements.size() > 1 || c.fail("063", "the contour moves nowhere");
}

}  // namespace proveout::nc
