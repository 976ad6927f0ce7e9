// Statements of the macro language: assignments, GOTO, IF, WHILE, DO, END (manual 23.2.1, 23.2.8-23.2.11).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/output.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/program/control.h"

namespace proveout::nc {

// A statement that decides where to go on and fails leaves nowhere to go on: it always stops the run.

namespace {

bool failStatement(IsoContext& c, const LexError& error) { return !error.code.empty() && c.fail(error); }

/// Nothing but comments may stand behind a statement.
bool endStatement(IsoContext& c, std::size_t pos) {
  const std::string_view text = c.block.text;
  pos = skipBlanks(text, pos);
  if (pos >= text.size() || text[pos] == '(') return true;
  return c.alarm(SharedAlarm::kMixedBlock, "", "nothing may follow the statement",
                 {static_cast<int>(pos) + 1, static_cast<int>(text.size()) + 1});
}

/// The loop mark of the line in hand, whose loop number stands at `pos`. Null: a fault, reported.
const LoopIndex::Mark* loopMark(IsoContext& c, std::size_t pos) {
  const std::string_view text = c.block.text;
  const bool is_end = c.block.kind == LineKind::kEnd;
  const int number = loopNumber(text, pos);
  if (number < 0) {
    c.alarm(SharedAlarm::kLoopNumber, is_end ? "END" : "DO", "loops have the numbers 1 to 3");
    return nullptr;
  }
  const LoopIndex::Mark* mark = c.calls.top().text->loops().find(c.calls.lineIndex());
  if (mark == nullptr) {
    c.alarm(SharedAlarm::kSyntax, "", "a loop starts and ends with a line of its own");
    return nullptr;
  }
  switch (mark->fault) {
    case LoopIndex::Fault::kNone:
      return endStatement(c, pos + 1) ? mark : nullptr;
    case LoopIndex::Fault::kDoubled:
      c.alarm(SharedAlarm::kLoopDoubled, "", fmt::format("DO{0} inside DO{0}", number));
      return nullptr;
    case LoopIndex::Fault::kNoEnd:
      c.alarm(SharedAlarm::kLoopPair, fmt::format("END{}", number), "loops end in pairs and do not overlap");
      return nullptr;
    case LoopIndex::Fault::kNoDo:
      c.alarm(SharedAlarm::kLoopPair, fmt::format("DO{}", number), "loops start in pairs and do not overlap");
      return nullptr;
  }
  return nullptr;
}

/// SETVN n[NAME,NAME,...]: names of #n, #n+1, ...; moves block.statement behind it. False: reported.
bool nameVariables(IsoContext& c) {
  const std::string_view text = c.block.text;
  std::size_t pos = skipBlanks(text, c.block.statement + 5);
  const auto refuse = [&](std::string_view detail) {
    return c.alarm(SharedAlarm::kSyntax, "", detail, {static_cast<int>(pos) + 1, static_cast<int>(pos) + 2});
  };
  int number = 0, digits = 0;
  for (; pos < text.size() && isDigit(text[pos]) && digits < 6; ++pos, ++digits)
    number = 10 * number + (text[pos] - '0');
  if (digits == 0) return refuse("SETVN is followed by the number of a variable");
  pos = skipBlanks(text, pos);
  if (pos >= text.size() || text[pos] != '[') return refuse("SETVN n[NAME,NAME] is expected");
  constexpr std::size_t kLongest = 31;
  for (; pos < text.size() && text[pos] != ']'; ++number) {
    pos = skipBlanks(text, pos + 1);
    const std::size_t begin = pos;
    while (pos < text.size() && (isLetter(text[pos]) || isDigit(text[pos]) || text[pos] == '_')) ++pos;
    const std::string_view name = text.substr(begin, pos - begin);
    if (!name.empty() && (isDigit(name[0]) || name.size() > kLongest))
      return refuse("a name has 1 to 31 letters and digits, a letter first");
    if (!name.empty()) c.variables.setName(name, number);
    pos = skipBlanks(text, pos);
    if (pos >= text.size() || (text[pos] != ',' && text[pos] != ']')) return refuse("',' or ']' is expected");
  }
  c.block.statement = pos + 1;
  return true;
}

}  // namespace

Go IsoControl::statement() {
  IsoContext& c = context_;
  run_.blockDone();
  std::size_t pos = c.block.statement;
  switch (c.block.kind) {
    case LineKind::kAssignment: {
      LexError error;
      if (!c.macro.assign(c.block.text, pos, error)) {
        failStatement(c, error);
        return summary_.end == ProgramEnd::kAlarm ? Go::kStop : alarm();  // #3000 ends the run
      }
      return endStatement(c, pos) ? Go::kOn : alarm();
    }
    case LineKind::kIf:
      return behindIf();
    case LineKind::kWhile:
    case LineKind::kDo:
      return enterLoop(pos);
    case LineKind::kEnd:
      return endLoop();
    case LineKind::kGoto:
      return goTo(pos);
    case LineKind::kOutput:
      return outputStatement(c) ? Go::kOn : alarm();
    case LineKind::kNames:
      return nameVariables(c) && endStatement(c, c.block.statement) ? Go::kOn : alarm();
    case LineKind::kBlock:
    case LineKind::kOwn:
      break;
  }
  return execute();
}

/// The condition that stands at `pos`. False: it has none, reported.
bool IsoControl::condition(std::size_t& pos, bool& holds) {
  IsoContext& c = context_;
  LexError error;
  const std::uint64_t place = conditionAt(c.block.text.data() + pos);
  if (!c.macro.condition(c.block.text, pos, holds, error)) return failStatement(c, error);
  c.watch.budget().asked(place, c.macro.distance(), holds);
  return true;
}

Go IsoControl::behindIf() {
  IsoContext& c = context_;
  Block& block = c.block;
  bool holds = false;
  std::size_t pos = block.statement + 2;
  if (!condition(pos, holds)) return stopAtAlarm();
  if (!holds) return Go::kOn;
  pos = skipBlanks(block.text, pos);
  if (keywordAt(block.text, pos, "THEN")) pos = skipBlanks(block.text, pos + 4);
  block.statement = pos;
  block.kind = classify(block.text, pos);
  const bool loop =
      block.kind == LineKind::kWhile || block.kind == LineKind::kDo || block.kind == LineKind::kEnd;
  if (pos >= block.text.size() || loop) {
    c.alarm(SharedAlarm::kSyntax, "", loop ? "a loop cannot start or end behind IF" : "IF without a command");
    return stopAtAlarm();
  }
  if (block.kind != LineKind::kBlock) return statement();
  if (!c.dialect.rules.words_behind_if) {
    c.alarm(SharedAlarm::kMixedBlock, "", "only GOTO or a statement of the macro language stands behind IF",
            {static_cast<int>(pos) + 1, static_cast<int>(block.text.size()) + 1});
    return stopAtAlarm();
  }
  const bool numbered = block.number >= 0;
  const int skip = block.skip;
  if (!lexer_.lexRest(pos, block)) {
    failStatement(c, lexer_.error());
    return alarm();
  }
  if (block.skip != skip || block.program >= 0 || block.percent || (!numbered && block.number >= 0)) {
    c.alarm(SharedAlarm::kSyntax, "", "block number, program number and skip stand in front of IF");
    return alarm();
  }
  MacroCall call;
  if (findCall(true, call)) return callMacro(call);
  return checkRepeats(c) && takeWords(c) ? execute() : alarm();
}

Go IsoControl::goTo(std::size_t pos) {
  IsoContext& c = context_;
  Value target;
  LexError error;
  const std::size_t begin = pos;
  pos = skipBlanks(c.block.text, pos + 4);
  if (!c.macro.evaluate(c.block.text, pos, target, error)) {
    failStatement(c, error);
    return stopAtAlarm();
  }
  const double number = std::round(target.number);
  const IsoRules& rules = c.dialect.rules;
  if (target.vacant || !(number >= static_cast<double>(rules.lowest_jump) && number <= 99999999.0)) {
    c.fail(SharedAlarm::kJumpTarget,
           target.vacant ? "block not found: the number of GOTO is vacant"
                         : fmt::format("block N{} not found", target.number),
           {static_cast<int>(begin) + 1, static_cast<int>(pos) + 1});
    return stopAtAlarm();
  }
  if (!endStatement(c, pos)) return stopAtAlarm();
  CallFrame& frame = c.calls.top();
  const std::size_t from = c.calls.lineIndex();
  if (!jump(frame, static_cast<std::int64_t>(number), frame.next, SharedAlarm::kJumpTarget))
    return stopAtAlarm();
  if (!rules.loops_are_closed) return Go::kOn;
  const LoopIndex::Mark* const loop = frame.text->loops().entered(from, frame.next);
  if (loop == nullptr) return Go::kOn;
  c.fail("goto-into-loop",
         fmt::format("GOTO{0} would enter the loop DO{1} of line {2} without its start: put N{0} in front of "
                     "that line, or leave the loop",
                     static_cast<std::int64_t>(number), loop->number, loop->line + 1),
         {static_cast<int>(begin) + 1, static_cast<int>(pos) + 1});
  return stopAtAlarm();
}

Go IsoControl::enterLoop(std::size_t pos) {
  IsoContext& c = context_;
  const std::string_view text = c.block.text;
  bool holds = true;
  if (c.block.kind == LineKind::kWhile) {
    pos += whileLength(text, pos);
    if (!condition(pos, holds)) return stopAtAlarm();
    pos = skipBlanks(text, pos);
    if (!keywordAt(text, pos, "DO")) {
      c.alarm(SharedAlarm::kWhileWithoutDo, "");
      return stopAtAlarm();
    }
  }
  const LoopIndex::Mark* mark = loopMark(c, skipBlanks(text, pos + 2));
  if (mark == nullptr) return stopAtAlarm();
  if (!holds) {
    c.calls.top().next = mark->partner + 1;
    lexer_.setInComment(false);
  }
  return Go::kOn;
}

Go IsoControl::endLoop() {
  IsoContext& c = context_;
  const LoopIndex::Mark* mark = loopMark(c, skipBlanks(c.block.text, c.block.statement + 3));
  if (mark == nullptr) return stopAtAlarm();
  c.calls.top().next = mark->partner;
  lexer_.setInComment(false);
  return Go::kOn;
}

}  // namespace proveout::nc
