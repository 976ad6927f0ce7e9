// O-words, M98 and M99: subs, branches and loops.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {
namespace {

constexpr std::size_t kLcnArguments = 30;

std::string lcnCommand(const LcnOWords::Statement& s) {
  return fmt::format("o{} {}", s.label, lcnKeywordName(s.keyword));
}

}  // namespace

LcnOWords& LinuxCncLanguage::wordsOf(const SourceText& text) {
  std::unique_ptr<LcnOWords>& words = o_words_[&text];
  if (words == nullptr) words = std::make_unique<LcnOWords>(text.lines());
  return *words;
}

/// An O-word that cannot be carried out leaves nowhere to go on.
Go LinuxCncLanguage::oWordFails(StatementFlow& flow, const char* name, const std::string& message) {
  c_.fail(name, message, line_.columnsOf(0, line_.text.size()));
  return flow.failed(true);
}

Go LinuxCncLanguage::evaluationFails(StatementFlow& flow) {
  c_.fail(fault_.name, fault_.message, line_.columnsOf(fault_.begin, fault_.end));
  return flow.failed(true);
}

Go LinuxCncLanguage::seekingFails(StatementFlow& flow, const std::string& label) {
  const SourceText& text = *c_.calls.top().text;
  return oWordFails(flow, "missing-end",
                    fmt::format("EOF in file:{} seeking o-word: o{} from line: {}", text.name(), label,
                                c_.calls.lineIndex() + 1));
}

/// `[expression]` and then nothing. False: fault_ says why.
bool LinuxCncLanguage::condition(std::string_view text, const LcnOWord& word, LcnEvaluator& evaluator,
                                 double& value) {
  std::size_t pos = word.behind;
  if (pos >= text.size() || text[pos] != '[') {
    return fault("left-bracket", fmt::format("Left bracket missing after '{}'", lcnKeywordName(word.keyword)),
                 pos, pos + 1);
  }
  Value out;
  evaluator.forget();
  if (!evaluator.bracket(pos, out)) {
    fault_ = evaluator.fault();
    return false;
  }
  value = out.number;
  return lineEnds(text, pos);
}

bool LinuxCncLanguage::lineEnds(std::string_view text, std::size_t pos) {
  return pos >= text.size() || fault("o-word", "Unexpected character after O-word", pos, text.size());
}

/// Takes another line of the program with an O-word apart, which was read before.
LcnOWord LinuxCncLanguage::oWordOn(std::size_t line, LcnLine& out) const {
  LcnFault none;
  LcnOWord word;
  (void)takeLcnLine(c_.calls.top().text->lines()[line], out, none);
  (void)takeLcnOWord(out.text, out.text.find('o') + 1, word);
  return word;
}

Go LinuxCncLanguage::oWord(StatementFlow& flow) {
  const LcnOWords& words = wordsOf(*c_.calls.top().text);
  switch (o_word_->keyword) {
    case LcnKeyword::kUnknown:
      return oWordFails(flow, "o-word", kUnknownLcnCommand);
    case LcnKeyword::kLabel:
      return Go::kOn;
    case LcnKeyword::kCall:
      return callSub(flow);
    case LcnKeyword::kEndSub:
    case LcnKeyword::kReturn:
      return returnValue(flow);
    default:
      break;
  }
  const std::size_t index = words.on(c_.calls.lineIndex());
  if (index == LcnOWords::kNone) return oWordFails(flow, "o-word", "this O-word cannot be carried out");
  const LcnOWords::Statement& s = words.at(index);
  if (s.clash != LcnOWords::kNone && s.keyword != LcnKeyword::kSub) {
    return oWordFails(flow, "duplicate-label",
                      fmt::format("duplicate O-word label - already defined in line {}: '{}'",
                                  words.at(s.clash).line + 1, lcnCommand(s)));
  }
  switch (s.keyword) {
    case LcnKeyword::kSub:
      return defineSub(words, index, flow);
    case LcnKeyword::kIf:
    case LcnKeyword::kElseIf:
    case LcnKeyword::kElse:
    case LcnKeyword::kEndIf:
      return branch(words, index, flow);
    case LcnKeyword::kBreak:
    case LcnKeyword::kContinue:
      return leaveLoop(words, index, flow);
    default:
      return loop(words, index, flow);
  }
}

