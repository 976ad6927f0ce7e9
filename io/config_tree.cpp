#include "io/config_tree.h"

#include <algorithm>
#include <utility>

// The library is used without exceptions: a bad document is an expected failure.
#define TOML_EXCEPTIONS 0
// Its assertions fail on some bad documents (`[[ = 1`), whose faults it reports behind them, and would end
// the program. With NDEBUG it would take what they say for granted.
#undef NDEBUG
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

namespace proveout {

namespace {

/// The TOML library counts code points, diagnostics count bytes.
int byteColumn(const std::string& line, std::uint32_t code_point_column) {
  std::size_t at = 0;
  for (std::uint32_t left = code_point_column; left > 1 && at < line.size(); --left) {
    ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80) ++at;
  }
  return static_cast<int>(at) + 1;
}

class TreeBuilder {
 public:
  explicit TreeBuilder(const ConfigText& text) : text_(text) {}

  ConfigPlace place(const toml::source_region& region) const {
    ConfigPlace out;
    out.line = static_cast<int>(region.begin.line);
    if (out.line < 1 || out.line > static_cast<int>(text_.lines.size())) return {};
    const std::string& line = text_.lines[out.line - 1];
    out.column = byteColumn(line, region.begin.column);
    // A value that goes over several lines is underlined to the end of its first.
    out.column_end = region.end.line == region.begin.line ? byteColumn(line, region.end.column)
                                                          : static_cast<int>(line.size()) + 1;
    return out;
  }

  ConfigValue convert(const toml::node& node) const {
    ConfigValue value;
    value.place = place(node.source());
    if (const toml::table* table = node.as_table()) {
      addEntries(*table, value);
    } else if (const toml::array* array = node.as_array()) {
      value.type = ConfigValue::Type::kArray;
      for (const toml::node& item : *array) value.items.push_back(convert(item));
    } else {
      setScalar(node, value);
    }
    return value;
  }

 private:
  void addEntries(const toml::table& table, ConfigValue& value) const {
    value.type = ConfigValue::Type::kTable;
    for (const auto& [key, node] : table) {
      value.entries.push_back({std::string(key.str()), place(key.source()), convert(node)});
    }
    // The library sorts by key; people read from top to bottom.
    std::stable_sort(value.entries.begin(), value.entries.end(), [](const auto& a, const auto& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
  }

  static void setScalar(const toml::node& node, ConfigValue& value) {
    if (const auto* integer = node.as_integer()) {
      value.type = ConfigValue::Type::kInteger;
      value.integer = integer->get();
      value.number = static_cast<double>(integer->get());
    } else if (const auto* number = node.as_floating_point()) {
      value.type = ConfigValue::Type::kNumber;
      value.number = number->get();
    } else if (const auto* text = node.as_string()) {
      value.type = ConfigValue::Type::kText;
      value.text = text->get();
    } else if (const auto* boolean = node.as_boolean()) {
      value.type = ConfigValue::Type::kBoolean;
      value.boolean = boolean->get();
    } else {
      value.type = ConfigValue::Type::kDate;
    }
  }

  const ConfigText& text_;
};

/// As deep as the library lets lists nest.
constexpr std::size_t kMaxDepth = TOML_MAX_NESTED_VALUES;

/// Finds what the library is not to be given. Each part of a dotted key is a table, and whoever walks the
/// tree, or frees it, needs stack for each level; the library limits lists and tables in braces only.
/// Characters beyond ASCII are allowed in texts and comments only; of some that stand elsewhere it says what
/// it holds for impossible.
class TextCheck {
 public:
  explicit TextCheck(std::string_view toml) : rest_(toml) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) take(kByteOrderMark.size());
  }

  /// What is wrong first, or "". The place is the one at which the search has ended.
  std::string find() {
    while (!rest_.empty()) {
      if (static_cast<unsigned char>(rest_.front()) >= 0x80)
        return "a character that is not ASCII: texts and keys with such stand in quotes";
      step();
      if (depth_ > kMaxDepth)
        return "a key with more than " + std::to_string(kMaxDepth) + " dots: tables do not go so deep";
    }
    return {};
  }
  ConfigPlace place() const { return {line_, static_cast<int>(column_), static_cast<int>(column_) + 1}; }

