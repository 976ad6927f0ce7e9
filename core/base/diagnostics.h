// Diagnostics: what the program says about its input, in the form of a compiler's messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proveout {

enum class Severity { kNote, kWarning, kError };
std::string_view severityName(Severity severity);  ///< "note", "warning", "error"

/// A place in a program text. Lines and columns count from 1; line 0 means "no line".
/// Columns count bytes of the UTF-8 text as shown; `column_end` is one past the last.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
  int column_end = 0;
};

struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;     ///< stable id, "nct-2017", "job-unknown-key"
  std::string message;  ///< English, says what to do where that is known
  SourceLocation where;
  std::string source_line;         ///< the text of the line, UTF-8, without its end; may be empty
  std::vector<std::string> notes;  ///< for example the call stack, one line each
};

/// Collects diagnostics in order. Not thread-safe: one owner.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  const std::vector<Diagnostic>& all() const { return all_; }
  bool hasErrors() const { return errors_ > 0; }
  int errorCount() const { return errors_; }

 private:
  std::vector<Diagnostic> all_;
  int errors_ = 0;
};

/// "O0100:12:8: error[nct-2017]: text", then the source line and a caret under the column, then the notes.
/// Parts without information are left out. Ends with a newline.
std::string formatDiagnostic(const Diagnostic& diagnostic);

}  // namespace proveout
