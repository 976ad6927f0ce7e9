#include "core/base/diagnostics.h"

#include <algorithm>
#include <utility>

#include "core/base/printable.h"

namespace proveout {

std::string_view severityName(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "error";
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::kError) ++errors_;
  diagnostic.message = boundedMessage(std::move(diagnostic.message));
  for (std::string& note : diagnostic.notes) note = boundedMessage(std::move(note));
  all_.push_back(std::move(diagnostic));
}

namespace {

bool isUtf8Continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Part of a source line that is shown, with the column range moved along.
struct Excerpt {
  std::string text;
  int column = 0;
  int column_end = 0;
};

/// A program may hold megabytes on one line, and bytes that a terminal obeys: shows a window around the
/// column and a question mark for control characters.
Excerpt excerptOf(const std::string& line, int column, int column_end) {
  constexpr int kWidth = 160;
  constexpr int kBefore = 100;  // bytes kept in front of the column
  const int size = static_cast<int>(line.size());
  int first = size <= kWidth ? 0 : std::clamp(column - 1 - kBefore, 0, size - kWidth);
  int last = std::min(size, first + kWidth);
  while (first > 0 && isUtf8Continuation(line[first])) --first;
  while (last < size && isUtf8Continuation(line[last])) ++last;
  const std::string lead = first > 0 ? "..." : "";
  const int shift = static_cast<int>(lead.size()) - first;
  Excerpt out{lead + line.substr(first, last - first), column + shift,
              std::min(column_end, last + 1) + shift};
  out.text = masked(out.text);
  if (last < size) out.text += "...";
  return out;
}

/// Blanks up to the column (tabs stay tabs, so that the caret stands right in any tab width), then the
/// caret and a tilde for every further character of the range.
std::string caretLine(const Excerpt& shown) {
  std::string text;
  const std::string& line = shown.text;
  const int size = static_cast<int>(line.size());
  for (int i = 0; i < std::min(shown.column - 1, size); ++i) {
    if (!isUtf8Continuation(line[i])) text += line[i] == '\t' ? '\t' : ' ';
  }
  text += '^';
  for (int i = shown.column; i < std::min(shown.column_end - 1, size); ++i) {
    if (!isUtf8Continuation(line[i])) text += '~';
  }
  return text;
}

}  // namespace

std::string formatDiagnostic(const Diagnostic& d) {
  std::string out;
  if (!d.where.file.empty()) out += printable(d.where.file) + ":";
  if (d.where.line > 0) {
    out += std::to_string(d.where.line) + ":";
    if (d.where.column > 0) out += std::to_string(d.where.column) + ":";
  }
  if (!out.empty()) out += ' ';
  out += severityName(d.severity);
  if (!d.code.empty()) out += "[" + printable(d.code) + "]";
  out += ": " + printable(d.message) + "\n";
  if (!d.source_line.empty() && d.where.line > 0) {
    const Excerpt shown = excerptOf(d.source_line, d.where.column, d.where.column_end);
    out += "    " + shown.text + "\n";
    if (d.where.column > 0) out += "    " + caretLine(shown) + "\n";
  }
  for (const std::string& note : d.notes) out += "    note: " + printable(note) + "\n";
  return out;
}

}  // namespace proveout
