// A TOML document as plain data with places, so that only one source file needs the TOML library.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"

namespace proveout {

/// Where something stands in the text; lines and columns from 1, columns in bytes, end exclusive.
struct ConfigPlace {
  int line = 0, column = 0, column_end = 0;
};

struct ConfigEntry;

struct ConfigValue {
  enum class Type : std::uint8_t { kBoolean, kInteger, kNumber, kText, kDate, kArray, kTable };
  Type type = Type::kTable;
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0.0;  ///< also set for integers
  std::string text;
  std::vector<ConfigValue> items;    ///< of an array
  std::vector<ConfigEntry> entries;  ///< of a table, in the order of the text
  ConfigPlace place;
};

struct ConfigEntry {
  std::string key;
  ConfigPlace place;  ///< of the key
  ConfigValue value;
};

std::string_view configTypeName(ConfigValue::Type type);  ///< "a number", "a table", ...

/// A text with its name, for diagnostics that show the line.
struct ConfigText {
  std::string name;
  std::vector<std::string> lines;
};
/// So many errors of a file are told, and then that there are more.
inline constexpr int kMostConfigErrors = 20;
/// Nothing more will be told: what is found from here on need not be put into words.
bool fullOfErrors(const Diagnostics& diagnostics);

/// Of a text with more lines than parseToml() takes, the first ones.
ConfigText splitConfigText(std::string name, std::string_view text);
/// Does nothing where enough errors were told.
void addConfigError(Diagnostics& diagnostics, const ConfigText& text, const ConfigPlace& place,
                    std::string code, std::string message);

/// Parses TOML 1.0. A syntax error becomes a diagnostic with its place, and there is no tree.
std::optional<ConfigValue> parseToml(std::string_view toml, const ConfigText& text, Diagnostics& diagnostics);

}  // namespace proveout
