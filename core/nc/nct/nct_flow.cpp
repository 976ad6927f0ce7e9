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
      return call(plan);
    case 99:
      return returnFrom(plan);
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
  emitter_.event("end", {{"code", jsonString(code)}}, 0.0, here());
  return Go::kStop;
}

NctControl::Go NctControl::call(const BlockPlan&) {
  const auto failed = [&](bool) {
    if (summary_.errors < settings_.max_errors) return Go::kOn;
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  };
  const Word* p = word('P');
  const Word* l = word('L');
  CallFrame frame;
  if (l && !integerWord(*l, 1, 99999999, frame.total)) return failed(false);
  SubprogramQuery query;
  query.caller = stack_.back().text->path();
  if (block_.has_file) {
    if (p) return failed(failWord("nct-2017", "illegal address P: M98 takes P or a file name", *p));
    query.path = callPath(block_.file_arg);
    if (query.path.empty() || block_.file_arg.size() > kMaxFileArgument) {
      return failed(fail("nct-2002", "file name of M98: 1 to 60 characters", block_.file_columns));
    }
  } else {
    std::int64_t number = 0;
    if (p == nullptr)
      return failed(fail("nct-2004", "missing data P: M98 needs a program number or a file name"));
    if (!integerWord(*p, 1, 99999999, number)) return failed(false);
    if (number <= 9999) query.stems.push_back(fmt::format("O{:04}", number));
    query.stems.push_back(fmt::format("O{:08}", number));
  }
  // The main program is level 0; kMaxNesting calls may be open below it.
  if (stack_.size() > kMaxNesting) {
    return failed(
        fail("nct-nesting", fmt::format("subprogram calls are nested deeper than {}", kMaxNesting)));
  }
  const Result<ProgramText> text = source_.subprogram(query);
  if (!text.ok()) return failed(fail("nct-2147", "file not found: " + text.error().message));
  frame.text = load(*text, frame.file);
  if (frame.text == nullptr) return failed(false);
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

NctControl::Go NctControl::returnFrom(const BlockPlan&) {
  const auto alarm = [&] {
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  };
  const Word* p = word('P');
  const Word* l = word('L');
  std::int64_t target = -1, repeats = 0;
  if (p && !integerWord(*p, 1, 99999999, target)) return alarm();
  if (l && !integerWord(*l, 0, 99999999, repeats)) return alarm();
  CallFrame& frame = stack_.back();
  if (stack_.size() == 1) {
    if (l) {
      failWord("nct-2017", "illegal address L: M99 of a main program takes P only", *l);
      return alarm();
    }
    if (target >= 0) return jump(frame, target) ? Go::kOn : alarm();
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
  if (!jump(stack_[caller], back)) return alarm();
  stack_.pop_back();
  return Go::kOn;
}

}  // namespace proveout::nc
