// Alarms of the nct control: the manual's numbers and texts, and how they become diagnostics.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "core/base/diagnostics.h"
#include "core/nc/block.h"
#include "core/nc/nct/call_stack.h"
#include "core/nc/nct/program_store.h"
#include "core/nc/path_emitter.h"

namespace proveout::nc {

/// An alarm of the control. `text` is the manual's, in English; `{}` is the subject (an address, an axis).
struct Alarm {
  int number;
  std::string_view text;
};
/// Sorted by number.
std::span<const Alarm> nctAlarms();
/// The text of an alarm with its subject filled in; without a subject the mark and the blank before it go.
/// Numbers that the table lacks give "alarm of the program".
std::string alarmText(int number, std::string_view subject);

/// Makes diagnostics with their place, the calls that led there and the values of words that came from
/// expressions. One a channel.
class AlarmReporter {
 public:
  AlarmReporter(const CallStack& calls, const ProgramStore& programs, const Block& block,
                const VariableStore& variables, PathEmitter& emitter)
      : calls_(calls), programs_(programs), block_(block), variables_(variables), emitter_(emitter) {}

  /// An alarm with the manual's number: "text of the manual: detail". Always false.
  bool alarm(int number, std::string_view subject, std::string_view detail = {}, Columns at = {});
  /// The same at a word, whose address is the subject. Always false.
  bool alarm(int number, const Word& word, std::string_view detail = {});
  /// An error under its full text: the simulator's own, or an alarm whose text says the detail. Always false.
  bool fail(std::string code, std::string message, Columns at = {});
  void warn(std::string code, std::string message, Columns at = {}, Severity severity = Severity::kWarning);
  /// True the first time that it is asked with this key: warn then, and format the text only then.
  bool firstTime(std::string_view key);

  /// A diagnostic at another place than the block in hand (cutter compensation reports late).
  Diagnostic diagnosticAt(Severity severity, std::string code, std::string message, const SourceRef& at,
                          Columns columns) const;
  void send(const Diagnostic& diagnostic) { emitter_.diagnostic(diagnostic); }

 private:
  void report(Severity severity, std::string code, std::string message, Columns at);
  void addCalls(Diagnostic& d) const;
  void addValues(Diagnostic& d) const;
  void addVariables(Diagnostic& d) const;

  const CallStack& calls_;
  const ProgramStore& programs_;
  const Block& block_;
  const VariableStore& variables_;
  PathEmitter& emitter_;
  std::set<std::string, std::less<>> told_;
};

}  // namespace proveout::nc
