#include "core/nc/flexnc/flexnc_words.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string_view>

#include "core/nc/flexnc/cycles/flexnc_cycles.h"
#include "core/nc/flexnc/flexnc_functions.h"
#include "core/nc/flexnc/flexnc_motion.h"
#include "core/nc/flexnc/flexnc_origins.h"

namespace proveout::nc {

namespace {

bool isCycle(int tenths) { return tenths >= 0 && cycleCode(tenths / 10.0).has_value(); }
/// Codes behind which all words are arguments.
bool takesTheRest(int tenths) { return isCycle(tenths) || (tenths >= 810 && tenths <= 813); }

bool refuseCode(FlexContext& c, const FlexWord& word) {
  const auto from = static_cast<std::size_t>(word.columns.begin - 1);
  const auto length = static_cast<std::size_t>(word.columns.end - word.columns.begin);
  const std::string_view text = c.block.text.substr(from, length);
  if (word.tenths == 920) {
    return c.report.fail("fnc-unknown", "G92 is not described for this control: shift the system with G52",
                         word.columns);
  }
  return c.report.fail("fnc-unknown", fmt::format("{} is no code of this control", text), word.columns);
}

bool checkAddress(FlexContext& c, const FlexWord& word) {
  switch (word.address) {
    case 'X':
    case 'Z':
    case 'I':
    case 'K':
    case 'F':
    case 'S':
    case 'D':
    case 'T':
      return true;
    case 'Y':
      return c.report.fail("fnc-unknown", "this lathe has no Y axis: remove the word", word.columns);
    case 'R':
      return c.report.fail("fnc-arc",
                           "R arcs are not known to this control: give the centre by I and K, from the start",
                           word.columns);
    default:
      return c.report.fail("fnc-unknown",
                           fmt::format("{} has no meaning in this block: it takes G M X Z I K F S D T, and "
                                       "the arguments of a cycle behind its code",
                                       word.address),
                           word.columns);
  }
}

/// A whole number of at most `most`.
bool wholeNumber(FlexContext& c, const FlexWord& word, int most, std::int32_t& out) {
  if (!(word.value >= 0.0 && word.value <= most && word.value == std::floor(word.value))) {
    return c.report.fail("fnc-num", fmt::format("{} is a whole number, 0 to {}", word.address, most),
                         word.columns);
  }
  out = static_cast<std::int32_t>(word.value);
  return true;
}

bool takeCorrector(FlexContext& c, const FlexWord& word) {
  FlexState& s = c.state;
  if (!wholeNumber(c, word, FlexParameters::kCorrectors, s.d)) return false;
  const FlexParameters::Corrector& row = c.parameters.corrector(s.d);
  s.corrector = Vec2(row.dx, row.dz);
  c.recorder.word(OriginKind::kRadiusOffset, word.columns, word.value, word.reads, {});
  recordFlexData(c);
  return true;
}

bool takeFeed(FlexContext& c, const FlexWord& word) {
  if (!(word.value > 0.0)) return c.report.fail("fnc-feed", "the feed F has to be above 0", word.columns);
  c.state.feed = word.value;
  c.state.feed_unit = c.state.feed_mode;
  c.recorder.word(OriginKind::kFeed, word.columns, word.value, word.reads, {});
  return true;
}

bool takeSpeed(FlexContext& c, const FlexWord& word) {
  if (!(word.value >= 0.0))
    return c.report.fail("fnc-spindle", "the speed S cannot be below 0", word.columns);
  (c.state.css == 86 ? c.state.surface : c.state.rpm) = word.value;
  c.recorder.word(OriginKind::kSpindle, word.columns, word.value, word.reads, {});
  return !c.state.turns() || turnFlexSpindle(c);
}

bool takeAxis(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  const FlexWord*& place = cursor.axes.of(word.address);
  if (place != nullptr) {
    return c.report.fail("fnc-param-extra",
                         fmt::format("{} stands twice for one motion: write two blocks", word.address),
                         word.columns);
  }
  place = &word;
  return true;
}

bool performG(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  if (!performFlexAxes(c, cursor)) return false;
  if (isCycle(word.tenths)) return performFlexCycle(c, cursor, word);
  const FlexGCode& code = *flexGCode(word.tenths);
  if (code.mode != nullptr) c.state.*code.mode = code.tenths / 10;
  if (code.kind) c.recorder.word(*code.kind, word.columns, word.value, word.reads, {});
  return code.perform == nullptr || code.perform(c, cursor, word);
}

bool performM(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  return performFlexAxes(c, cursor) && flexMCode(word.tenths)->perform(c, cursor, word);
}

bool performWord(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  switch (word.address) {
    case 'G':
      return performG(c, cursor, word);
    case 'M':
      return performM(c, cursor, word);
    case 'F':
      return takeFeed(c, word);
    case 'S':
      return takeSpeed(c, word);
    case 'D':
      return takeCorrector(c, word);
    case 'T':
      c.recorder.word(OriginKind::kNextTool, word.columns, word.value, word.reads, {});
      return wholeNumber(c, word, 9999, c.state.selected_tool);
    default:
      return takeAxis(c, cursor, word);
  }
}

}  // namespace

bool checkFlexWords(FlexContext& c) {
  for (const FlexWord& word : c.block.words) {
    if (word.address == 'G') {
      if (takesTheRest(word.tenths)) return true;
      if (flexGCode(word.tenths) == nullptr) return refuseCode(c, word);
    } else if (word.address == 'M') {
      if (flexMCode(word.tenths) == nullptr) return refuseCode(c, word);
    } else if (!checkAddress(c, word)) {
      return false;
    }
  }
  return true;
}

bool performFlexWords(FlexContext& c, FlexCursor& cursor) {
  while (cursor.next < c.block.words.size() && !cursor.ends) {
    const FlexWord& word = c.block.words[cursor.next++];
    if (!performWord(c, cursor, word)) return false;
  }
  return performFlexAxes(c, cursor);
}

bool performFlexAxes(FlexContext& c, FlexCursor& cursor) {
  if (!cursor.axes.any()) return true;
  const FlexAxisWords words = cursor.axes;
  cursor.axes = {};
  if (c.state.motion < 0) {
    return c.report.fail("fnc-motion", "no motion code has been given: put G00, G01, G02 or G03 in front",
                         words.first()->columns);
  }
  if (c.state.behind_cycle != 0 && !cursor.names_motion) {
    c.report.warnOnce("bare", "fnc-motion-mode",
                      fmt::format("which motion code holds behind a cycle is not known: G{:02} is taken, "
                                  "write it into the block",
                                  c.state.motion));
  }
  c.state.behind_cycle = 0;
  return moveFlexAxes(c, words);
}

bool performFlexMotionCode(FlexContext& c, FlexCursor& cursor, const FlexWord& /*word*/) {
  cursor.names_motion = true;
  c.state.behind_cycle = 0;
  return true;
}

bool performFlexDwell(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  const std::vector<FlexWord>& words = c.block.words;
  const bool given = cursor.next < words.size() && words[cursor.next].address == 'X';
  const double seconds = given ? words[cursor.next].value : 0.0;
  if (!given || !(seconds >= 0.001 && seconds <= 99999.999)) {
    return c.report.fail("fnc-dwell", "G04 needs X with 0.001 to 99999.999 seconds directly behind it",
                         given ? words[cursor.next].columns : word.columns);
  }
  ++cursor.next;
  PathItem item = flexFunction(c, PathItem::Kind::kDwell);
  item.value = seconds;
  return c.pipe.push(item);
}

bool performFlexPlane(FlexContext& c, FlexCursor& /*cursor*/, const FlexWord& word) {
  if (c.state.plane != 18) {
    c.report.note("plane", "fnc-plane",
                  "this machine has X and Z: arcs and compensation need G18, G17 and G19 take no others",
                  word.columns);
  }
  return true;
}

/// G52: the words X and Z behind it.
bool performFlexShift(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  std::array<const FlexWord*, 2> axes{};
  while (cursor.next < c.block.words.size()) {
    const FlexWord& next = c.block.words[cursor.next];
    const std::size_t axis = next.address == 'X' ? 0 : 1;
    if (next.address != 'X' && next.address != 'Z') break;
    if (axes[axis] != nullptr)
      return c.report.fail("fnc-param-extra", fmt::format("{} stands twice", next.address), next.columns);
    axes[axis] = &next;
    ++cursor.next;
  }
  if (axes[0] == nullptr && axes[1] == nullptr)
    return c.report.fail("fnc-param-missing", "G52 needs X, Z or both", word.columns);
  FlexState& s = c.state;
  const bool cancels =
      axes[0] != nullptr && axes[1] != nullptr && axes[0]->value == 0.0 && axes[1]->value == 0.0;
  const Vec2 work = c.at() - c.origin() - s.corrector;
  for (const int k : {0, 1}) {
    const FlexWord* const given = axes[static_cast<std::size_t>(k)];
    if (given == nullptr) continue;
    const double value = given->value * (k == 0 && c.parameters.diameters ? 0.5 : 1.0);
    s.shift[k] = cancels || c.parameters.g52_shifts ? value : work[k] - value;
  }
  recordFlexShift(c, axes);
  return true;
}

bool performFlexNothing(FlexContext& c, FlexCursor& /*cursor*/, const FlexWord& word) {
  c.report.note("G80", "fnc-g80", "G80 is not described for this control: it does nothing", word.columns);
  return true;
}

/// G86 S: the S behind it is the cutting speed. G87.
bool performFlexSurfaceSpeed(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  FlexState& s = c.state;
  if (s.css == 86) {
    const bool given = cursor.next < c.block.words.size() && c.block.words[cursor.next].address == 'S';
    if (!given && !(s.surface > 0.0)) {
      return c.report.fail("fnc-spindle", "G86 needs the cutting speed in m/min: G86 S90", word.columns);
    }
    return given || !s.turns() || turnFlexSpindle(c);  // S turns it
  }
  // Without an S of its own the spindle goes on as fast as it turns.
  if (!(s.rpm > 0.0)) s.rpm = std::abs(c.emitter.spindle());
  return !s.turns() || turnFlexSpindle(c);
}

}  // namespace proveout::nc
