#include "core/nc/text/template_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/base/memory_limit.h"

namespace proveout::nc {

namespace {

std::string extensionOf(std::string_view name) {
  const auto dot = name.rfind('.');
  std::string out(dot == std::string_view::npos ? std::string_view() : name.substr(dot));
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

bool isSet(std::string_view name) { return extensionOf(name) == ".tmps"; }

constexpr std::size_t kNowhere = std::string::npos;

/// Where the name of a template begins in a line of a set; kNowhere: the line is program text.
std::size_t elementAt(const std::string& line) {
  const std::size_t at = line.find_first_not_of(" \t");
  return at != kNowhere && line[at] == '@' ? line.find_first_not_of(" \t", at + 1) : kNowhere;
}
bool isElement(const std::string& line) {
  const std::size_t at = line.find_first_not_of(" \t");
  return at != kNowhere && line[at] == '@';
}

class Filler {
 public:
  Filler(const TemplateLoader& load, TextEncoding encoding, Diagnostics& diagnostics)
      : load_(load), encoding_(encoding), diagnostics_(diagnostics) {}

  std::optional<FilledProgram> fill(const ProgramText& main, const TemplateValues& values) {
    const std::optional<Template> own = readTemplate(main, encoding_, diagnostics_);
    if (!own) return std::nullopt;
    const int before = diagnostics_.errorCount();
    for (const auto& [name, value] : values) {
      if (const std::string why = refusalOf(*own, name, value); !why.empty())
        addError({own->name, 0, 0, 0}, why, {});
    }
    if (diagnostics_.errorCount() != before) return std::nullopt;
    const auto lines = fillTemplate(*own, values, diagnostics_);
    if (!lines) return std::nullopt;
    out_.files.push_back(main);
    out_.origins.files.push_back(main.name);
    for (std::size_t i = 0; i < lines->size() && !full_; ++i) {
      if (diagnostics_.errorCount() - before >= kMostTemplateErrors) break;
      if (isSet(main.name) && isElement((*lines)[i]))
        element(own->name, (*lines)[i], i + 1);
      else
        add((*lines)[i], 0, i + 1);
    }
    if (diagnostics_.errorCount() != before) return std::nullopt;
    return std::move(out_);
  }

 private:
  void addError(SourceLocation where, std::string message, std::string line) {
    Diagnostic d;
    d.code = "template";
    d.message = std::move(message);
    d.where = std::move(where);
    d.source_line = std::move(line);
    diagnostics_.add(std::move(d));
  }

  /// Nothing more is taken.
  void stopFilling(std::string why) {
    full_ = true;
    addError({out_.files.front().name, 0, 0, 0}, std::move(why), {});
  }

  /// `number`: of the line in the file of that origin, from 1.
  void add(std::string line, std::size_t file, std::size_t number) {
    bytes_ += line.size() + 1;
    if (bytes_ > kMaxFilledBytes && !full_)
      stopFilling(fmt::format("the program gets larger than {} MiB", kMaxFilledBytes >> 20));
    // What is held of it already is counted; it will be held as a text and cut into lines.
    constexpr std::size_t kLook = 1024;
    constexpr double kCopies = 4.0;
    if (out_.lines.size() % kLook == 0 && !full_) {
      if (const Status fits = memoryFor(kCopies * static_cast<double>(bytes_), "the filled program"); !fits)
        stopFilling(fits.error().message);
    }
    if (full_) return;
    out_.lines.push_back(std::move(line));
    out_.origins.lines.push_back({static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(number)});
  }

  /// `@ NAME.tmpl D=40;d1=25`
  void element(const std::string& set, const std::string& line, std::size_t number) {
    const auto fail = [&](std::size_t begin, std::size_t end, std::string message) {
      addError({set, static_cast<int>(number), static_cast<int>(begin) + 1, static_cast<int>(end) + 1},
               std::move(message), line);
    };
    const std::size_t begin = elementAt(line);
    const bool quoted = begin != kNowhere && line[begin] == '"';
    const std::size_t first = quoted ? begin + 1 : begin;
    const std::size_t last = begin == kNowhere ? kNowhere : line.find_first_of(quoted ? "\"" : " \t", first);
    if (begin == kNowhere || (quoted && last == kNowhere) || last == first)
      return fail(0, line.size(), "a template of a set is @ NAME.tmpl NAME=VALUE;NAME=VALUE");
    const std::string name = line.substr(first, last == kNowhere ? kNowhere : last - first);
    const std::size_t file =
        fileOf(name, [&](std::string why) { fail(first, first + name.size(), std::move(why)); });
    if (file == kNowhere) return;
    const Template& text = templates_[file - 1];
    TemplateValues values;
    bool good = true;
    for (std::size_t at = last == kNowhere ? line.size() : last + 1; at < line.size();) {
      const std::size_t end = std::min(line.find(';', at), line.size());
      const std::string pair = line.substr(at, end - at);
      if (const std::string why = take(text, pair, values); !why.empty()) {
        fail(std::min(line.find_first_not_of(" \t", at), end), end, why);
        good = false;
      }
      at = end + 1;
    }
    if (!good) return;
    out_.origins.files.push_back(fmt::format("{} ({}:{})", text.name, set, number));
    addFilled(text, values, fmt::format("in the set {}:{}: {}", set, number, line));
  }

  /// One NAME=VALUE; blanks alone are nothing. Returns why not.
  static std::string take(const Template& text, const std::string& pair, TemplateValues& values) {
    const std::size_t from = pair.find_first_not_of(" \t");
    if (from == kNowhere) return {};
    const std::size_t equals = pair.find('=');
    if (equals == kNowhere) return "NAME=VALUE is wanted here";
    std::string name = pair.substr(from, equals - from), value = pair.substr(equals + 1);
    name.erase(name.find_last_not_of(" \t") + 1);
    value.erase(value.find_last_not_of(" \t") + 1);
    value.erase(0, std::min(value.find_first_not_of(" \t"), value.size()));
    if (const std::string why = refusalOf(text, name, value); !why.empty()) return why;
    if (!values.emplace(name, value).second) return fmt::format("[{}] has two values", name);
    return {};
  }

  /// As the last of the origins.
  void addFilled(const Template& text, const TemplateValues& values, const std::string& note) {
    Diagnostics found;
    const auto lines = fillTemplate(text, values, found);
    for (Diagnostic d : found.all()) {
      d.notes.push_back(note);
      diagnostics_.add(std::move(d));
    }
    const std::size_t file = out_.origins.files.size() - 1;
    for (std::size_t i = 0; lines && i < lines->size() && !full_; ++i) add((*lines)[i], file, i + 1);
  }

  /// Number of the template in the files, which are read once.
  template <typename Fail>
  std::size_t fileOf(const std::string& name, Fail&& fail) {
    const auto known = std::find(names_.begin(), names_.end(), name);
    if (known != names_.end()) return static_cast<std::size_t>(known - names_.begin()) + 1;
    if (isSet(name)) {
      fail("a set holds templates and program text, no other sets");
      return kNowhere;
    }
    Result<ProgramText> text = load_(name);
    if (!text) {
      fail(text.error().message);
      return kNowhere;
    }
    std::optional<Template> read = readTemplate(*text, encoding_, diagnostics_);
    if (!read) return kNowhere;
    names_.push_back(name);
    templates_.push_back(std::move(*read));
    out_.files.push_back(std::move(*text));
    return names_.size();
  }

  const TemplateLoader& load_;
  TextEncoding encoding_;
  Diagnostics& diagnostics_;
  FilledProgram out_;
  std::vector<std::string> names_;   ///< of the templates, as the set says them
  std::vector<Template> templates_;  ///< out_.files from 1 on
  std::size_t bytes_ = 0;
  bool full_ = false;
};

}  // namespace

bool isTemplateName(std::string_view name) { return extensionOf(name) == ".tmpl" || isSet(name); }

std::string FilledProgram::text() const {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

std::optional<FilledProgram> fillProgram(const ProgramText& main, const TemplateValues& values,
                                         const TemplateLoader& load, TextEncoding encoding,
                                         Diagnostics& diagnostics) {
  return Filler(load, encoding, diagnostics).fill(main, values);
}

}  // namespace proveout::nc
