// Program texts of the WL4 control: files with one or more programs, and those that belong to the control.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/text/source_text.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// Lines of a file from behind `%name` to the `%` that ends the program.
struct Wl4Program {
  const SourceText* text = nullptr;
  std::uint32_t file = 0;                      ///< of the path
  std::string name;                            ///< behind %, or empty
  std::size_t first = 0, last = 0;             ///< lines, from and behind
  bool ended = false;                          ///< by a `%` line
  std::map<std::int64_t, std::size_t> labels;  ///< number -> line
  std::size_t label_count = 0;
  std::string_view line(std::size_t index) const { return text->lines()[index]; }
  /// Line of the block with this number, the first in the program, or nothing.
  std::optional<std::size_t> block(std::int64_t number) const;
};

class Wl4Programs {
 public:
  static constexpr std::size_t kMostLabels = 127;  ///< of a program

  Wl4Programs(const ProgramSource& source, TextEncoding encoding, MotionSink& sink)
      : source_(source), encoding_(encoding), sink_(sink) {}

  /// The first program of the main file. Error: cannot be read, no program in it.
  Result<const Wl4Program*> main();
  /// The program of that name ("01", "1", "81"): in the main file, then a file of that name, then the
  /// control's own. Error: none found.
  Result<const Wl4Program*> find(const std::string& name);
  const SourceText& text(std::uint32_t file) const { return *texts_[file]; }

 private:
  Result<const Wl4Program*> load(const ProgramText& text, const std::string& wanted);
  const Wl4Program* split(const SourceText& text, std::uint32_t file);
  void finish(Wl4Program& program);

  const ProgramSource& source_;
  TextEncoding encoding_;
  MotionSink& sink_;
  std::vector<std::unique_ptr<SourceText>> texts_;
  std::deque<Wl4Program> programs_;
  std::map<std::string, const Wl4Program*> known_;
};

/// The text of the control's own program %1 or %81 to %89 as the manual prints it; empty: there is none.
std::string_view wl4OwnProgram(std::string_view name);

}  // namespace proveout::nc
