#include "core/nc/iso/model/alarm_reporter.h"

#include <fmt/core.h>

#include <utility>

#include "core/nc/iso/model/system_calls.h"

namespace proveout::nc {

bool AlarmReporter::alarm(SharedAlarm what, std::string_view subject, std::string_view detail, Columns at) {
  return fail(what, table_.message(what, subject, detail), at);
}

bool AlarmReporter::alarm(SharedAlarm what, const Word& word, std::string_view detail) {
  return alarm(what, wordName(word, block_), detail, word.columns);
}

bool AlarmReporter::fail(const DiagnosticName& name, std::string message, Columns at) {
  report(Severity::kError, table_.code(name), std::move(message), at);
  return false;
}

bool AlarmReporter::fail(const LexError& error) {
  report(Severity::kError, error.code, error.message, error.columns);
  return false;
}

void AlarmReporter::raise(int number, std::string message) {
  report(Severity::kError, table_.code(number), std::move(message), {});
}

void AlarmReporter::warn(const DiagnosticName& name, std::string message, Columns at, Severity severity) {
  report(severity, table_.code(name), std::move(message), at);
}

bool AlarmReporter::firstTime(std::string_view key) {
  if (told_.find(key) != told_.end()) return false;
  told_.emplace(key);
  return true;
}

void AlarmReporter::report(Severity severity, std::string code, std::string message, Columns at) {
  Diagnostic d = diagnosticAt(severity, std::move(code), std::move(message), calls_.here(), at);
  if (!calls_.empty()) addCalls(d.notes);
  if (severity == Severity::kError) addValues(d.notes);
  emitter_.diagnostic(d);
}

std::uint32_t AlarmReporter::remember() {
  if (calls_.depth() <= 1 && !computed()) return 0;
  remembered_.resize(kRemembered);
  if (++last_record_ == 0) ++last_record_;
  Notes& notes = remembered_[last_record_ % kRemembered];
  notes.clear();
  addCalls(notes);
  if (computed()) addValues(notes);
  return last_record_;
}

void AlarmReporter::sendLate(Severity severity, const DiagnosticName& name, std::string message,
                             const SourceRef& at, std::uint32_t record) {
  Diagnostic d = diagnosticAt(severity, table_.code(name), std::move(message), at, {});
  if (record != 0) d.notes = remembered_[record % kRemembered];
  emitter_.diagnostic(d);
}

Diagnostic AlarmReporter::diagnosticAt(Severity severity, std::string code, std::string message,
                                       const SourceRef& at, Columns columns) const {
  const SourceText* const text = calls_.empty() ? nullptr : &programs_.text(at.file);
  return nc::diagnosticAt(text, at, columns, severity, std::move(code), std::move(message));
}

namespace {

/// "G65", "M98", "G101 (system call)": what opened the program.
std::string callName(const CallFrame& called) {
  if (called.interrupt) return "the interrupt (M96)";
  if (called.system_code < 0) return std::string(callKindName(called.kind));
  return systemCodeName(called.system_code) + " (system call)";
}

}  // namespace

void AlarmReporter::addCalls(Notes& notes) const {
  for (std::size_t level = calls_.depth(); level-- > 1;) {
    const CallFrame& caller = calls_.at(level - 1);
    const CallFrame& called = calls_.at(level);
    std::string note = calledFrom(*caller.text, caller.next) + " by " + callName(called);
    if (opensLocals(called.kind)) {
      for (std::size_t n = 1; n < called.args.v.size(); ++n) {
        if (!called.args.v[n].vacant) note += fmt::format(" #{}={}", n, called.args.v[n].number);
      }
    }
    notes.push_back(std::move(note));
  }
}

void AlarmReporter::addVariables(Notes& notes) const {
  const std::string_view text = block_.text;
  constexpr int kMaxNotes = 8;
  std::array<int, kMaxNotes> told{};
  int count = 0;
  for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i + 1)) {
    int number = -1;
    std::from_chars(text.data() + i + 1, text.data() + text.size(), number);
    Value value;
    if (count == kMaxNotes || !variables_.peek(number, value)) continue;
    if (std::find(told.begin(), told.begin() + count, number) != told.begin() + count) continue;
    told[static_cast<std::size_t>(count++)] = number;
    notes.push_back(value.vacant ? fmt::format("#{} is vacant", number)
                                 : fmt::format("#{} = {}", number, value.number));
  }
}

bool AlarmReporter::computed() const {
  return std::any_of(block_.words.begin(), block_.words.end(),
                     [](const Word& w) { return w.from_expression; });
}

void AlarmReporter::addValues(Notes& notes) const {
  if (!computed()) addVariables(notes);
  for (const Word& w : block_.words) {
    if (!w.from_expression) continue;
    const auto begin = static_cast<std::size_t>(w.columns.begin - 1);
    const auto length = static_cast<std::size_t>(w.columns.end - w.columns.begin);
    if (begin + length > block_.text.size()) continue;
    notes.push_back(fmt::format("{} = {}", block_.text.substr(begin, length), w.value));
  }
}

}  // namespace proveout::nc