/// Goes on behind a statement of the program in hand, which is there (kNone: it is not) and further on. The
/// control reads the lines on the way.
Go LinuxCncLanguage::jumpBehind(const LcnOWords& words, std::size_t statement, StatementFlow& flow) {
  CallFrame& frame = c_.calls.top();
  const std::size_t here = c_.calls.lineIndex();
  const std::size_t line = statement == LcnOWords::kNone ? frame.end : words.at(statement).line;
  if (line < frame.first || line >= frame.end) {
    const std::size_t own = words.on(here);
    return seekingFails(flow, own == LcnOWords::kNone ? std::string() : words.at(own).label);
  }
  if (!readsOver(words, line)) return flow.failed(true);
  frame.next = line + 1;
  return Go::kOn;
}

/// The control reads the lines from the one in hand up to `line`. False: reported.
bool LinuxCncLanguage::readsOver(const LcnOWords& words, std::size_t line) {
  const LcnOWords::Unreadable* u = words.unreadable(c_.calls.lineIndex() + 1, line);
  return u == nullptr ||
         c_.fail(u->name,
                 fmt::format("line {}, which is passed over, cannot be read: {}", u->line + 1, u->message),
                 line_.columnsOf(0, line_.text.size()));
}

/// A sub that the program comes upon is passed over.
Go LinuxCncLanguage::defineSub(const LcnOWords& words, std::size_t index, StatementFlow& flow) {
  const LcnOWords::Statement& s = words.at(index);
  if (s.clash != LcnOWords::kNone) {
    const LcnOWords::Statement& other = words.at(s.clash);
    if (other.label != s.label) return oWordFails(flow, "nested-sub", "Nested subroutine definition");
    return oWordFails(flow, "redefined",
                      fmt::format("redefining sub: o{} already defined in line {}", s.label, other.line + 1));
  }
  const Go go = jumpBehind(words, s.partner, flow);
  if (go == Go::kOn) valueOfDefinition(words.at(s.partner).line);
  return go;
}

/// The control reads the value behind endsub where it passes over a definition, too: #<_value> has it until a
/// call ends; names that are not there yet count 0.
void LinuxCncLanguage::valueOfDefinition(std::size_t line) {
  LcnLine end;
  LcnOWord word = oWordOn(line, end);
  if (word.behind >= end.text.size() || end.text[word.behind] != '[') return;
  LcnEvaluator evaluator(end.text, *this);
  Value value;
  run_.value = evaluator.bracket(word.behind, value) ? value.number : 0.0;
  run_.value_returned = true;
}

/// A branch was taken: the control takes the conditions behind it in hand all the same. False: fault_ says
/// why.
bool LinuxCncLanguage::evaluatesBranches(const LcnOWords& words, std::size_t index) {
  for (std::size_t k = index; k != LcnOWords::kNone; k = words.at(k).partner) {
    if (words.at(k).keyword != LcnKeyword::kElseIf) continue;
    LcnLine line;
    const LcnOWord word = oWordOn(words.at(k).line, line);
    LcnEvaluator evaluator(line.text, *this);
    double value = 0.0;
    if (condition(line.text, word, evaluator, value)) continue;
    fault_.begin = 0;  // its places are those of that line
    fault_.end = line_.text.size();
    return false;
  }
  return true;
}

Go LinuxCncLanguage::branch(const LcnOWords& words, std::size_t index, StatementFlow& flow) {
  const LcnOWords::Statement& s = words.at(index);
  const bool sought = std::exchange(seeking_, false);
  if (s.keyword != LcnKeyword::kIf && s.head == LcnOWords::kNone)
    return oWordFails(flow, "undefined-label", fmt::format("undefined O-word label: '{}'", lcnCommand(s)));
  std::size_t pos = o_word_->behind;
  const bool asks = s.keyword == LcnKeyword::kIf || (s.keyword == LcnKeyword::kElseIf && sought);
  if (!asks && s.keyword != LcnKeyword::kElseIf && !lineEnds(line_.text, pos)) return evaluationFails(flow);
  if (s.keyword == LcnKeyword::kEndIf) return Go::kOn;
  if (s.keyword == LcnKeyword::kElse && sought) return Go::kOn;
  if (asks) {
    LcnEvaluator evaluator(line_.text, *this);
    double value = 0.0;
    if (!condition(line_.text, *o_word_, evaluator, value)) return evaluationFails(flow);
    c_.watch.budget().asked(conditionAt(c_.block.text.data()), evaluator.distance(), value != 0.0);
    if (value != 0.0) {
      if (s.partner == LcnOWords::kNone) missingEnd(s, "endif");
      return Go::kOn;
    }
  }
  // On to the next branch, or behind all of them.
  std::size_t next = s.partner;
  if (!asks) {
    if (!evaluatesBranches(words, index)) return evaluationFails(flow);
    while (next != LcnOWords::kNone && words.at(next).keyword != LcnKeyword::kEndIf)
      next = words.at(next).partner;
  }
  if (const Go go = jumpBehind(words, next, flow); go != Go::kOn) return go;
  if (words.at(next).keyword == LcnKeyword::kElseIf) {
    c_.calls.top().next = words.at(next).line;
    seeking_ = true;
  }
  return Go::kOn;
}

