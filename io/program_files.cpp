#include "io/program_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "io/atomic_file.h"
#include "io/mesh_formats.h"

namespace proveout {

namespace fs = std::filesystem;
using mesh_formats::lowerCase;

namespace {

/// Regular files of a folder in the order of their names. A folder that cannot be read has none.
std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) files.push_back(folder / at->path().filename());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The file among `files` that has the name; case counts only where two differ in nothing else.
std::optional<fs::path> findName(const std::vector<fs::path>& files, const std::string& name) {
  std::optional<fs::path> found;
  const std::string lower = lowerCase(name);
  for (const fs::path& file : files) {
    const std::string candidate = file.filename().string();
    if (candidate == name) return file;
    if (!found && lowerCase(candidate) == lower) found = file;
  }
  return found;
}

std::optional<fs::path> findStem(const std::vector<fs::path>& files, const std::string& stem,
                                 const std::string& caller_extension) {
  if (auto found = findName(files, stem + caller_extension)) return found;
  for (const std::string& extension : FileProgramSource::programExtensions()) {
    if (auto found = findName(files, stem + extension)) return found;
  }
  return findName(files, stem);
}

Result<ProgramText> readProgram(const fs::path& path) {
  Result<std::string> bytes = readWholeFile(path.string(), FileProgramSource::kMaxProgramBytes);
  if (!bytes) return bytes.error();
  return ProgramText{path.filename().string(), path.string(), std::move(*bytes)};
}

}  // namespace

FileProgramSource::FileProgramSource(std::string main_path, std::vector<std::string> places)
    : main_path_(std::move(main_path)), places_(std::move(places)) {}

const std::vector<std::string>& FileProgramSource::programExtensions() {
  static const std::vector<std::string> kExtensions = {".nc",  ".nct", ".txt", ".prg",  ".cnc",
                                                       ".mpf", ".spf", ".sub", ".tap",  ".ngc",
                                                       ".iso", ".eia", ".min", ".gcode"};
  return kExtensions;
}

Result<ProgramText> FileProgramSource::mainProgram() const { return readProgram(main_path_); }

std::string FileProgramSource::findByStem(const std::string& caller, const std::string& stem) const {
  // A stem comes from the text of a program: it must not lead out of the folders.
  if (stem.empty() || stem.find('/') != std::string::npos) return {};
  const fs::path caller_path(caller);
  const std::string extension = caller_path.extension().string();
  if (const auto found = findName(filesOf(caller_path.parent_path()), stem + extension))
    return found->string();
  for (const fs::path place : places_) {
    std::error_code error;
    const auto files = fs::is_directory(place, error) ? filesOf(place) : std::vector<fs::path>{place};
    if (const auto found = findStem(files, stem, extension)) return found->string();
  }
  return {};
}

std::string FileProgramSource::findSystem(const std::string& stem, int channel) const {
  if (stem.empty() || stem.find('/') != std::string::npos) return {};
  const fs::path main_folder = fs::path(main_path_).parent_path(), below = systemFolder(channel);
  std::vector<fs::path> folders = {main_folder / below, main_folder / ".." / below};
  std::error_code error;
  for (const fs::path place : places_) {
    if (fs::is_directory(place, error)) folders.push_back(place / below);
  }
  for (const fs::path& folder : folders) {
    if (const auto found = findStem(filesOf(folder), stem, ".nct")) return found->string();
  }
  for (const fs::path place : places_) {
    const auto files = fs::is_directory(place, error) ? filesOf(place) : std::vector<fs::path>{place};
    if (const auto found = findStem(files, stem, ".nct")) return found->string();
  }
  return {};
}

std::string FileProgramSource::findByPath(const std::string& caller, const std::string& path) const {
  const fs::path wanted(path);
  if (wanted.filename().empty()) return {};
  std::vector<fs::path> folders = {fs::path(caller).parent_path()};
  for (const fs::path place : places_) {
    std::error_code error;
    if (fs::is_directory(place, error)) {
      folders.push_back(place);
    } else if (lowerCase(place.filename().string()) == lowerCase(wanted.filename().string())) {
      return place.string();
    }
  }
  for (const fs::path& folder : folders) {
    const fs::path in = (folder / wanted.relative_path()).parent_path();
    if (const auto found = findName(filesOf(in), wanted.filename().string())) return found->string();
  }
  return {};
}

Result<ProgramText> FileProgramSource::subprogram(const SubprogramQuery& query) const {
  const std::string& caller = query.caller.empty() ? main_path_ : query.caller;
  std::string path;
  for (const std::string& stem : query.stems) {
    path = query.system_channel > 0 ? findSystem(stem, query.system_channel) : findByStem(caller, stem);
    if (!path.empty()) break;
  }
  if (path.empty() && !query.path.empty()) path = findByPath(caller, query.path);
  if (!path.empty()) return readProgram(path);

  if (query.system_channel > 0 && !query.stems.empty()) {
    return inputError(
        fmt::format("there is no system program {}{} beside the main program or in the job's folders",
                    systemFolder(query.system_channel), query.stems.front()));
  }
  const fs::path folder = fs::path(caller).parent_path();
  const std::string what =
      query.stems.empty() ? query.path : query.stems.front() + fs::path(caller).extension().string();
  return inputError(fmt::format("there is no program {} in {}{}", what,
                                folder.empty() ? "the working folder" : folder.string(),
                                places_.empty() ? "" : fmt::format(" or in {}", fmt::join(places_, ", "))));
}

}  // namespace proveout
