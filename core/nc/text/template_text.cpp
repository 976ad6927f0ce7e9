#include "core/nc/text/template_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "core/base/memory_limit.h"
#include "core/base/nearest_name.h"
#include "core/nc/text/source_text.h"

namespace proveout::nc {

namespace {

constexpr std::string_view kDeclares = "//@";
constexpr std::size_t kMaxParameters = 1000;
constexpr std::size_t kMostLine = std::size_t{4} << 20;  ///< bytes of values that are filled into a line

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> numberOf(std::string_view text) {
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool inRange(const TemplateParameter& p, double number) {
  return (!p.min || number >= *p.min) && (!p.max || number <= *p.max);
}

class Reader {
 public:
  Reader(Template& text, Diagnostics& diagnostics) : text_(text), diagnostics_(diagnostics) {}

  void line(std::size_t index) {
    line_ = index;
    const std::string& line = text_.lines[index];
    if (trimmed(line).starts_with(kDeclares)) {
      declaration(line.find(kDeclares) + kDeclares.size());
    } else {
      uses(line);
    }
  }

  void error(std::size_t begin, std::size_t end, std::string message) {
    Diagnostic d;
    d.code = "template";
    d.message = std::move(message);
    d.where = {text_.name, static_cast<int>(line_) + 1, static_cast<int>(begin) + 1,
               static_cast<int>(end) + 1};
    d.source_line = text_.lines[line_];
    diagnostics_.add(std::move(d));
  }

 private:
  SourceLocation at(std::size_t begin, std::size_t end) const {
    return {text_.name, static_cast<int>(line_) + 1, static_cast<int>(begin) + 1, static_cast<int>(end) + 1};
  }

  /// `[name] = 40, 10..200: meaning` from a column on.
  void declaration(std::size_t from) {
    const std::string& line = text_.lines[line_];
    const std::size_t open = line.find_first_not_of(" \t", from), close = line.find(']', from);
    if (open == std::string::npos || line[open] != '[' || close == std::string::npos || close < open + 2)
      return error(from, line.size(), "a declaration is //@ [name] = default, min..max: meaning");
    TemplateParameter parameter;
    parameter.name = line.substr(open + 1, close - open - 1);
    parameter.where = at(open, close + 1);
    if (parameter.name.find('[') != std::string::npos)
      return error(open, close + 1, "a name has no brackets");
    const std::size_t colon = line.find(':', close);
    if (colon != std::string::npos)
      parameter.meaning = std::string(trimmed(std::string_view(line).substr(colon + 1)));
    const std::size_t end = std::min(colon, line.size());
    if (!numbers(trimmed(std::string_view(line).substr(close + 1, end - close - 1)), parameter))
      return error(close + 1, end, "between name and meaning stands = default, min..max, or one of the two");
    if (parameter.min && parameter.max && !(*parameter.min <= *parameter.max))
      return error(close + 1, end, "the range is empty");
    if (parameter.value && !inRange(parameter, *numberOf(*parameter.value)))
      return error(close + 1, end, "the default is not in the range");
    TemplateParameter& known = parameterNamed(parameter.name, open, close + 1);
    if (const auto [first, is_new] = declared_.emplace(parameter.name, line_ + 1); !is_new)
      return error(open, close + 1,
                   fmt::format("[{}] is declared in line {} already", known.name, first->second));
    parameter.used = known.used;
    known = std::move(parameter);
  }

  /// The parameter of that name; a new one where there is none.
  TemplateParameter& parameterNamed(const std::string& name, std::size_t begin, std::size_t end) {
    const auto [known, is_new] = number_.emplace(name, text_.parameters.size());
    if (is_new) {
      TemplateParameter& parameter = text_.parameters.emplace_back();
      parameter.name = name;
      parameter.where = at(begin, end);
    }
    return text_.parameters[known->second];
  }

  /// False: neither default nor range.
  static bool numbers(std::string_view text, TemplateParameter& parameter) {
    if (text.empty()) return true;
    const bool with_default = text.starts_with('=');
    if (with_default) text.remove_prefix(1);
    const std::size_t comma = with_default ? text.find(',') : std::string_view::npos;
    if (with_default) {
      const std::string_view value = trimmed(text.substr(0, comma));
      if (!numberOf(value)) return false;
      parameter.value = std::string(value);
      if (comma == std::string_view::npos) return true;
      text = text.substr(comma + 1);
    }
    text = trimmed(text);
    if (!with_default && text.starts_with(',')) text = trimmed(text.substr(1));
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return false;
    const std::string_view low = trimmed(text.substr(0, dots)), high = trimmed(text.substr(dots + 2));
    parameter.min = numberOf(low);
    parameter.max = numberOf(high);
    return (low.empty() || parameter.min) && (high.empty() || parameter.max) &&
           !(low.empty() && high.empty());
  }

  void uses(const std::string& line) {
    const std::size_t comment = line.find("//");
    for (std::size_t i = 0; i < std::min(comment, line.size()); ++i) {
      if (line[i] == ']') return error(i, i + 1, "] without [");
      if (line[i] != '[') continue;
      const std::size_t close = line.find_first_of("[]", i + 1);
      if (close == std::string::npos || line[close] == '[' || close > comment)
        return error(i, i + 1, "[ without ]: the name of a parameter stands in brackets");
      if (close == i + 1) return error(i, close + 1, "a parameter without name");
      parameterNamed(line.substr(i + 1, close - i - 1), i, close + 1).used = true;
      i = close;
    }
  }

  Template& text_;
  Diagnostics& diagnostics_;
  std::size_t line_ = 0;
  std::map<std::string, std::size_t> number_, declared_;  ///< of a parameter; line of its declaration
};

/// The line with the values of the names in it; in comments names without value stay.
std::string filled(const std::string& line,
                   const std::function<const std::string*(const std::string&)>& valueOf) {
  std::string out;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t close = line[i] == '[' ? line.find_first_of("[]", i + 1) : std::string::npos;
    const bool named = close != std::string::npos && line[close] == ']';
    const std::string* value = named ? valueOf(line.substr(i + 1, close - i - 1)) : nullptr;
    if (value != nullptr) {
      out += *value;
      i = close + 1;
    } else {
      out += line[i++];
    }
  }
  return out;
}

std::string rangeText(const TemplateParameter& p) {
  if (p.min && p.max) return fmt::format("from {:g} to {:g}", *p.min, *p.max);
  return p.min ? fmt::format("at least {:g}", *p.min) : fmt::format("at most {:g}", *p.max);
}

/// Of the shell's containers the pictures are binary.
bool isContainer(const std::string& bytes) {
  return bytes.find('\0') != std::string::npos || bytes.starts_with("BM") || bytes.starts_with("PK\x03\x04");
}

}  // namespace

const TemplateParameter* Template::find(const std::string& parameter) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const TemplateParameter& p) { return p.name == parameter; });
  return found == parameters.end() ? nullptr : &*found;
}

