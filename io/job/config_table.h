// Reads one table of a configuration: every key is asked for by name, type and range, and what nobody asked
// for is an error. Errors become diagnostics; a reader that gets nothing back just goes on, so that all are
// reported.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/geometry/types.h"
#include "io/job/config_tree.h"

namespace proveout {

/// The document that tables belong to.
struct ConfigDocument {
  ConfigText text;
  std::string folder;  ///< what relative paths are resolved against
  Diagnostics* diagnostics = nullptr;
  bool programs_in_memory = false;  ///< programs are names, not files that must be there

  bool full() const { return fullOfErrors(*diagnostics); }
  void error(const ConfigPlace& place, std::string code, std::string message) const {
    addConfigError(*diagnostics, text, place, std::move(code), std::move(message));
  }
};

/// Finite numbers from `min` to `max`; `above_min` leaves out `min` itself.
struct NumberRange {
  double min = -1e6, max = 1e6;
  bool above_min = false;
};
/// Coordinates and lengths: up to 1 km, so that squares and differences stay exact enough.
inline constexpr NumberRange kAnyLength{-1e6, 1e6, false};
inline constexpr NumberRange kPositiveLength{0.0, 1e6, true};
inline constexpr NumberRange kLengthOrZero{0.0, 1e6, false};

/// Tables of one name, and points of an outline: more are no machine's and no tool's.
inline constexpr std::size_t kMostTables = 10'000;
inline constexpr std::size_t kMostPoints = 1'000;

enum class PathKind { kFile, kFileOrFolder };

class ConfigTable {
 public:
  /// `title` names the table in messages: "[stock]", "[[tool]] 5". All three must outlive the reader.
  ConfigTable(const ConfigDocument& document, const ConfigValue& value, std::string title)
      : document_(document), value_(value), title_(std::move(title)) {}

  const ConfigDocument& document() const { return document_; }
  const ConfigPlace& place() const { return value_.place; }
  const std::string& title() const { return title_; }
  const std::vector<ConfigEntry>& entries() const { return value_.entries; }

  /// The value of a key, whatever its type; null if it is not there. The key counts as known from here on.
  const ConfigValue* find(const std::string& key);
  /// The same, and its absence is an error.
  const ConfigValue* require(const std::string& key);
  /// Place of a key, or of the table.
  ConfigPlace placeOf(const std::string& key);
  void error(const std::string& key, std::string code, std::string message) {
    document_.error(placeOf(key), std::move(code), std::move(message));
  }

  std::optional<double> number(const std::string& key, const NumberRange& range);
  std::optional<std::int64_t> integer(const std::string& key, std::int64_t min, std::int64_t max);
  std::optional<bool> flag(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  /// One of `names`; the error lists them.
  std::optional<std::string> choice(const std::string& key, const std::vector<std::string>& names);
  std::optional<Vec3> point(const std::string& key, const NumberRange& range = kAnyLength);
  std::optional<std::vector<std::string>> texts(const std::string& key);
  /// A path, resolved against the document's folder, that exists and can be read.
  std::optional<std::string> path(const std::string& key, PathKind kind = PathKind::kFile);
  std::optional<ConfigTable> table(const std::string& key);
  /// An array of tables, at most `most`; the titles are "[[key]] 1", ...
  std::vector<ConfigTable> tables(const std::string& key, std::size_t most = kMostTables);
  /// Key that must be there; the readers above then report what is wrong with it.
  ConfigTable& must(const std::string& key) {
    require(key);
    return *this;
  }

  /// The items of a list of at most `most`, counted before anything is made of them. Nothing, and where there
  /// is a value an error, if it is no list or too long.
  const std::vector<ConfigValue>* list(const std::string& key, std::size_t most);

  /// Reports every key that was not asked for, with the nearest one that was. Call last.
  void refuseOthers() const;

 private:
  const ConfigEntry* entry(const std::string& key);

  const ConfigDocument& document_;
  const ConfigValue& value_;
  std::string title_;
  std::vector<std::string> known_;             ///< keys that were asked for
  std::unordered_set<std::string> known_set_;  ///< the same
  std::unordered_map<std::string_view, const ConfigEntry*>
      index_;  ///< of a long table, once it was asked for
};

/// Checks of single values, for lists and tables with free keys. `what` names the value in messages.
std::optional<double> readNumber(const ConfigDocument& document, const ConfigValue& value,
                                 const std::string& what, const NumberRange& range);
std::optional<Vec3> readPoint(const ConfigDocument& document, const ConfigValue& value,
                              const std::string& what, const NumberRange& range);
std::optional<std::string> readText(const ConfigDocument& document, const ConfigValue& value,
                                    const std::string& what);
std::optional<std::string> readPath(const ConfigDocument& document, const ConfigValue& value,
                                    const std::string& what, PathKind kind);
/// Reports a text that is none of `names`, with the nearest one.
void unknownChoice(const ConfigDocument& document, const ConfigPlace& place, const std::string& what,
                   const std::string& text, const std::vector<std::string>& names);
/// False, and an error, if the value is not a list.
bool isList(const ConfigDocument& document, const ConfigValue& value, const std::string& what);

}  // namespace proveout
