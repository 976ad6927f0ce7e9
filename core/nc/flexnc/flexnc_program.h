// The text of a program of the FlexNC control and its labels; names of the cycles that its lines run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/text/source_text.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

class FlexProgram {
 public:
  struct Label {
    std::size_t line = 0;  ///< index of the first line that begins with it
    int count = 0;         ///< lines that begin with it
  };

  /// Error: the text cannot be read.
  Status load(const ProgramSource& source, TextEncoding encoding, MotionSink& sink);
  const SourceText& text() const { return *text_; }
  std::size_t count() const { return text_->lines().size(); }
  std::string_view line(std::size_t index) const { return text_->lines()[index]; }
  /// Null: no line begins with it.
  const Label* label(std::int64_t number) const;

  /// The file of the path that stands for the motions of the cycle on that line (index): its lines are their
  /// numbers.
  std::uint32_t cycleFile(const std::string& cycle, std::size_t line, MotionSink& sink);
  /// Index of the line that runs the cycle with that file, 1 and up.
  std::size_t cycleLine(std::uint32_t file) const { return cycle_lines_[file - 1]; }

 private:
  std::shared_ptr<const TextOrigins> origins_;  ///< of its lines, if they are other files'
  std::unique_ptr<SourceText> text_;
  std::map<std::int64_t, Label> labels_;
  std::map<std::string, std::uint32_t> cycles_;  ///< by name of their files
  std::vector<std::size_t> cycle_lines_;         ///< by file
};

}  // namespace proveout::nc