std::vector<std::string> Template::names() const {
  std::vector<std::string> out;
  for (const TemplateParameter& p : parameters) out.push_back(p.name);
  return out;
}

std::optional<Template> readTemplate(const ProgramText& text, TextEncoding encoding,
                                     Diagnostics& diagnostics) {
  const auto refuse = [&](std::string message) {
    Diagnostic d;
    d.code = "template";
    d.message = std::move(message);
    d.where.file = text.name;
    diagnostics.add(std::move(d));
    return std::nullopt;
  };
  if (text.bytes.size() > kMaxTemplateBytes)
    return refuse(fmt::format("larger than {} MiB: no template", kMaxTemplateBytes >> 20));
  if (isContainer(text.bytes))
    return refuse(
        "this is a container of the FlexNC shell, whose format is not published: export as .pmc (Save Text)");
  const Result<std::string> utf8 = decodeText(text.bytes, encoding);
  if (!utf8) return refuse(utf8.error().message);
  const SourceText source(text.name, text.path, *utf8);
  Template out;
  out.name = text.name;
  out.lines.assign(source.lines().begin(), source.lines().end());
  const int before = diagnostics.errorCount();
  Reader reader(out, diagnostics);
  for (std::size_t i = 0; i < out.lines.size() && out.parameters.size() <= kMaxParameters; ++i) {
    if (diagnostics.errorCount() - before >= kMostTemplateErrors) break;
    reader.line(i);
  }
  if (out.parameters.size() > kMaxParameters)
    return refuse(fmt::format("more than {} parameters: no template", kMaxParameters));
  if (diagnostics.errorCount() != before) return std::nullopt;
  return out;
}

