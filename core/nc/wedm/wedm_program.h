// The text of a program of the wire EDM control, cut into blocks: `;` ends one, and so does the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/text/source_text.h"
#include "core/nc/wedm/wedm_block.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

class WedmProgram {
 public:
  struct Place {
    std::uint32_t line = 0;            ///< index
    std::uint32_t begin = 0, end = 0;  ///< in the line, without the `;`
    bool closed = false;               ///< by a `;`
  };

  /// Error: the text cannot be read.
  Status load(const ProgramSource& source, TextEncoding encoding, MotionSink& sink);
  const SourceText& text() const { return *text_; }
  std::size_t count() const { return places_.size(); }
  const Place& place(std::size_t block) const { return places_[block]; }
  std::string_view line(std::size_t block) const { return text_->lines()[places_[block].line]; }
  /// The block that begins with that N number, the first one behind M02. The index is made at the first call.
  std::optional<std::size_t> subprogram(std::int64_t number);

 private:
  void indexSubprograms();

  std::unique_ptr<SourceText> text_;
  std::vector<Place> places_;
  std::map<std::int64_t, std::size_t> subprograms_;
  bool indexed_ = false;
};

}  // namespace proveout::nc
