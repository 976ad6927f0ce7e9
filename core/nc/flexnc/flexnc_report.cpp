#include "core/nc/flexnc/flexnc_report.h"

#include <fmt/core.h>

#include <utility>

namespace proveout::nc {

namespace {

const char* codeOf(CompFault fault) {
  switch (fault) {
    case CompFault::kNegativeRadius:
      return "fnc-comp-radius";
    case CompFault::kTooShort:
      return "fnc-comp-short";
    default:
      return "fnc-compensation";
  }
}

}  // namespace

SourceRef FlexReport::here() {
  SourceRef at;
  if (levels_.empty()) return at;
  at.line = static_cast<std::uint32_t>(levels_.back().block + 1);
  at.block = levels_.back().number;
  at.depth = static_cast<decltype(at.depth)>(levels_.size() - 1);
  if (cycle_.file != 0) {
    at.file = cycle_.file;
    at.line = cycle_.motion;
    at.block = -1;
    ++at.depth;
  }
  at.origins = recorder_.index();
  return at;
}

SourceRef FlexReport::written(const SourceRef& at) const {
  if (at.file == 0) return at;
  SourceRef block = at;
  block.file = 0;
  block.line = static_cast<std::uint32_t>(program_.cycleLine(at.file) + 1);
  return block;
}

void FlexReport::tell(Severity severity, const SourceRef& at, Columns columns, std::string code,
                      std::string message) {
  const SourceText* const text = levels_.empty() ? nullptr : &program_.text();
  const SourceRef block = written(at);
  Diagnostic d = diagnosticAt(text, block, columns, severity, std::move(code), std::move(message));
  for (std::size_t level = levels_.size(); level-- > 1 && block.line > 0;)
    d.notes.push_back(calledFrom(*text, levels_[level - 1].block + 1));
  emitter_.diagnostic(d);
}

bool FlexReport::fail(std::string code, std::string message, Columns at) {
  tell(Severity::kError, here(), at, std::move(code), std::move(message));
  return false;
}

void FlexReport::warnOnce(const std::string& key, std::string code, std::string message, Columns at) {
  if (told_.insert(key).second) warn(std::move(code), std::move(message), at);
}

void FlexReport::note(const std::string& key, std::string code, std::string message, Columns at) {
  if (told_.insert(key).second) tell(Severity::kNote, here(), at, std::move(code), std::move(message));
}

void FlexReport::compError(CompFault fault, const std::string& message, const SourceRef& at) {
  tell(Severity::kError, at, {}, codeOf(fault), message);
}

void FlexReport::compWarning(CompFault fault, const std::string& message, const SourceRef& at) {
  const std::string key = fmt::format("{} {}", codeOf(fault), written(at).line);
  if (told_.insert(key).second) tell(Severity::kWarning, at, {}, codeOf(fault), message);
}

}  // namespace proveout::nc
