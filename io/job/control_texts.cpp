#include "io/job/control_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/atomic_file.h"

namespace proveout {
namespace {

using Type = ConfigValue::Type;

constexpr std::size_t kMostControlFile = std::size_t{8} << 20;

std::vector<TextSetting> textsOf(const JobNames& names, const std::string& control) {
  const auto found = names.texts.find(control);
  return found == names.texts.end() ? std::vector<TextSetting>() : found->second;
}

/// Texts as they are, numbers and truths as words.
std::string wordOf(const ConfigValue& value) {
  switch (value.type) {
    case Type::kBoolean:
      return value.boolean ? "1" : "0";
    case Type::kInteger:
      return fmt::format("{}", value.integer);
    case Type::kNumber:
      return fmt::format("{}", value.number);
    default:
      return value.text;
  }
}

}  // namespace

ControlTexts::ControlTexts(const ConfigDocument& document, const JobNames& names, const std::string& control,
                           Job& job)
    : document_(document), job_(job), settings_(textsOf(names, control)) {}

bool ControlTexts::take(const ConfigEntry& entry) {
  const auto setting = std::find_if(settings_.begin(), settings_.end(),
                                    [&](const TextSetting& s) { return s.name == entry.key; });
  if (setting == settings_.end()) return false;
  switch (setting->kind) {
    case TextSetting::Kind::kText:
      if (const auto text = readText(document_, entry.value, entry.key))
        job_.settings.texts[entry.key] = *text;
      break;
    case TextSetting::Kind::kFile:
      takeFile(entry, *setting);
      break;
    case TextSetting::Kind::kFolders:
      takeFolders(entry);
      break;
    case TextSetting::Kind::kTable:
      takeTable(entry);
      break;
  }
  return true;
}

void ControlTexts::takeFile(const ConfigEntry& entry, const TextSetting& setting) {
  const auto path = readPath(document_, entry.value, entry.key, PathKind::kFile);
  if (!path) return;
  const Result<std::string> text = readWholeFile(*path, kMostControlFile);
  if (!text) return document_.error(entry.value.place, "job-file", text.error().message);
  job_.settings.texts[entry.key] = *text;
  if (setting.files == nullptr) return;
  const std::string folder = std::filesystem::path(*path).parent_path().string();
  for (const auto& [name, file] : setting.files(*text)) takeNamed(entry, folder, name, file);
}

/// A file or folder that a file of the job names; what the job says itself comes first.
void ControlTexts::takeNamed(const ConfigEntry& entry, const std::string& folder, const std::string& name,
                             const std::string& path) {
  const std::filesystem::path whole = std::filesystem::path(folder) / path;
  const auto setting =
      std::find_if(settings_.begin(), settings_.end(), [&](const TextSetting& s) { return s.name == name; });
  std::error_code fault;
  if (setting != settings_.end() && setting->kind == TextSetting::Kind::kFolders) {
    if (std::filesystem::is_directory(whole, fault)) job_.subprograms.push_back(whole.string());
    return;
  }
  if (job_.settings.texts.contains(name)) return;
  const Result<std::string> text = readWholeFile(whole.string(), kMostControlFile);
  if (!text) {
    return document_.error(entry.value.place, "job-file",
                           fmt::format("{}, which {} names: {}", name, entry.key, text.error().message));
  }
  job_.settings.texts.emplace(name, *text);
}

void ControlTexts::takeFolders(const ConfigEntry& entry) {
  const std::vector<ConfigValue> one{entry.value};
  for (const ConfigValue& item : entry.value.type == Type::kArray ? entry.value.items : one) {
    if (const auto path = readPath(document_, item, entry.key, PathKind::kFileOrFolder))
      job_.subprograms.push_back(*path);
  }
}

void ControlTexts::takeTable(const ConfigEntry& entry) {
  if (entry.value.type != Type::kTable) {
    return document_.error(entry.value.place, "job-type",
                           fmt::format("{} is a table, as {{ NAME = value }}", entry.key));
  }
  for (const ConfigEntry& row : entry.value.entries) {
    const std::string name = entry.key + "." + row.key;
    const bool scalar = row.value.type != Type::kTable && row.value.type != Type::kArray;
    if (scalar) {
      job_.settings.texts[name] = wordOf(row.value);
    } else if (row.value.type == Type::kTable && row.value.entries.size() == 1) {  // G88.6 = ..
      job_.settings.texts[name + "." + row.value.entries[0].key] = wordOf(row.value.entries[0].value);
    } else {
      document_.error(row.value.place, "job-type", fmt::format("{} is a text or a number", name));
    }
  }
}

}  // namespace proveout