 private:
  void step() {
    if ((rest_.starts_with(R"(""")") || rest_.starts_with("'''")) && mayBeginText())
      return skipString(rest_.substr(0, 3));
    const char c = rest_.front();
    if ((c == '"' || c == '\'') && mayBeginText()) return skipString(rest_.substr(0, 1));
    if (c == '#') return take(std::min(rest_.find('\n'), rest_.size()));
    if (c == '.') ++open_.back();
    if (c == '.') ++depth_;
    if (c == ',' || (c == '\n' && open_.size() == 1)) endKey();
    if (c == '[' || c == '{') open_.push_back(0);
    if ((c == ']' || c == '}') && open_.size() > 1) {
      endKey();
      open_.pop_back();
    }
    take(1);
  }

  /// Quotes within a word begin no text: `x = 99"` is a word to its end.
  bool mayBeginText() const {
    return last_ == 0 || std::string_view(" \t\r\n=[]{},.").find(last_) != std::string_view::npos;
  }

  void skipString(std::string_view quotes) {
    take(quotes.size());
    while (!rest_.empty() && !rest_.starts_with(quotes) && (quotes.size() == 3 || rest_.front() != '\n'))
      take(rest_.front() == '\\' && quotes.front() == '"' ? 2 : 1);
    take(quotes.size());
    // Before the closing quotes of a text of several lines there may be two that belong to it.
    while (quotes.size() == 3 && rest_.starts_with(quotes.front())) take(1);
  }

  void endKey() {
    depth_ -= open_.back();
    open_.back() = 0;
  }

  void take(std::size_t count) {
    for (const char c : rest_.substr(0, count)) {
      ++column_;
      if (c != '\n') continue;
      ++line_;
      column_ = 1;
    }
    count = std::min(count, rest_.size());
    if (count > 0) last_ = rest_[count - 1];
    rest_.remove_prefix(count);
  }

  std::string_view rest_;
  char last_ = 0;  ///< before the rest; 0 at the beginning
  int line_ = 1;
  std::size_t column_ = 1;
  std::vector<std::size_t> open_ = {0};  ///< dots of the key at hand, in each bracket that is open
  std::size_t depth_ = 0;                ///< their sum
};

}  // namespace

std::string_view configTypeName(ConfigValue::Type type) {
  switch (type) {
    case ConfigValue::Type::kBoolean:
      return "true or false";
    case ConfigValue::Type::kInteger:
      return "a whole number";
    case ConfigValue::Type::kNumber:
      return "a number";
    case ConfigValue::Type::kText:
      return "a text";
    case ConfigValue::Type::kDate:
      return "a date or time";
    case ConfigValue::Type::kArray:
      return "a list";
    case ConfigValue::Type::kTable:
      return "a table";
  }
  return "a value";
}

ConfigText splitConfigText(std::string name, std::string_view text) {
  ConfigText out{std::move(name), {}};
  while (true) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    out.lines.emplace_back(line);
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + 1);
  }
}

void addConfigError(Diagnostics& diagnostics, const ConfigText& text, const ConfigPlace& place,
                    std::string code, std::string message) {
  Diagnostic d;
  d.code = std::move(code);
  d.message = std::move(message);
  d.where = {text.name, place.line, place.column, place.column_end};
  if (place.line >= 1 && place.line <= static_cast<int>(text.lines.size())) {
    d.source_line = text.lines[place.line - 1];
  }
  diagnostics.add(std::move(d));
}

std::optional<ConfigValue> parseToml(std::string_view toml, const ConfigText& text,
                                     Diagnostics& diagnostics) {
  TextCheck check(toml);
  if (std::string wrong = check.find(); !wrong.empty()) {
    addConfigError(diagnostics, text, check.place(), "job-syntax", std::move(wrong));
    return std::nullopt;
  }
  const toml::parse_result result = toml::parse(toml);
  const TreeBuilder builder(text);
  if (!result) {
    const toml::parse_error& error = result.error();
    addConfigError(diagnostics, text, builder.place(error.source()), "job-syntax",
                   std::string(error.description()));
    return std::nullopt;
  }
  return builder.convert(result.table());
}

}  // namespace proveout
