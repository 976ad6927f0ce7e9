#include "io/job/template_files.h"

#include <filesystem>

#include "io/atomic_file.h"
#include "io/program_reach.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

Result<ProgramText> readText(const fs::path& path) {
  Result<std::string> bytes = readWholeFile(path.string(), nc::kMaxTemplateBytes);
  if (!bytes) return bytes.error();
  return ProgramText{path.filename().string(), path.string(), std::move(*bytes)};
}

}  // namespace

std::optional<nc::FilledProgram> fillFile(const std::string& path, const TemplateUse& use,
                                          Diagnostics& diagnostics) {
  const Result<ProgramText> main = readText(path);
  if (!main) {
    Diagnostic d;
    d.code = "template";
    d.message = main.error().message;
    diagnostics.add(std::move(d));
    return std::nullopt;
  }
  const fs::path folder = fs::path(path).parent_path();
  ProgramReach own;
  own.addFolder(folder);
  const auto load = [&](const std::string& name) -> Result<ProgramText> {
    // Names come from the text of a set: they must not lead out of its folder, links followed.
    if (name.find_first_of("/\\") != std::string::npos || namesDrive(name))
      return inputError("a set names templates in its own folder, without a path");
    if (!own.holds(folder / name))
      return inputError(name +
                        " leads out of the folder of the set: a set names templates in its own folder");
    return readText(folder / name);
  };
  return nc::fillProgram(*main, use.values, load, use.encoding, diagnostics);
}

Result<ProgramText> TemplateProgramSource::mainProgram() const {
  Diagnostics diagnostics;
  auto filled = fillFile(path_, use_, diagnostics);
  if (!filled) {
    const Diagnostic& first = diagnostics.all().front();
    const std::string line = first.where.line > 0 ? ":" + std::to_string(first.where.line) : std::string();
    return inputError(first.where.file + line + ": " + first.message);
  }
  ProgramText text{fs::path(path_).filename().string(), path_, filled->text()};
  // The lines of a template alone are where they were.
  if (filled->origins.files.size() > 1)
    text.origins = std::make_shared<const TextOrigins>(std::move(filled->origins));
  return text;
}

}  // namespace proveout
