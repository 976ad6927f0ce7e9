#include "core/nc/fanuc/haas/outline_reader.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "core/nc/iso/context/words.h"
#include "core/nc/text/lexer.h"

namespace proveout::nc {
namespace {

constexpr std::size_t kMostElements = 40;

/// What runs through the blocks of an outline.
class OutlineReader {
 public:
  OutlineReader(IsoContext& c, const BlockPlan& plan, const Vec2& start)
      : c_(c), plan_(plan), at_(start), step_(plan.next.incremental()), scale_(plan.next.unitScale()) {}

  /// A block; `ends`: it has M99. False: reported.
  bool take(const Block& block, std::size_t line, bool& ends);
  const PlaneContour& outline() const { return outline_; }

 private:
  bool fail(const std::string& what) {
    return c_.fail("pocket-outline", fmt::format("G150, line {} of the outline: {}", line_, what));
  }
  bool takeCodes(const Block& block, bool& ends);
  bool takeMotion(const Block& block);
  bool arc(const Block& block, const Vec2& to, bool has_end);

  IsoContext& c_;
  const BlockPlan& plan_;
  Vec2 at_;
  bool step_, led_in_ = false;
  double scale_;
  int motion_ = gcode::kLine;
  std::size_t line_ = 0;
  PlaneContour outline_;
};

bool OutlineReader::takeCodes(const Block& block, bool& ends) {
  for (const Word& w : block.words) {
    if (w.address == 'M') {
      if (w.value != mcode::kReturn) return fail(fmt::format("M{:g} cannot stand there", w.value));
      ends = true;
    }
    if (w.address != 'G') continue;
    const int code10 = code10Of(w);
    switch (code10) {
      case gcode::kRapid:
      case gcode::kLine:
      case gcode::kArcClockwise:
      case gcode::kArcCounterClockwise:
        motion_ = code10;
        break;
      case gcode::kAbsolute:
      case gcode::kIncremental:
        step_ = code10 == gcode::kIncremental;
        break;
      case gcode::kPlaneXY:
        break;
      default:
        return fail(fmt::format("{} cannot stand there", gName(code10)));
    }
  }
  return true;
}

bool OutlineReader::takeMotion(const Block& block) {
  const Word* x = block.find('X');
  const Word* y = block.find('Y');
  const bool centre = !(block.present & AddressSet("IJ")).empty();
  if (x == nullptr && y == nullptr && !centre) return true;
  Vec2 to = at_;
  if (x != nullptr) to.x() = (step_ ? at_.x() : 0.0) + x->value * scale_;
  if (y != nullptr) to.y() = (step_ ? at_.y() : 0.0) + y->value * scale_;
  if (!to.allFinite()) return fail("the point is out of range");
  if (!led_in_) {  // the way from the start to the outline
    led_in_ = true;
    at_ = to;
    return true;
  }
  if (outline_.size() >= kMostElements) return fail("an outline has 40 blocks at most");
  if (motion_ == gcode::kRapid) return fail("an outline has no rapids");
  if (motion_ != gcode::kLine) return arc(block, to, x != nullptr || y != nullptr);
  if (to != at_) outline_.push_back(lineElement(at_, to));
  at_ = to;
  return true;
}

bool OutlineReader::arc(const Block& block, const Vec2& to, bool has_end) {
  ArcRequest request;
  request.start = Vec3(at_.x(), at_.y(), 0.0);
  request.end = Vec3(to.x(), to.y(), 0.0);
  request.has_plane_end = has_end;
  request.counter_clockwise = motion_ == gcode::kArcCounterClockwise;
  if (const Word* i = block.find('I')) request.center_u = i->value * scale_;
  if (const Word* j = block.find('J')) request.center_v = j->value * scale_;
  if (const Word* r = block.find('R')) request.radius = r->value * scale_;
  const ArcResolution resolved = resolveArc(request);
  if (!resolved.ok() || resolved.no_motion)
    return fail("the arc is not defined, or its end is not on its circle");
  outline_.push_back(arcElement(resolved.arc.center, at_, to, resolved.arc.sweep_rad));
  at_ = to;
  return true;
}

bool OutlineReader::take(const Block& block, std::size_t line, bool& ends) {
  line_ = line + 1;
  if (block.kind != LineKind::kBlock) return fail("statements of the macro language cannot stand there");
  const AddressSet legal = "GMXYIJRFN";
  for (const Word& w : block.words) {
    if (!legal.has(w.address)) return fail(fmt::format("{} cannot stand there", wordName(w, block)));
  }
  return takeCodes(block, ends) && takeMotion(block);
}

/// The text of P and the index of the line to begin with. False: reported.
bool outlineText(IsoContext& c, SourceText*& text, std::size_t& first) {
  const Word* p = c.word('P');
  std::int64_t number = 0;
  if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "G150 needs the program of its outline");
  if (!integerWord(c, *p, 1, 99999999, number)) return false;
  const CallFrame& here = c.calls.top();
  const ProgramStore::Loaded loaded = c.programs.byNumber(here.file, number);
  if (loaded.text != nullptr) {
    text = loaded.text;
    first = loaded.text->firstLine();
    return true;
  }
  const SourceText::Label label = here.text->label(number, 0);
  if (label.line_index == SourceText::kNoLabel)
    return c.alarm(SharedAlarm::kProgramNotFound, "", loaded.message);
  text = here.text;
  first = static_cast<std::size_t>(label.line_index);
  return true;
}

/// Numbers without a point count as in the program's own blocks.
bool takeNumbers(IsoContext& c, Block& block) {
  if (c.dialect.take_words == nullptr) return true;
  std::swap(c.block, block);
  const bool good = c.dialect.take_words(c);
  std::swap(c.block, block);
  return good;
}

}  // namespace

bool readOutline(IsoContext& c, const BlockPlan& plan, const Vec2& start, PlaneContour& outline) {
  SourceText* text = nullptr;
  std::size_t first = 0;
  if (!outlineText(c, text, first)) return false;
  LexRules rules = c.dialect.lexing;
  rules.expressions = &c.macro;
  rules.names = &c.axes.names();
  Lexer lexer(rules, c.dialect.alarms);
  OutlineReader reader(c, plan, start);
  Block block;
  bool ends = false;
  for (std::size_t line = first; line < text->lines().size() && !ends; ++line) {
    if (!lexer.lex(text->lines()[line], block)) return c.fail(lexer.error());
    if (block.percent) continue;
    if (!takeNumbers(c, block)) return false;
    if (!reader.take(block, line, ends)) return false;
  }
  outline = reader.outline();
  return true;
}

}  // namespace proveout::nc
