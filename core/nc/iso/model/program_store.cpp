#include "core/nc/iso/model/program_store.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace proveout::nc {

ProgramStore::Loaded ProgramStore::main() { return load(source_.mainProgram()); }

namespace {

/// The file names that controls with several programs in a file know for a number.
SubprogramQuery queryOf(ProgramLayout layout, std::int64_t number) {
  SubprogramQuery query;
  if (number <= 9999) query.stems.push_back(fmt::format("O{:04}", number));
  if (layout == ProgramLayout::kOneInAFile) {
    query.stems.push_back(fmt::format("O{:08}", number));
    return query;
  }
  const auto add = [&](std::string stem) {
    if (std::find(query.stems.begin(), query.stems.end(), stem) == query.stems.end())
      query.stems.push_back(std::move(stem));
  };
  add(fmt::format("O{}", number));
  add(fmt::format("O{:08}", number));
  if (number <= 9999) add(fmt::format("{:04}", number));
  add(fmt::format("{}", number));
  query.extensions = {"", ".nc", ".tap", ".eia", ".txt", ".min", ".cnc"};
  return query;
}

}  // namespace

ProgramStore::Loaded ProgramStore::byNumber(std::uint32_t caller, std::int64_t number, bool folders_first) {
  constexpr std::uint64_t kFoldersFirst = std::uint64_t{1} << 63;
  const std::uint64_t key = ((std::uint64_t{caller} << 32) | static_cast<std::uint32_t>(number)) |
                            (folders_first ? kFoldersFirst : 0);
  if (const auto found = by_number_.find(key); found != by_number_.end()) return known(found->second);
  const auto keep = [&](Loaded loaded) {
    if (loaded.text != nullptr) by_number_[key] = loaded.file;
    return loaded;
  };
  const std::string& path = texts_[caller]->path();
  if (!folders_first) {
    if (const Loaded here = inFile(path, number); here.text != nullptr) return keep(here);
  }
  SubprogramQuery query = queryOf(layout_, number);
  query.caller = path;
  Loaded loaded = load(source_.subprogram(query));
  if (folders_first && loaded.text == nullptr) {
    if (const Loaded here = inFile(path, number); here.text != nullptr) return keep(here);
  }
  return keep(loaded);
}

ProgramStore::Loaded ProgramStore::system(std::int64_t number, int channel) {
  if (layout_ == ProgramLayout::kSeveralInAFile) return byNumber(0, number);
  constexpr std::uint64_t kSystem = 0x8000'0000;  // no file has such an index
  const std::uint64_t key =
      ((kSystem + static_cast<std::uint64_t>(channel)) << 32) | static_cast<std::uint32_t>(number);
  if (const auto found = by_number_.find(key); found != by_number_.end()) return known(found->second);
  SubprogramQuery query;
  query.caller = texts_.front()->path();
  query.stems.push_back(fmt::format("O{:04}", number));
  query.system_channel = channel;
  Loaded loaded = load(source_.subprogram(query));
  if (loaded.text != nullptr) by_number_[key] = loaded.file;
  return loaded;
}

ProgramStore::Loaded ProgramStore::builtIn(const std::string& name, std::string_view text) {
  const Loaded loaded = load(ProgramText{name, name, std::string(text)});
  if (loaded.text != nullptr) loaded.text->setBuiltIn();
  return loaded;
}

ProgramStore::Loaded ProgramStore::byStem(std::uint32_t caller, const std::string& stem) {
  const std::string key = fmt::format("{}\n\n{}", caller, stem);  // no path begins so
  if (const auto found = by_name_.find(key); found != by_name_.end()) return known(found->second);
  SubprogramQuery query;
  query.caller = texts_[caller]->path();
  query.stems.push_back(stem);
  Loaded loaded = load(source_.subprogram(query));
  if (loaded.text != nullptr) by_name_[key] = loaded.file;
  return loaded;
}

ProgramStore::Loaded ProgramStore::byPath(std::uint32_t caller, const std::string& path) {
  const std::string key = fmt::format("{}\n{}", caller, path);
  if (const auto found = by_name_.find(key); found != by_name_.end()) return known(found->second);
  if (const Loaded here = inFile(texts_[caller]->path(), -1, path); here.text != nullptr) {
    by_name_[key] = here.file;
    return here;
  }
  SubprogramQuery query;
  query.caller = texts_[caller]->path();
  query.path = path;
  Loaded loaded = load(source_.subprogram(query));
  if (loaded.text != nullptr) by_name_[key] = loaded.file;
  return loaded;
}

ProgramStore::Loaded ProgramStore::load(const Result<ProgramText>& text) {
  if (!text.ok()) return {nullptr, 0, Failure::kNotFound, text.error().message};
  if (const auto found = by_path_.find(text->path); found != by_path_.end()) return known(found->second);
  std::string encoding;
  Result<std::string> utf8 = decodeText(text->bytes, encoding_, &encoding);
  if (!utf8.ok()) return {nullptr, 0, Failure::kEncoding, text->name + ": " + utf8.error().message};
  auto whole = std::make_unique<SourceText>(text->name, text->path, std::move(*utf8));
  whole->setEncoding(encoding);
  if (layout_ == ProgramLayout::kSeveralInAFile) whole->setCommentsEndInLine();
  std::vector<ProgramHead> heads;
  if (layout_ == ProgramLayout::kSeveralInAFile) heads = programHeads(whole->lines(), true);
  Loaded loaded;
  if (heads.size() > 1) {
    loaded = keep(std::make_unique<SourceText>(*whole, 0, heads[1].line));
    files_[text->path] = {std::move(whole), std::move(heads)};
  } else {
    loaded = keep(std::move(whole));
    if (!heads.empty()) files_[text->path] = {nullptr, std::move(heads)};
  }
  by_path_[text->path] = loaded.file;
  return loaded;
}

ProgramStore::Loaded ProgramStore::keep(std::unique_ptr<SourceText> text) {
  PROVEOUT_ASSERT(text != nullptr);
  const auto file = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::move(text));
  sink_.file(file, texts_.back()->name());
  return known(file);
}

namespace {

/// `name` empty: by its number.
bool named(const ProgramHead& head, std::int64_t number, std::string_view name) {
  return name.empty() ? head.number == number : head.name == name;
}

}  // namespace

/// The program of that number in a file with several; without a text where it has none.
ProgramStore::Loaded ProgramStore::inFile(const std::string& path, std::int64_t number,
                                          std::string_view name) {
  const auto file = files_.find(path);
  if (file == files_.end()) return {};
  const std::vector<ProgramHead>& heads = file->second.heads;
  const SourceText* const whole = file->second.text.get();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    if (!named(heads[k], number, name)) continue;
    const auto again = std::find_if(heads.begin() + static_cast<std::ptrdiff_t>(k) + 1, heads.end(),
                                    [&](const ProgramHead& head) { return named(head, number, name); });
    const auto part = [&] {
      const std::size_t end = k + 1 < heads.size() ? heads[k + 1].line : whole->lines().size();
      return std::make_unique<SourceText>(*whole, heads[k].line, end);
    };
    Loaded loaded = k == 0 ? known(by_path_.at(path)) : keep(part());
    loaded.again = again == heads.end() ? 0 : again->line + 1;
    return loaded;
  }
  return {};
}

}  // namespace proveout::nc