void LinuxCncLanguage::missingEnd(const LcnOWords::Statement& s, const char* end) {
  c_.warnOnce(
      fmt::format("open {} {}", c_.calls.top().file, s.line), "missing-" + std::string(end),
      fmt::format("o{} {} is missing: the control does not see it while the condition holds", s.label, end));
}

namespace {

/// Whether a break of the while stands in it: LinuxCNC 2.9 executes it where it passes over the loop.
bool hasBreak(const LcnOWords& words, std::size_t head) {
  const std::size_t end = words.at(head).partner;
  for (std::size_t k = head + 1; end != LcnOWords::kNone && k < end; ++k)
    if (words.at(k).keyword == LcnKeyword::kBreak && words.at(k).head == head) return true;
  return false;
}

}  // namespace

Go LinuxCncLanguage::loop(const LcnOWords& words, std::size_t index, StatementFlow& flow) {
  const LcnOWords::Statement& s = words.at(index);
  const LcnKeyword keyword = s.keyword;
  const bool ends = keyword == LcnKeyword::kEndWhile || keyword == LcnKeyword::kEndRepeat;
  if (s.partner == LcnOWords::kNone && ends)
    return oWordFails(flow, "undefined-label", fmt::format("undefined O-word label: '{}'", lcnCommand(s)));
  CallFrame& frame = c_.calls.top();
  std::size_t pos = o_word_->behind;
  const bool asks = keyword == LcnKeyword::kWhile || keyword == LcnKeyword::kRepeat;
  double value = 0.0;
  LcnEvaluator evaluator(line_.text, *this);
  if (asks ? !condition(line_.text, *o_word_, evaluator, value) : !lineEnds(line_.text, pos))
    return evaluationFails(flow);
  if (keyword == LcnKeyword::kWhile)
    c_.watch.budget().asked(conditionAt(c_.block.text.data()), evaluator.distance(), value != 0.0);
  if (s.partner == LcnOWords::kNone && (keyword == LcnKeyword::kDo || value >= 0.5)) {
    missingEnd(s, keyword == LcnKeyword::kDo      ? "while"
                  : keyword == LcnKeyword::kWhile ? "endwhile"
                                                  : "endrepeat");
    return Go::kOn;
  }
  switch (keyword) {
    case LcnKeyword::kDo:
      return Go::kOn;
    case LcnKeyword::kWhile:
      if (s.closes_do) return endDo(words, index, value != 0.0, flow);
      if (value != 0.0) return Go::kOn;
      continue_left_ = false;  // the condition would be asked once more, and is false again
      break_left_ = break_left_ || hasBreak(words, index);
      return jumpBehind(words, s.partner, flow);
    case LcnKeyword::kEndWhile:
      frame.next = words.at(s.partner).line;
      return Go::kOn;
    case LcnKeyword::kRepeat: {
      const auto rounds = static_cast<std::int64_t>(std::clamp(value, 0.0, 1e9));
      if (rounds == 0) continue_left_ = false;  // likewise
      if (rounds == 0) return jumpBehind(words, s.partner, flow);
      std::erase_if(repeats_, [&](const Repeat& r) { return r.run == frame.run && r.line == s.line; });
      repeats_.push_back({frame.run, s.line, rounds});
      return Go::kOn;
    }
    default:
      break;
  }
  return endRepeat(words.at(s.partner).line);
}

