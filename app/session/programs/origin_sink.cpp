#include "app/session/programs/origin_sink.h"

#include <algorithm>
#include <charconv>

namespace proveout {

namespace {

/// A place "NAME:LINE" of the text within a note, as the place of the file.
std::string placedNote(const std::string& note, const std::string& name, const TextOrigins& origins) {
  const std::size_t at = note.find(name + ":");
  if (at == std::string::npos) return note;
  const char* const begin = note.data() + at + name.size() + 1;
  std::uint32_t line = 0;
  const auto [end, error] = std::from_chars(begin, note.data() + note.size(), line);
  if (error != std::errc() || line < 1 || line > origins.lines.size()) return note;
  const TextOrigins::Line& origin = origins.lines[line - 1];
  return note.substr(0, at) + origins.files[origin.file] + ":" + std::to_string(origin.line) +
         std::string(end, note.data() + note.size());
}

}  // namespace

void OriginSink::file(std::uint32_t index, const std::string& name) {
  if (files_.size() <= index) files_.resize(index + 1);
  const TextOrigins* const origins = source_.origins(name);
  files_[index] = {sent_, origins};
  if (origins == nullptr) return next_.file(sent_++, name);
  for (const std::string& part : origins->files) next_.file(sent_++, part);
}

void OriginSink::place(std::uint32_t& file, std::uint32_t& line) const {
  if (file >= files_.size()) return;
  const File& known = files_[file];
  file = known.first;
  if (known.origins == nullptr || line < 1 || line > known.origins->lines.size()) return;
  const TextOrigins::Line& origin = known.origins->lines[line - 1];
  file += origin.file;
  line = origin.line;
}

void OriginSink::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
  Motion placed = motion;
  place(placed.source.file, placed.source.line);
  next_.motion(placed, arc, axis);
}

void OriginSink::wireMotion(const Motion& motion, const WireSweep& wire) {
  Motion placed = motion;
  place(placed.source.file, placed.source.line);
  next_.wireMotion(placed, wire);
}

void OriginSink::event(const PathEvent& event) {
  PathEvent placed = event;
  place(placed.source.file, placed.source.line);
  next_.event(placed);
}

void OriginSink::originWord(const WordOrigin& word) {
  WordOrigin placed = word;
  place(placed.file, placed.line);
  next_.originWord(placed);
}

void OriginSink::diagnostic(const Diagnostic& diagnostic) {
  const std::string name = diagnostic.where.file;
  const TextOrigins* const origins = source_.origins(name);
  if (origins == nullptr) return next_.diagnostic(diagnostic);
  Diagnostic placed = diagnostic;
  const auto line = static_cast<std::size_t>(std::max(0, placed.where.line));
  if (line >= 1 && line <= origins->lines.size()) {
    placed.where.file = origins->files[origins->lines[line - 1].file];
    placed.where.line = static_cast<int>(origins->lines[line - 1].line);
  }
  for (std::string& note : placed.notes) note = placedNote(note, name, *origins);
  next_.diagnostic(placed);
}

}  // namespace proveout
