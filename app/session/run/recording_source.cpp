#include "app/session/run/recording_source.h"

#include <algorithm>

#include "core/base/printable.h"
#include "core/nc/text/source_text.h"
#include "io/job/template_files.h"
#include "io/program_files.h"

namespace proveout {

Result<ProgramText> RecordingSource::keep(Result<ProgramText> text) const {
  if (!text) return text;
  const auto same = [&](const ProgramText& known) { return known.path == text->path; };
  if (std::none_of(texts_.begin(), texts_.end(), same)) texts_.push_back(*text);
  return text;
}

Result<ProgramText> RecordingSource::mainProgram() const { return keep(inner_.mainProgram()); }

Result<ProgramText> RecordingSource::subprogram(const SubprogramQuery& query) const {
  return keep(inner_.subprogram(query));
}

void RecordingSource::addChannel(const ProgramSource& inner) {
  channels_.push_back(std::make_unique<Channel>(*this, inner));
}

std::vector<const ProgramSource*> RecordingSource::channels() const {
  std::vector<const ProgramSource*> all{this};
  for (const auto& channel : channels_) all.push_back(channel.get());
  return all;
}

const TextOrigins* RecordingSource::origins(const std::string& file) const {
  const auto named = [&](const ProgramText& text) { return text.name == file; };
  const auto text = std::find_if(texts_.begin(), texts_.end(), named);
  return text == texts_.end() ? nullptr : text->origins.get();
}

void RecordingSource::readLines(const ProgramText& text) const {
  std::vector<std::string>& own = lines_[text.name];
  const Result<std::string> utf8 = nc::decodeText(text.bytes, encoding_);
  if (!utf8) return;
  const nc::SourceText source(text.name, text.path, *utf8);
  if (text.origins == nullptr) {
    own.assign(source.lines().begin(), source.lines().end());
    return;
  }
  const std::size_t count = std::min(source.lines().size(), text.origins->lines.size());
  for (std::size_t i = 0; i < count; ++i) {
    const TextOrigins::Line& origin = text.origins->lines[i];
    std::vector<std::string>& lines = lines_[text.origins->files[origin.file]];
    if (lines.size() < origin.line) lines.resize(origin.line);
    lines[origin.line - 1] = source.lines()[i];
  }
}

std::string RecordingSource::line(const std::string& file, std::uint32_t number) const {
  for (const ProgramText& text : texts_) {
    if (!lines_.contains(text.name)) readLines(text);
  }
  const auto found = lines_.find(file);
  if (found == lines_.end()) return {};
  return number >= 1 && number <= found->second.size() ? found->second[number - 1] : std::string();
}

bool RecordingSource::has(const std::string& file) const {
  return std::any_of(texts_.begin(), texts_.end(), [&](const ProgramText& text) {
    if (text.name == file) return true;
    if (text.origins == nullptr) return false;
    const std::vector<std::string>& files = text.origins->files;
    return std::find(files.begin(), files.end(), file) != files.end();
  });
}

JobSources::JobSources(const Job& job) {
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const Job part = jobOfSetup(job, k);
    if (part.filled)
      files_.push_back(std::make_unique<TemplateProgramSource>(part.program, *part.filled, part.subprograms));
    else
      files_.push_back(std::make_unique<FileProgramSource>(part.program, part.subprograms));
    sources_.push_back(std::make_unique<RecordingSource>(*files_.back(), part.settings.encoding));
    for (std::size_t i = 1; i < part.channels.size(); ++i) {
      files_.push_back(
          std::make_unique<FileProgramSource>(part.channels[i].program, part.channels[i].subprograms));
      sources_.back()->addChannel(*files_.back());
    }
    all_.push_back(sources_.back().get());
  }
}

BlockRef blockRef(const Toolpath& path, const SourceRef& source, const RecordingSource& texts) {
  BlockRef ref;
  if (source.file < path.files.size()) ref.file = path.files[source.file];
  ref.line = source.line;
  ref.block = source.block;
  ref.depth = source.depth;
  constexpr std::size_t kMostText = 400;  // findings repeat it
  ref.text = shortened(texts.line(ref.file, ref.line), kMostText);
  return ref;
}

LineText lineText(const Toolpath& path, const RecordingSource& texts) {
  return [&path, &texts](std::uint32_t file, std::uint32_t line) {
    return file < path.files.size() ? texts.line(path.files[file], line) : std::string();
  };
}

}  // namespace proveout
