// Program text: bytes decoded to UTF-8 and cut into lines.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/result.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/macro/loop_index.h"
#include "core/nc/text/block.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// Decodes `bytes` to UTF-8 (a byte-order mark is dropped). `chosen` (may be null) gets the name of the
/// encoding. Error: bytes that are no text in that encoding, NUL bytes (binary file, UTF-16), or an
/// encoding that the system cannot convert.
Result<std::string> decodeText(const std::string& bytes, TextEncoding encoding,
                               std::string* chosen = nullptr);

/// A decoded program with its lines and, on demand, its block numbers. Not copyable: lines point into it.
class SourceText {
 public:
  SourceText(std::string name, std::string path, std::string utf8);
  /// One program of a file with several: lines `first` up to `end` (indices) of `whole`. Lines keep their
  /// numbers: those in front of it are blank.
  SourceText(const SourceText& whole, std::size_t first, std::size_t end);
  SourceText(const SourceText&) = delete;
  SourceText& operator=(const SourceText&) = delete;

  const std::string& name() const { return name_; }
  const std::string& path() const { return path_; }
  const std::string& encoding() const { return encoding_; }
  /// Lines without their ends (LF, CR LF or CR); index 0 is line 1.
  const std::vector<std::string_view>& lines() const { return lines_; }

  /// Index of the first line that is the program's own.
  std::size_t firstLine() const { return first_line_; }

  static constexpr int kNoLabel = -1;
  struct Label {
    int line_index = kNoLabel;  ///< of the line that starts with this N number
    bool repeated = false;      ///< the number occurs more than once
  };
  /// Line of block N`number`: the first one at or behind line index `from`, else the first of the text.
  /// Comments are taken into account, and N of data blocks (between G10 L52, L75, L76, L77 and G11) is no
  /// block number. The index is made at the first call.
  Label label(long long number, std::size_t from = 0);
  /// The loops of the text. The index is made at the first call.
  const LoopIndex& loops();

  /// A comment that nobody closes ends with its line. Before labels and loops are asked for.
  void setCommentsEndInLine() { comments_end_in_line_ = true; }
  void setEncoding(std::string name) { encoding_ = std::move(name); }
  /// Part of the control: no program source has this text.
  bool builtIn() const { return built_in_; }
  void setBuiltIn() { built_in_ = true; }

 private:
  void splitLines();
  void indexLabels();
  std::string name_, path_, text_, encoding_;
  std::vector<std::string_view> lines_;
  std::size_t first_line_ = 0;
  struct NumberedLine {
    long long number;
    std::size_t line;
    bool operator<(const NumberedLine& other) const {
      return number != other.number ? number < other.number : line < other.line;
    }
  };
  std::vector<NumberedLine> labels_;  ///< sorted
  bool labels_known_ = false;
  bool built_in_ = false;
  bool comments_end_in_line_ = false;
  std::unique_ptr<const LoopIndex> loops_;
};

/// A diagnostic on a line of the text, without columns on all that the line says; without a text or a line
/// (0) it names no place.
Diagnostic diagnosticAt(const SourceText* text, const SourceRef& at, Columns columns, Severity severity,
                        std::string code, std::string message);
/// A note of a diagnostic: the line, from 1, that calls the program in hand.
std::string calledFrom(const SourceText& text, std::size_t line);

/// A comment in ( ) that nobody has closed.
struct OpenComment {
  std::size_t line = 0;  ///< index of the line in which it begins
  Columns columns;       ///< of its (
};

/// The comment that is open where the text ends, or the tape: a line that begins with %. Comments go on from
/// line to line, and their first ) closes them. Looks from line index `from` on, outside of comments.
std::optional<OpenComment> commentOpenAtEnd(const std::vector<std::string_view>& lines, std::size_t from);

/// The first comment from line index `from` on that its own line does not close.
std::optional<OpenComment> commentOpenInLine(const std::vector<std::string_view>& lines, std::size_t from);

}  // namespace proveout::nc