/// `head`: the line of the repeat.
Go LinuxCncLanguage::endRepeat(std::size_t head) {
  CallFrame& frame = c_.calls.top();
  const auto found = std::find_if(repeats_.begin(), repeats_.end(),
                                  [&](const Repeat& r) { return r.run == frame.run && r.line == head; });
  if (found == repeats_.end()) return Go::kOn;
  c_.watch.budget().asked(conditionAt(c_.block.text.data()), static_cast<double>(found->left),
                          found->left > 1);
  if (--found->left > 0) {
    frame.next = head + 1;
    return Go::kOn;
  }
  repeats_.erase(found);
  if (std::exchange(continue_left_, false)) {
    tellLeftOver("continue", "this repeat runs all its rounds once more");
    frame.next = head;
  }
  return Go::kOn;
}

/// The while that ends a do; `again`: its condition holds.
Go LinuxCncLanguage::endDo(const LcnOWords& words, std::size_t index, bool again, StatementFlow& flow) {
  const bool own = std::exchange(leaves_do_, false), left = std::exchange(break_left_, false);
  if (again && left && !own) tellLeftOver("break", "this do ends though its condition holds");
  return again && !own && !left ? jumpBehind(words, words.at(index).partner, flow) : Go::kOn;
}

void LinuxCncLanguage::tellLeftOver(const char* what, const char* effect) {
  c_.warnOnce(fmt::format("left over {} {}", what, c_.calls.lineIndex()), "left-over",
              fmt::format("LinuxCNC 2.9 has not forgotten a {} of a loop before: {}, as it does there; "
                          "program the loop before without it",
                          what, effect),
              line_.columnsOf(0, line_.text.size()));
}

/// break and continue.
Go LinuxCncLanguage::leaveLoop(const LcnOWords& words, std::size_t index, StatementFlow& flow) {
  const LcnOWords::Statement& s = words.at(index);
  if (s.head == LcnOWords::kNone)
    return oWordFails(flow, "undefined-label", fmt::format("undefined O-word label: '{}'", lcnCommand(s)));
  const LcnOWords::Statement& head = words.at(s.head);
  if (head.keyword != LcnKeyword::kWhile && head.keyword != LcnKeyword::kDo) {
    return oWordFails(flow, "no-loop",
                      fmt::format("no matching while/do label: '{}' (found '{}' in line {})", lcnCommand(s),
                                  lcnKeywordName(head.keyword), head.line + 1));
  }
  if (!lineEnds(line_.text, o_word_->behind)) return evaluationFails(flow);
  if (const Go go = jumpBehind(words, head.partner, flow); go != Go::kOn) return go;
  std::size_t& next = c_.calls.top().next;
  const bool ends = s.keyword == LcnKeyword::kBreak, of_do = head.keyword == LcnKeyword::kDo;
  if (of_do) {  // on to its while, which asks
    next = words.at(head.partner).line;
    (ends ? leaves_do_ : continue_left_) = true;
  } else if (ends) {
    break_left_ = true;
    if (std::exchange(continue_left_, false)) {
      tellLeftOver("continue", "this break does not leave the loop");
      next = head.line;
    }
  } else {
    next = head.line;
  }
  return Go::kOn;
}

/// endsub and return, with a value.
Go LinuxCncLanguage::returnValue(StatementFlow& flow) {
  const bool by_call = !open_.empty() && open_.back().sub;
  if (!by_call) {
    return oWordFails(flow, "no-sub",
                      fmt::format("not in a subroutine definition: 'o{} {}'", lcnLabel(o_word_->label),
                                  lcnKeywordName(o_word_->keyword)));
  }
  std::size_t pos = o_word_->behind;
  Value value;
  const bool any = pos < line_.text.size() && line_.text[pos] == '[';
  if (any) {
    LcnEvaluator evaluator(line_.text, *this);
    if (!evaluator.bracket(pos, value)) {
      fault_ = evaluator.fault();
      return evaluationFails(flow);
    }
  }
  if (!lineEnds(line_.text, pos)) return evaluationFails(flow);
  if (!restoreAtReturn(flow)) return flow.failed(true);
  run_.value = any ? value.number : 0.0;
  run_.value_returned = any;
  flow.statementDone();
  return Go::kReturn;
}

