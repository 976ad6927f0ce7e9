#include "core/nc/flexnc/flexnc_program.h"

#include <fmt/core.h>

#include <utility>

#include "core/nc/flexnc/flexnc_block.h"

namespace proveout::nc {

Status FlexProgram::load(const ProgramSource& source, TextEncoding encoding, MotionSink& sink) {
  const Result<ProgramText> text = source.mainProgram();
  if (!text) return text.error();
  Result<std::string> utf8 = decodeText(text->bytes, encoding);
  if (!utf8) return inputError(text->name + ": " + utf8.error().message);
  text_ = std::make_unique<SourceText>(text->name, text->path, std::move(*utf8));
  origins_ = text->origins;
  sink.file(0, text->name);
  for (std::size_t k = 0; k < count(); ++k) {
    const std::int64_t number = flexLabelOf(line(k));
    if (number < 0) continue;
    Label& label = labels_[number];
    if (label.count++ == 0) label.line = k;
  }
  if (count() == 0) return inputError(text->name + ": the program is empty");
  return Done{};
}

const FlexProgram::Label* FlexProgram::label(std::int64_t number) const {
  const auto found = labels_.find(number);
  return found == labels_.end() ? nullptr : &found->second;
}

std::uint32_t FlexProgram::cycleFile(const std::string& cycle, std::size_t line, MotionSink& sink) {
  std::string name = fmt::format("{} of line {}", cycle, line + 1);
  if (origins_ != nullptr && line < origins_->lines.size()) {
    const TextOrigins::Line& origin = origins_->lines[line];
    name = fmt::format("{} of {}:{}", cycle, origins_->files[origin.file], origin.line);
  }
  const auto [place, added] = cycles_.emplace(name, static_cast<std::uint32_t>(cycles_.size() + 1));
  if (added) {
    sink.file(place->second, name);
    cycle_lines_.push_back(line);
  }
  return place->second;
}

}  // namespace proveout::nc
