// Reports of a channel: alarms of the control and the simulator's own words, as diagnostics.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/nc/iso/model/call_stack.h"
#include "core/nc/iso/model/program_store.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/text/alarms.h"
#include "core/nc/text/block.h"
#include "core/nc/text/lexer.h"

namespace proveout::nc {

/// Makes diagnostics with their place, the calls that led there and the values of words that came from
/// expressions. One a channel.
class AlarmReporter {
 public:
  AlarmReporter(const AlarmTable& alarms, const CallStack& calls, const ProgramStore& programs,
                const Block& block, const VariableStore& variables, PathEmitter& emitter)
      : table_(alarms),
        calls_(calls),
        programs_(programs),
        block_(block),
        variables_(variables),
        emitter_(emitter) {}

  const AlarmTable& table() const { return table_; }
  /// An alarm of the manual: "text of the manual: detail". Always false.
  bool alarm(SharedAlarm what, std::string_view subject, std::string_view detail = {}, Columns at = {});
  /// The same at a word, whose address is the subject. Always false.
  bool alarm(SharedAlarm what, const Word& word, std::string_view detail = {});
  /// An error under its full text: the simulator's own, or an alarm whose text says the detail. Always false.
  bool fail(const DiagnosticName& name, std::string message, Columns at = {});
  /// What the lexer or a formula refused. Always false.
  bool fail(const LexError& error);
  /// An alarm that the program raises by number.
  void raise(int number, std::string message);
  void warn(const DiagnosticName& name, std::string message, Columns at = {},
            Severity severity = Severity::kWarning);
  /// True the first time that it is asked with this key: warn then, and format the text only then.
  bool firstTime(std::string_view key);

  /// Remembers the calls and values of the block in hand for sendLate(): for blocks that a stage of the pipe
  /// keeps back. 0 where there is nothing to remember: a plain block of the main program. The last 256 are
  /// kept.
  std::uint32_t remember();
  /// A diagnostic at a block that has gone by (cutter compensation reports late); `record` is from
  /// remember().
  void sendLate(Severity severity, const DiagnosticName& name, std::string message, const SourceRef& at,
                std::uint32_t record);

 private:
  void report(Severity severity, std::string code, std::string message, Columns at);
  using Notes = std::vector<std::string>;
  Diagnostic diagnosticAt(Severity severity, std::string code, std::string message, const SourceRef& at,
                          Columns columns) const;
  bool computed() const;
  void addCalls(Notes& notes) const;
  void addValues(Notes& notes) const;
  void addVariables(Notes& notes) const;

  const AlarmTable& table_;
  const CallStack& calls_;
  const ProgramStore& programs_;
  const Block& block_;
  const VariableStore& variables_;
  PathEmitter& emitter_;
  std::set<std::string, std::less<>> told_;
  static constexpr std::size_t kRemembered = 256;  ///< more than the stages keep back
  std::vector<Notes> remembered_;                  ///< by record modulo their number
  std::uint32_t last_record_ = 0;
};

}  // namespace proveout::nc
