#include "io/job/config_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "core/base/nearest_name.h"
#include "core/base/printable.h"
#include "io/atomic_file.h"

namespace proveout {

namespace fs = std::filesystem;
using Type = ConfigValue::Type;

namespace {

void wrongType(const ConfigDocument& document, const ConfigValue& value, const std::string& what,
               std::string_view expected) {
  document.error(value.place, "job-type",
                 fmt::format("{} must be {}, not {}", what, expected, configTypeName(value.type)));
}

std::string rangeText(const NumberRange& range) {
  return fmt::format("{} {} and at most {}", range.above_min ? "above" : "at least", range.min, range.max);
}

}  // namespace

std::optional<double> readNumber(const ConfigDocument& document, const ConfigValue& value,
                                 const std::string& what, const NumberRange& range) {
  if (value.type != Type::kNumber && value.type != Type::kInteger) {
    wrongType(document, value, what, "a number");
    return std::nullopt;
  }
  const double x = value.number;
  if (!std::isfinite(x) || x < range.min || x > range.max || (range.above_min && x <= range.min)) {
    document.error(value.place, "job-range", fmt::format("{} must be {}, not {}", what, rangeText(range), x));
    return std::nullopt;
  }
  return x;
}

void unknownChoice(const ConfigDocument& document, const ConfigPlace& place, const std::string& what,
                   const std::string& text, const std::vector<std::string>& names) {
  const std::string nearest = nearestName(text, names);
  document.error(place, "job-value",
                 fmt::format("{} '{}' is not known{}; there are {}", what, shortened(text),
                             didYouMean(nearest), fmt::join(names, ", ")));
}

bool isList(const ConfigDocument& document, const ConfigValue& value, const std::string& what) {
  if (value.type == Type::kArray) return true;
  wrongType(document, value, what, "a list");
  return false;
}

std::optional<Vec3> readPoint(const ConfigDocument& document, const ConfigValue& value,
                              const std::string& what, const NumberRange& range) {
  if (value.type != Type::kArray || value.items.size() != 3) {
    document.error(value.place, "job-type", what + " must be a list of three numbers, [x, y, z]");
    return std::nullopt;
  }
  Vec3 point;
  bool good = true;
  for (int i = 0; i < 3; ++i) {
    const auto x = readNumber(document, value.items[i], fmt::format("{}: {}", what, "xyz"[i]), range);
    good = good && x.has_value();
    point[i] = x.value_or(0.0);
  }
  if (!good) return std::nullopt;
  return point;
}

std::optional<std::string> readText(const ConfigDocument& document, const ConfigValue& value,
                                    const std::string& what) {
  if (value.type != Type::kText) {
    wrongType(document, value, what, "a text in quotes");
    return std::nullopt;
  }
  if (value.text.empty() || value.text.find('\0') != std::string::npos) {
    document.error(value.place, "job-range", what + " must not be empty or hold a zero byte");
    return std::nullopt;
  }
  return value.text;
}

std::optional<std::string> readPath(const ConfigDocument& document, const ConfigValue& value,
                                    const std::string& what, PathKind kind) {
  const auto text = readText(document, value, what);
  if (!text) return std::nullopt;
  const std::string path = (fs::path(document.folder) / *text).lexically_normal().string();
  std::error_code error;
  if (kind == PathKind::kFileOrFolder && fs::is_directory(path, error)) return path;
  const Status status = checkRegularFile(path);
  if (!status) {
    document.error(value.place, "job-file", what + ": " + status.error().message);
    return std::nullopt;
  }
  return path;
}

const ConfigEntry* ConfigTable::entry(const std::string& key) {
  constexpr std::size_t kShort = 32;
  if (value_.entries.size() <= kShort) {
    const auto same = [&](const ConfigEntry& entry) { return entry.key == key; };
    const auto found = std::find_if(value_.entries.begin(), value_.entries.end(), same);
    return found == value_.entries.end() ? nullptr : &*found;
  }
  if (index_.empty()) {
    for (const ConfigEntry& entry : value_.entries) index_.emplace(entry.key, &entry);
  }
  const auto found = index_.find(key);
  return found == index_.end() ? nullptr : found->second;
}

const ConfigValue* ConfigTable::find(const std::string& key) {
  if (known_set_.insert(key).second) known_.push_back(key);
  const ConfigEntry* const found = entry(key);
  return found == nullptr ? nullptr : &found->value;
}

const ConfigValue* ConfigTable::require(const std::string& key) {
  const ConfigValue* value = find(key);
  if (value == nullptr) {
    document_.error(value_.place, "job-missing", fmt::format("{} needs the key '{}'", title_, key));
  }
  return value;
}

ConfigPlace ConfigTable::placeOf(const std::string& key) {
  const ConfigEntry* const found = entry(key);
  return found == nullptr ? value_.place : found->value.place;
}

const std::vector<ConfigValue>* ConfigTable::list(const std::string& key, std::size_t most) {
  const ConfigValue* value = find(key);
  if (value == nullptr || !isList(document_, *value, key)) return nullptr;
  if (value->items.size() > most) {
    document_.error(value->place, "job-range",
                    fmt::format("{} has {} entries, {} are allowed", key, value->items.size(), most));
    return nullptr;
  }
  return &value->items;
}

std::optional<double> ConfigTable::number(const std::string& key, const NumberRange& range) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  return readNumber(document_, *value, key, range);
}

