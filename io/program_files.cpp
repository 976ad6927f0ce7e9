#include "io/program_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/memory_limit.h"
#include "io/atomic_file.h"
#include "io/mesh_formats.h"
#include "io/program_reach.h"

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
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  constexpr double kCopies = 4.0;  // as read, decoded, cut into lines, kept for findings
  const Status fits = error ? Status(Done{}) : memoryFor(kCopies * static_cast<double>(size), path.string());
  if (!fits) return fits.error();
  Result<std::string> bytes = readWholeFile(path.string(), FileProgramSource::kMaxProgramBytes);
  if (!bytes) return bytes.error();
  return ProgramText{path.filename().string(), path.string(), std::move(*bytes)};
}

std::string folderName(const fs::path& folder) {
  return folder.empty() ? "the working folder" : folder.string();
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

std::vector<fs::path> FileProgramSource::filesAt(const std::string& place) const {
  std::error_code error;
  return fs::is_directory(place, error) ? filesOf(place) : std::vector<fs::path>{place};
}

std::vector<fs::path> FileProgramSource::systemFolders(int channel) const {
  const fs::path main_folder = fs::path(main_path_).parent_path(), below = systemFolder(channel);
  std::vector<fs::path> folders = {main_folder / below, main_folder / ".." / below};
  std::error_code error;
  for (const fs::path place : places_) {
    if (fs::is_directory(place, error)) folders.push_back(place / below);
  }
  return folders;
}

FileProgramSource::Found FileProgramSource::findByStem(const std::string& caller,
                                                       const std::string& stem) const {
  return findWithExtension(caller, stem, fs::path(caller).extension().string());
}

FileProgramSource::Found FileProgramSource::findWithExtension(const std::string& caller,
                                                              const std::string& stem,
                                                              const std::string& extension) const {
  // A stem comes from the text of a program: it must not lead out of the folders.
  if (stem.empty() || stem.find('/') != std::string::npos) return {};
  const fs::path caller_path(caller);
  if (const auto found = findName(filesOf(caller_path.parent_path()), stem + extension))
    return {found->string()};
  for (const std::string& place : places_) {
    if (const auto found = findStem(filesAt(place), stem, extension)) return {found->string()};
  }
  return {};
}

FileProgramSource::Found FileProgramSource::findSystem(const std::string& stem, int channel) const {
  if (stem.empty() || stem.find('/') != std::string::npos) return {};
  for (const fs::path& folder : systemFolders(channel)) {
    if (const auto found = findStem(filesOf(folder), stem, ".nct")) return {found->string()};
  }
  for (const std::string& place : places_) {
    if (const auto found = findStem(filesAt(place), stem, ".nct")) return {found->string()};
  }
  return {};
}

FileProgramSource::Found FileProgramSource::findByPath(const std::string& caller,
                                                       const std::string& path) const {
  const fs::path wanted(path);
  if (wanted.filename().empty()) return {};
  if (namesDrive(path)) return {{}, true};
  std::vector<fs::path> folders = {fs::path(caller).parent_path()};
  for (const fs::path place : places_) {
    std::error_code error;
    if (fs::is_directory(place, error)) {
      folders.push_back(place);
    } else if (lowerCase(place.filename().string()) == lowerCase(wanted.filename().string())) {
      return {place.string()};
    }
  }
  const ProgramReach reach = reachFrom(caller);
  bool outside = false;
  for (const fs::path& folder : folders) {
    const fs::path in = (folder / wanted.relative_path()).parent_path();
    if (!reach.holds(in)) {  // it is not even listed
      outside = true;
    } else if (const auto found = findName(filesOf(in), wanted.filename().string())) {
      return {found->string()};
    }
  }
  return {{}, outside};
}

ProgramReach FileProgramSource::reachFrom(const std::string& caller) const {
  ProgramReach reach;
  reach.addFolder(fs::path(main_path_).parent_path());
  // Either below one of the others or beside a file that the job names.
  reach.addFolder(fs::path(caller).parent_path());
  std::error_code error;
  for (const fs::path place : places_) {
    if (fs::is_directory(place, error))
      reach.addFolder(place);
    else
      reach.addFile(place);
  }
  return reach;
}

FileProgramSource::Found FileProgramSource::find(const SubprogramQuery& query) const {
  for (const std::string& stem : query.stems) {
    Found found =
        query.system_channel > 0 ? findSystem(stem, query.system_channel) : findByStem(callerOf(query), stem);
    if (!found.path.empty()) return found;
    for (const std::string& ending : query.extensions) {
      found = findWithExtension(callerOf(query), stem, ending);
      if (!found.path.empty()) return found;
    }
  }
  return query.path.empty() ? Found{} : findByPath(callerOf(query), query.path);
}

bool FileProgramSource::finds(const SubprogramQuery& query) const {
  const Found found = find(query);
  return !found.path.empty() || found.outside;
}

Result<ProgramText> FileProgramSource::subprogram(const SubprogramQuery& query) const {
  const std::string& caller = callerOf(query);
  const Found found = find(query);
  if (found.path.empty()) return found.outside ? outside(query.path) : missing(query, caller);
  ProgramReach reach = reachFrom(caller);
  // The folder of the control's own programs may stand beside that of the main program.
  if (query.system_channel > 0) reach.addSibling(fs::path(main_path_).parent_path(), "SystemMacros");
  if (!reach.holds(found.path)) return outside(fs::path(found.path).filename().string());
  return readProgram(found.path);
}

Error FileProgramSource::outside(const std::string& name) const {
  return inputError(fmt::format(
      "{} leads out of the folder of the program and of subprograms: a program calls what lies in "
      "these, links followed; name its folder in subprograms if it belongs to the job",
      name));
}

Error FileProgramSource::missing(const SubprogramQuery& query, const std::string& caller) const {
  if (query.system_channel > 0 && !query.stems.empty()) {
    return inputError(
        fmt::format("there is no system program {}{} beside the main program or in the job's folders",
                    systemFolder(query.system_channel), query.stems.front()));
  }
  if (!query.extensions.empty() && !query.stems.empty()) {
    return noneOf(query, fmt::format("{}{}", folderName(fs::path(caller).parent_path()),
                                     places_.empty() ? "" : fmt::format(", {}", fmt::join(places_, ", "))));
  }
  const std::string what =
      query.stems.empty() ? query.path : query.stems.front() + fs::path(caller).extension().string();
  return inputError(fmt::format("there is no program {} in {}{}", what,
                                folderName(fs::path(caller).parent_path()),
                                places_.empty() ? "" : fmt::format(" or in {}", fmt::join(places_, ", "))));
}

}  // namespace proveout