std::string refusalOf(const Template& text, const std::string& parameter, const std::string& value) {
  const TemplateParameter* const known = text.find(parameter);
  if (known == nullptr) {
    const std::string nearest = nearestName(parameter, text.names());
    if (!nearest.empty())
      return fmt::format("{} has no parameter [{}]; do you mean [{}]?", text.name, parameter, nearest);
    return fmt::format(
        "{} has no parameter [{}]; it has {}", text.name, parameter,
        text.parameters.empty() ? "none" : fmt::format("[{}]", fmt::join(text.names(), "], [")));
  }
  if (value.empty()) return fmt::format("[{}] is empty: all fields must be filled in", parameter);
  const std::optional<double> number = numberOf(value);
  if (!number) return fmt::format("[{}] must be a decimal number, not '{}'", parameter, value);
  if (!inRange(*known, *number))
    return fmt::format("[{}] must be {}, not {}", parameter, rangeText(*known), value);
  return {};
}

namespace {

/// Why so much filled text is refused; empty: it is not.
std::string tooLarge(std::size_t bytes, std::size_t lines) {
  if (bytes > kMaxFilledBytes)
    return fmt::format("the program gets larger than {} MiB", kMaxFilledBytes >> 20);
  constexpr std::size_t kLook = 1024;  // lines
  constexpr double kCopies = 4.0;      // still to be made
  if (lines % kLook != 0) return {};
  const Status fits = memoryFor(kCopies * static_cast<double>(bytes), "the filled program");
  return fits ? std::string() : fits.error().message;
}

}  // namespace

std::optional<std::vector<std::string>> fillTemplate(const Template& text, const TemplateValues& values,
                                                     Diagnostics& diagnostics) {
  bool whole = true;
  TemplateValues all = values;
  for (const TemplateParameter& p : text.parameters) {
    if (all.contains(p.name)) continue;
    if (p.value) {
      all[p.name] = *p.value;
    } else if (p.used) {
      std::vector<std::string> given;
      for (const auto& [name, value] : values) given.push_back(name);
      const std::string nearest = nearestName(p.name, given);
      Diagnostic d;
      d.code = "template";
      d.message = fmt::format("[{}] has no value: all fields must be filled in{}", p.name,
                              nearest.empty() ? "" : fmt::format("; [{}] has one", nearest));
      d.where = p.where;
      d.source_line = text.lines[static_cast<std::size_t>(p.where.line) - 1];
      diagnostics.add(std::move(d));
      whole = false;
    }
  }
  if (!whole) return std::nullopt;
  std::vector<std::string> out;
  std::size_t bytes = 0;
  for (const std::string& line : text.lines) {
    const bool declares = trimmed(line).starts_with(kDeclares);
    std::size_t in_line = 0;  // of values
    out.push_back(declares ? std::string() : filled(line, [&](const std::string& name) -> const std::string* {
      const auto value = all.find(name);
      if (value == all.end()) return nullptr;
      in_line += value->second.size();
      return in_line > kMostLine ? nullptr : &value->second;
    }));
    bytes += out.back().size() + 1;
    std::string why = tooLarge(bytes, out.size());
    if (in_line > kMostLine) why = fmt::format("the filled line has more than {} bytes", kMostLine);
    if (why.empty()) continue;
    Diagnostic d;
    d.code = "template";
    d.message = std::move(why);
    d.where = {text.name, static_cast<int>(out.size()), 0, 0};
    diagnostics.add(std::move(d));
    return std::nullopt;
  }
  return out;
}

}  // namespace proveout::nc