Go LinuxCncLanguage::callSub(StatementFlow& flow) {
  LcnEvaluator evaluator(line_.text, *this);
  std::size_t pos = o_word_->behind;
  std::vector<Value> arguments;
  while (pos < line_.text.size() && line_.text[pos] == '[') {
    if (arguments.size() == kLcnArguments)
      return oWordFails(flow, "arguments", "a sub takes 30 arguments at most");
    Value value;
    evaluator.forget();
    if (!evaluator.bracket(pos, value)) {
      fault_ = evaluator.fault();
      return evaluationFails(flow);
    }
    value.origin = 0;
    arguments.push_back(value);
  }
  std::string label = lcnLabel(o_word_->label);
  if (o_word_->computed) {
    std::size_t at = o_word_->label_at;
    Value value;
    std::int64_t number = 0;
    const bool good = evaluator.value(at, value);
    if (!good || !lcnInteger(value.number, number)) {
      if (good) fault("integer", "Non integer value for integer", o_word_->label_at, at);
      if (!good) fault_ = evaluator.fault();
      return evaluationFails(flow);
    }
    label = fmt::format("{}", number);
  }
  if (!lineEnds(line_.text, pos)) return evaluationFails(flow);
  if (c_.calls.depth() >= kLcnLevels) return oWordFails(flow, "levels", "Too many subroutine levels");
  CallFrame frame;
  if (!findProgram(label, true, frame)) return seekingFails(flow, label);
  if (frame.text == c_.calls.top().text && !readsOver(wordsOf(*frame.text), frame.first))
    return flow.failed(true);
  flow.statementDone();
  variables_.enter(arguments);
  open_.push_back({true});
  return flow.openCall(frame, 1);
}

/// The program of a label: in the text in hand, in the main program, or in a file of its name.
bool LinuxCncLanguage::findProgram(const std::string& label, bool sub, CallFrame& frame) {
  const auto in = [&](SourceText& text, std::uint32_t file) {
    const LcnOWords& words = wordsOf(text);
    const std::size_t found = sub ? words.sub(label) : words.label(label);
    if (found == LcnOWords::kNone) return false;
    const LcnOWords::Statement& s = words.at(found);
    frame.setProgram(text, file);
    frame.first = std::min(s.line + 1, frame.end);
    if (sub && s.partner != LcnOWords::kNone) frame.end = words.at(s.partner).line + 1;
    frame.kind = CallKind::kSubprogram;
    return true;
  };
  const CallFrame& top = c_.calls.top();
  if (in(*top.text, top.file)) return true;
  const CallFrame& main = c_.calls.main();
  if (main.text != top.text && in(*main.text, main.file)) return true;
  const std::string stem = label.starts_with('<') ? label.substr(1, label.size() - 2) : label;
  const ProgramStore::Loaded loaded = c_.programs.byStem(top.file, stem);
  return loaded.text != nullptr && in(*loaded.text, loaded.file);
}

Go LinuxCncLanguage::callNumbered(StatementFlow& flow) {
  const auto word = [&](Address a) { return c_.block.find(a); };
  std::int64_t number = 0, times = 1;
  const Word* const p = word('P');
  const Word* const l = word('L');
  if (p == nullptr) return oWordFails(flow, "missing-word", "Found 'm98' code with no P-word");
  if (!lcnInteger(p->value, number) || (l != nullptr && !lcnInteger(l->value, times)))
    return oWordFails(flow, "integer", "Non integer value for integer");
  if (times < 0) return oWordFails(flow, "negative-word", "Negative l word used");
  if (c_.calls.depth() >= kLcnLevels) return oWordFails(flow, "levels", "Too many subroutine levels");
  CallFrame frame;
  const std::string label = fmt::format("{}", number);
  if (!findProgram(label, false, frame)) return seekingFails(flow, label);
  flow.statementDone();
  if (times == 0) return Go::kOn;
  frame.total = times;
  open_.push_back({false});
  return flow.openCall(frame, static_cast<int>(times));
}

Go LinuxCncLanguage::returnNumbered(StatementFlow& flow) {
  flow.statementDone();
  if (open_.empty()) {
    c_.warn("main-m99", "M99 in the main program starts it again: one pass is simulated", {},
            Severity::kNote);
    return flow.endRun("M99");
  }
  if (open_.back().sub) {
    return oWordFails(flow, "no-sub",
                      "'O.... endsub' or 'O.... return' must follow 'O.... sub' subroutine definition");
  }
  return restoreAtReturn(flow) ? Go::kReturn : flow.failed(true);
}

}  // namespace proveout::nc
