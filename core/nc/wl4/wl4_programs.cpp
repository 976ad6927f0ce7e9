#include "core/nc/wl4/wl4_programs.h"

#include <fmt/core.h>

#include <utility>

#include "core/nc/wl4/wl4_block.h"

namespace proveout::nc {

namespace {

std::string_view trimmed(std::string_view line) {
  const std::size_t from = line.find_first_not_of(" \t");
  if (from == std::string_view::npos) return {};
  return line.substr(from, line.find_last_not_of(" \t\r") + 1 - from);
}

/// The name on a `%` line: up to a blank or a comment.
std::string nameOn(std::string_view line) {
  const std::string_view name = trimmed(line).substr(1);
  return std::string(name.substr(0, name.find_first_of(" \t$")));
}

}  // namespace

std::optional<std::size_t> Wl4Program::block(std::int64_t number) const {
  for (std::size_t k = first; k < last; ++k) {
    if (blockNumberOf(line(k)) == number) return k;
  }
  return std::nullopt;
}

Result<const Wl4Program*> Wl4Programs::main() {
  const Result<ProgramText> text = source_.mainProgram();
  if (!text) return text.error();
  return load(*text, {});
}

Result<const Wl4Program*> Wl4Programs::find(const std::string& name) {
  if (const auto found = known_.find(name); found != known_.end()) return found->second;
  SubprogramQuery query;
  query.caller = texts_.front()->path();
  query.stems = {name};
  const Result<ProgramText> text = source_.subprogram(query);
  if (text) return load(*text, name);
  const std::string_view own = wl4OwnProgram(name);
  // A file that was found and refused is not replaced by another program.
  if (own.empty() || source_.finds(query)) return text.error();
  const auto loaded = load({"%" + name, "%" + name, std::string(own)}, name);
  if (loaded) texts_.back()->setBuiltIn();
  return loaded;
}

Result<const Wl4Program*> Wl4Programs::load(const ProgramText& text, const std::string& wanted) {
  Result<std::string> utf8 = decodeText(text.bytes, encoding_);
  if (!utf8) return inputError(text.name + ": " + utf8.error().message);
  const auto file = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::make_unique<SourceText>(text.name, text.path, std::move(*utf8)));
  sink_.file(file, text.name);
  const Wl4Program* first = split(*texts_.back(), file);
  if (first == nullptr) return inputError(text.name + ": the program is empty");
  if (wanted.empty()) return first;
  if (const auto found = known_.find(wanted); found != known_.end() && found->second->file == file)
    return found->second;
  known_[wanted] = first;  // a file may have another name inside
  return first;
}

const Wl4Program* Wl4Programs::split(const SourceText& text, std::uint32_t file) {
  const std::size_t count = text.lines().size();
  const Wl4Program* first = nullptr;
  const auto fresh = [&] {
    Wl4Program program;
    program.text = &text;
    program.file = file;
    return program;
  };
  Wl4Program open = fresh();
  bool begun = false;
  const auto close = [&](std::size_t last, bool ended) {
    if (!begun) return;
    open.last = last;
    open.ended = ended;
    programs_.push_back(std::move(open));
    finish(programs_.back());
    if (first == nullptr) first = &programs_.back();
    open = fresh();
    begun = false;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::string_view line = trimmed(text.lines()[k]);
    if (line.empty() || line.front() != '%') {
      if (!begun && !line.empty()) {
        open.first = k;
        begun = true;
      }
      continue;
    }
    const std::string name = nameOn(line);
    close(k, name.empty());
    if (name.empty()) continue;
    open.name = name;
    open.first = k + 1;
    begun = true;
  }
  close(count, false);
  return first;
}

void Wl4Programs::finish(Wl4Program& program) {
  for (std::size_t k = program.first; k < program.last; ++k) {
    const std::int64_t label = labelOf(program.line(k));
    if (label < 0) continue;
    ++program.label_count;
    program.labels.emplace(label, k);
  }
  if (!program.name.empty()) known_.emplace(program.name, &program);
}

}  // namespace proveout::nc
