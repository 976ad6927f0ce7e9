#include "core/nc/wedm/wedm_program.h"

#include <utility>

namespace proveout::nc {

namespace {

/// The blocks of a line; `;` in a comment ends none.
void cutLine(std::string_view text, std::uint32_t line, std::vector<WedmProgram::Place>& places) {
  std::uint32_t begin = 0;
  bool comment = false;
  for (std::uint32_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(') comment = true;
    if (text[k] == ')') comment = false;
    if (comment || text[k] != ';') continue;
    places.push_back({line, begin, k, true});
    begin = k + 1;
  }
  if (text.find_first_not_of(" \t\r", begin) == std::string_view::npos) return;
  places.push_back({line, begin, static_cast<std::uint32_t>(text.size()), false});
}

bool endsProgram(const WedmBlock& block) {
  const WedmWord* const m = block.find('M');
  return m != nullptr && m->code == 2;
}

}  // namespace

Status WedmProgram::load(const ProgramSource& source, TextEncoding encoding, MotionSink& sink) {
  const Result<ProgramText> text = source.mainProgram();
  if (!text) return text.error();
  Result<std::string> utf8 = decodeText(text->bytes, encoding);
  if (!utf8) return inputError(text->name + ": " + utf8.error().message);
  text_ = std::make_unique<SourceText>(text->name, text->path, std::move(*utf8));
  sink.file(0, text->name);
  for (std::size_t k = 0; k < text_->lines().size(); ++k)
    cutLine(text_->lines()[k], static_cast<std::uint32_t>(k), places_);
  if (places_.empty()) return inputError(text->name + ": the program is empty");
  return Done{};
}

std::optional<std::size_t> WedmProgram::subprogram(std::int64_t number) {
  if (!indexed_) indexSubprograms();
  const auto found = subprograms_.find(number);
  return found == subprograms_.end() ? std::nullopt : std::optional(found->second);
}

void WedmProgram::indexSubprograms() {
  indexed_ = true;
  WedmReader reader;
  WedmBlock block;
  bool behind_end = false;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    // A bad block is reported when it runs; its N is read all the same.
    const bool good = reader.read(line(k), places_[k].begin, places_[k].end, block);
    if (behind_end && block.number >= 0) subprograms_.emplace(block.number, k);
    behind_end = behind_end || (good && endsProgram(block));
  }
}

}  // namespace proveout::nc
