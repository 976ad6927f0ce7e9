// Program flow: M98, M99, M2, M30, jumps (manual 14.4).
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {
namespace {

/// "\sub\part.nc" or "..\x.nc" as the program writes it -> with '/', without a leading one (manual 14.4.2:
/// a leading separator is relative to the caller's folder as well).
std::string callPath(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  std::string path(text);
  std::replace(path.begin(), path.end(), '\\', '/');
  const auto first = path.find_first_not_of('/');
  return first == std::string::npos ? std::string() : path.substr(first);
}

/// File name argument of M98 (manual 14.4.2).
constexpr std::size_t kMaxFileArgument = 60;

}  // namespace

NctControl::Go NctControl::flow(const BlockPlan& plan) {
  switch (plan.flow->code) {
    case 98:
      return call();
    case 99:
      return returnFrom();
    default:
      return finish(fmt::format("M{}", plan.flow->code), ProgramEnd::kEndOfProgram);
  }
}

NctControl::Go NctControl::finish(const std::string& code, ProgramEnd end) {
  summary_.end = end;
  if (comp_engaged_ && !flushComp()) {
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  if (settings_.until && !until_hit_) {
    fail("nct-until", "the program ends here; the block to stop after was not reached");
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  emitter_.event("end", {{"code", jsonString(code)}}, 0.0, here());
  return Go::kStop;
}

NctControl::Go NctControl::alarm() {
  if (summary_.errors < settings_.max_errors) return Go::kOn;
  summary_.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

bool NctControl::calledProgram(SubprogramQuery& query) {
  const Word* p = word('P');
  query.caller = stack_.back().text->path();
  if (block_.has_file) {
    if (p) return failWord("nct-2017", "illegal address P: M98 takes P or a file name", *p);
    query.path = callPath(block_.file_arg);
    if (!query.path.empty() && block_.file_arg.size() <= kMaxFileArgument) return true;
    return fail("nct-2002", "file name of M98: 1 to 60 characters", block_.file_columns);
  }
  std::int64_t number = 0;
  if (p == nullptr) return fail("nct-2004", "missing data P: M98 needs a program number or a file name");
  if (!integerWord(*p, 1, 99999999, number)) return false;
  if (number <= 9999) query.stems.push_back(fmt::format("O{:04}", number));
  query.stems.push_back(fmt::format("O{:08}", number));
  return true;
}

NctControl::Go NctControl::call() {
  CallFrame frame;
  SubprogramQuery query;
  const Word* l = word('L');
  if (l && !integerWord(*l, 1, 99999999, frame.total)) return alarm();
  if (!calledProgram(query)) return alarm();
  // The main program is level 0; kMaxNesting calls may be open below it.
  if (stack_.size() > kMaxNesting) {
    fail("nct-nesting", fmt::format("subprogram calls are nested deeper than {}", kMaxNesting));
    return alarm();
  }
  const std::string key = query.caller + '\n' + (query.stems.empty() ? query.path : query.stems.front());
  const auto known = text_by_call_.find(key);
  if (known != text_by_call_.end()) {
    frame.file = known->second;
    frame.text = texts_[frame.file].get();
  } else {
    const Result<ProgramText> text = source_.subprogram(query);
    if (!text.ok()) {
      fail("nct-2147", "file not found: " + text.error().message);
      return alarm();
    }
    frame.text = load(*text, frame.file);
    if (frame.text == nullptr) return alarm();
    text_by_call_[key] = frame.file;
  }
  stack_.push_back(frame);
  return Go::kOn;
}

bool NctControl::jump(CallFrame& frame, std::int64_t block) {
  const SourceText::Label label = frame.text->label(block);
  if (label.line_index == SourceText::kNoLabel) {
    return fail("nct-2125", fmt::format("block N{} not found in {}", block, frame.text->name()));
  }
  if (label.repeated) {
    warnOnce(fmt::format("{}:N{}", frame.file, block), "nct-repeated-n",
             fmt::format("block number N{} occurs more than once: the first one is taken", block));
  }
  frame.line = static_cast<std::size_t>(label.line_index);
  lexer_.setInComment(false);
  return true;
}

NctControl::Go NctControl::returnFrom() {
  // A jump that fails leaves nowhere to go on: it always stops the run.
  const auto stop = [&] {
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  };
  const Word* p = word('P');
  const Word* l = word('L');
  std::int64_t target = -1, repeats = 0;
  if (p && !integerWord(*p, 1, 99999999, target)) return stop();
  if (l && !integerWord(*l, 0, 99999999, repeats)) return stop();
  CallFrame& frame = stack_.back();
  if (stack_.size() == 1) {
    if (l) {
      failWord("nct-2017", "illegal address L: M99 of a main program takes P only", *l);
      return stop();
    }
    if (target >= 0) return jump(frame, target) ? Go::kOn : stop();
    warn("nct-main-m99", "M99 in the main program starts it again: one pass is simulated", {},
         Severity::kNote);
    return finish("M99", ProgramEnd::kEndOfProgram);
  }
  if (l) frame.total = repeats + 1;
  if (target >= 0) frame.return_block = target;
  if (++frame.done < frame.total) {
    frame.line = 0;
    return Go::kOn;
  }
  const std::int64_t back = frame.return_block;
  if (back < 0) {
    stack_.pop_back();
    return Go::kOn;
  }
  const std::size_t caller = stack_.size() - 2;
  if (!jump(stack_[caller], back)) return stop();
  stack_.pop_back();
  return Go::kOn;
}

}  // namespace proveout::nc
