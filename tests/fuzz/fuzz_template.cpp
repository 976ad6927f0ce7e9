// Feeds any text to the templates of the FlexNC shell. An input is parts with a record separator (0x1e)
// between them: how it is read, then the main text, then the templates that a set may name. Programs that
// come out run on the control.
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/printable.h"
#include "core/nc/text/template_set.h"
#include "tests/fuzz/checking_sink.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

constexpr char kSeparator = '\x1e';
/// Sets may name a large template often: what comes out is no test of the control any more.
constexpr std::size_t kMostFilledBytes = std::size_t{1} << 16;

std::vector<std::string> partsOf(std::string_view text) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t end = text.find(kSeparator);
    out.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + 1);
  }
}

/// `s` in the first part: the main text is a set; `1`, `8`: cp1251, koi8-r; lines NAME=VALUE behind it.
struct Input {
  ProgramText main;
  TextEncoding encoding = TextEncoding::kAuto;
  nc::TemplateValues values;
  std::map<std::string, std::string> templates;  ///< a.tmpl, b.tmpl and so on
};

Input inputOf(std::string_view bytes) {
  const std::vector<std::string> parts = partsOf(bytes);
  const std::string_view how = parts.front();
  const std::string_view head = how.substr(0, how.find('\n'));
  Input in;
  const bool set = head.find('s') != std::string_view::npos;
  if (head.find('1') != std::string_view::npos) in.encoding = TextEncoding::kCp1251;
  if (head.find('8') != std::string_view::npos) in.encoding = TextEncoding::kKoi8R;
  in.main = {set ? "main.tmps" : "main.tmpl", "main", parts.size() > 1 ? parts[1] : std::string()};
  for (std::size_t at = head.size(); at < how.size();) {
    const std::size_t end = std::min(how.find('\n', at + 1), how.size());
    const std::string_view line = how.substr(at + 1, end - at - 1);
    if (const std::size_t equals = line.find('='); equals != std::string_view::npos)
      in.values.emplace(line.substr(0, equals), line.substr(equals + 1));
    at = end;
  }
  for (std::size_t k = 2; k < parts.size() && k < 28; ++k)
    in.templates.emplace(std::string(1, static_cast<char>('a' + k - 2)) + ".tmpl", parts[k]);
  return in;
}

struct Outcome {
  std::optional<nc::FilledProgram> filled;
  std::string said;
};

Outcome fill(const Input& in) {
  const auto load = [&](const std::string& name) -> Result<ProgramText> {
    const auto found = in.templates.find(name);
    if (found == in.templates.end()) return inputError("no template " + printable(name));
    return ProgramText{name, name, found->second};
  };
  Diagnostics diagnostics;
  Outcome out;
  out.filled = nc::fillProgram(in.main, in.values, load, in.encoding, diagnostics);
  require(out.filled.has_value() != diagnostics.hasErrors(), "a program, or errors");
  for (const Diagnostic& d : diagnostics.all()) {
    require(!d.message.empty() && !d.where.file.empty(), "an error says what and where");
    out.said += formatDiagnostic(d);
  }
  return out;
}

/// Declarations say what the template takes.
void checkParameters(const Input& in) {
  Diagnostics diagnostics;
  const auto text = nc::readTemplate(in.main, in.encoding, diagnostics);
  require(text.has_value() != diagnostics.hasErrors(), "a template, or errors");
  if (!text) return;
  for (const nc::TemplateParameter& p : text->parameters) {
    require(!p.name.empty() && text->find(p.name) == &p, "names are found, and differ");
    require(p.where.line >= 1 && static_cast<std::size_t>(p.where.line) <= text->lines.size(),
            "a parameter has a place");
    require(!p.value || nc::refusalOf(*text, p.name, *p.value).empty(), "defaults are taken");
    require(!nc::refusalOf(*text, p.name, "").empty(), "empty fields are not taken");
  }
}

void checkFilled(const Input& in, const nc::FilledProgram& filled) {
  require(filled.lines.size() == filled.origins.lines.size(), "every line comes from somewhere");
  for (std::size_t i = 0; i < filled.lines.size(); ++i) {
    const TextOrigins::Line& from = filled.origins.lines[i];
    require(from.file < filled.origins.files.size() && from.line >= 1, "a line comes from a file");
    require(in.main.name != "main.tmpl" || from.line == i + 1, "lines of a template keep their numbers");
    require(filled.lines[i].find_first_of("\r\n") == std::string::npos, "a line is a line");
  }
  Diagnostics diagnostics;
  // The empty line: letters at the beginning of a file may say that it is a container.
  const auto again =
      nc::readTemplate({"filled", "filled", "\n" + filled.text()}, TextEncoding::kUtf8, diagnostics);
  require(again.has_value(), "what is filled can be read");
  for (const nc::TemplateParameter& p : again->parameters) require(!p.used, "every field is filled in");
}

class FilledSource : public ProgramSource {
 public:
  explicit FilledSource(const nc::FilledProgram& filled)
      : text_{"main", "main", filled.text(), std::make_shared<const TextOrigins>(filled.origins)} {}
  Result<ProgramText> mainProgram() const override { return text_; }
  Result<ProgramText> subprogram(const SubprogramQuery&) const override { return inputError("none"); }

 private:
  ProgramText text_;
};

void run(const nc::FilledProgram& filled) {
  ControlSettings settings;
  settings.block_limit = 300;
  settings.max_errors = 20;
  settings.parameters = {{"RT.1", 0.8}, {"TIP.1", 3.0}};
  CheckingSink sink;
  interpret(ControlId::kFlexNc, FilledSource(filled), settings, sink);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Input in = inputOf({reinterpret_cast<const char*>(data), size});
  checkParameters(in);
  const Outcome first = fill(in), second = fill(in);
  require(first.said == second.said && first.filled.has_value() == second.filled.has_value(),
          "a second reading says the same");
  if (!first.filled) return 0;
  require(first.filled->text() == second.filled->text(), "a second filling gives the same text");
  checkFilled(in, *first.filled);
  if (first.filled->text().size() <= kMostFilledBytes) run(*first.filled);
  return 0;
}