std::optional<std::int64_t> ConfigTable::integer(const std::string& key, std::int64_t min, std::int64_t max) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->type != Type::kInteger) {
    wrongType(document_, *value, key, "a whole number");
    return std::nullopt;
  }
  if (value->integer < min || value->integer > max) {
    document_.error(value->place, "job-range",
                    fmt::format("{} must be from {} to {}, not {}", key, min, max, value->integer));
    return std::nullopt;
  }
  return value->integer;
}

std::optional<bool> ConfigTable::flag(const std::string& key) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->type != Type::kBoolean) {
    wrongType(document_, *value, key, "true or false");
    return std::nullopt;
  }
  return value->boolean;
}

std::optional<std::string> ConfigTable::text(const std::string& key) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  return readText(document_, *value, key);
}

std::optional<std::string> ConfigTable::choice(const std::string& key,
                                               const std::vector<std::string>& names) {
  const auto text = this->text(key);
  if (!text) return std::nullopt;
  if (std::find(names.begin(), names.end(), *text) != names.end()) return text;
  unknownChoice(document_, placeOf(key), key, *text, names);
  return std::nullopt;
}

std::optional<Vec3> ConfigTable::point(const std::string& key, const NumberRange& range) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  return readPoint(document_, *value, key, range);
}

std::optional<std::vector<std::string>> ConfigTable::texts(const std::string& key) {
  const std::vector<ConfigValue>* const items = list(key, kMostTables);
  if (items == nullptr) return std::nullopt;
  std::vector<std::string> out;
  for (const ConfigValue& item : *items) {
    const auto text = readText(document_, item, "an entry of " + key);
    if (!text) return std::nullopt;
    out.push_back(*text);
  }
  return out;
}

std::optional<std::string> ConfigTable::path(const std::string& key, PathKind kind) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  return readPath(document_, *value, key, kind);
}

std::optional<ConfigTable> ConfigTable::table(const std::string& key) {
  const ConfigValue* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (value->type != Type::kTable) {
    wrongType(document_, *value, key, "a table");
    return std::nullopt;
  }
  if (title_.starts_with("[[")) return ConfigTable(document_, *value, fmt::format("{}, [{}]", title_, key));
  const std::string outer =
      title_.size() > 2 && title_.front() == '[' ? title_.substr(1, title_.size() - 2) : std::string();
  return ConfigTable(document_, *value, fmt::format("[{}{}{}]", outer, outer.empty() ? "" : ".", key));
}

std::vector<ConfigTable> ConfigTable::tables(const std::string& key, std::size_t most) {
  std::vector<ConfigTable> out;
  if (const ConfigValue* one = find(key); one != nullptr && one->type == Type::kTable) {
    document_.error(one->place, "job-type",
                    fmt::format("{0} must be a list, not a table: write [[{0}]]", key));
    return out;
  }
  const std::vector<ConfigValue>* const items = list(key, most);
  if (items == nullptr) return out;
  for (const ConfigValue& item : *items) {
    if (item.type != Type::kTable) {
      wrongType(document_, item, fmt::format("an entry of [[{}]]", key), "a table");
      continue;
    }
    out.emplace_back(document_, item, fmt::format("[[{}]] {}", key, out.size() + 1));
  }
  return out;
}

void ConfigTable::refuseOthers() const {
  for (const ConfigEntry& entry : value_.entries) {
    if (document_.full()) return;
    if (known_set_.contains(entry.key)) continue;
    const std::string nearest = nearestName(entry.key, known_);
    document_.error(entry.place, "job-unknown-key",
                    fmt::format("{} has no key '{}'; {}", title_, shortened(entry.key),
                                nearest.empty() ? fmt::format("the keys are {}", fmt::join(known_, ", "))
                                                : fmt::format("did you mean '{}'?", nearest)));
  }
}

}  // namespace proveout
