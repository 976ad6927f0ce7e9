#include "core/nc/nct/model/program_store.h"

#include <fmt/core.h>

#include <utility>

namespace proveout::nc {

ProgramStore::Loaded ProgramStore::main() { return load(source_.mainProgram()); }

ProgramStore::Loaded ProgramStore::byNumber(std::uint32_t caller, std::int64_t number) {
  const std::uint64_t key = (std::uint64_t{caller} << 32) | static_cast<std::uint32_t>(number);
  if (const auto found = by_number_.find(key); found != by_number_.end()) return known(found->second);
  SubprogramQuery query;
  query.caller = texts_[caller]->path();
  if (number <= 9999) query.stems.push_back(fmt::format("O{:04}", number));
  query.stems.push_back(fmt::format("O{:08}", number));
  Loaded loaded = load(source_.subprogram(query));
  if (loaded.text != nullptr) by_number_[key] = loaded.file;
  return loaded;
}

ProgramStore::Loaded ProgramStore::system(std::int64_t number, int channel) {
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

ProgramStore::Loaded ProgramStore::byPath(std::uint32_t caller, const std::string& path) {
  const std::string key = fmt::format("{}\n{}", caller, path);
  if (const auto found = by_name_.find(key); found != by_name_.end()) return known(found->second);
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
  const auto file = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::make_unique<SourceText>(text->name, text->path, std::move(*utf8)));
  texts_.back()->setEncoding(encoding);
  by_path_[text->path] = file;
  sink_.file(file, text->name);
  return known(file);
}

}  // namespace proveout::nc
