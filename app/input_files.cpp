#include "app/input_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/result_moves.h"
#include "io/job/template_files.h"

namespace proveout {
namespace {

class Collector {
 public:
  void add(const char* role, const std::string& path) {
    const auto same = [&](const InputFile& other) { return other.path == path && other.role == role; };
    if (!path.empty() && std::none_of(files.begin(), files.end(), same)) files.push_back({role, path});
  }
  void addShape(const char* role, const StockSpec& shape) {
    if (const auto* mesh = std::get_if<MeshFile>(&shape)) add(role, mesh->path);
    if (const auto* saved = std::get_if<SavedStock>(&shape)) add(role, saved->path);
  }
  void addPrograms(const std::string& program, const std::vector<std::string>& subprograms) {
    add("program", program);
    std::error_code error;
    for (const std::string& path : subprograms) {
      if (!std::filesystem::is_directory(path, error)) add("subprogram", path);
    }
  }
  /// The main file of a template or set, and the templates that a set names.
  void addTemplates(const std::string& path, const std::optional<TemplateUse>& use) {
    if (!use) return;
    add("program", path);
    Diagnostics told_elsewhere;
    const auto filled = fillFile(path, *use, told_elsewhere);
    for (std::size_t i = 1; filled && i < filled->files.size(); ++i) add("template", filled->files[i].path);
  }
  std::vector<InputFile> files;
};

}  // namespace

std::vector<InputFile> namedInputs(const Job& job) {
  Collector found;
  found.add("job", job.path);
  found.add("machine", job.machine_file);
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const Job part = jobOfSetup(job, k);
    if (k < job.setups.size()) found.add("machine", job.setups[k].machine_file);
    found.addPrograms(part.program, part.subprograms);
    found.addTemplates(part.program, part.filled);
    for (const ChannelSpec& channel : part.channels) found.addPrograms(channel.program, channel.subprograms);
    for (const FixtureSpec& fixture : part.fixtures) found.addShape("fixture", fixture.shape);
  }
  if (job.stock) found.addShape("stock", *job.stock);
  if (job.nominal) found.add("nominal", job.nominal->mesh.path);
  return std::move(found.files);
}

std::vector<InputFile> templatesOf(const Job& job) {
  Collector found;
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const Job part = jobOfSetup(job, k);
    found.addTemplates(part.program, part.filled);
  }
  return std::move(found.files);
}

Status settleInputs(const std::vector<InputFile>& files) {
  std::set<std::string> folders;
  for (const InputFile& file : files) folders.insert(std::filesystem::path(file.path).parent_path().string());
  for (const std::string& folder : folders) {
    if (Status settled = settleResults(folder); !settled) return settled;
  }
  return Done{};
}

void protectAll(const std::vector<InputFile>& files, OutputGuard& guard) {
  for (const InputFile& file : files) guard.protect(file.role, file.path);
}

std::vector<InputFile> programsRead(const RecordingSource& source) {
  Collector found;
  // The main programs of all channels are loaded before anything is called.
  const std::size_t channels = source.channels().size();
  for (std::size_t i = 0; i < source.texts().size(); ++i)
    found.add(i < channels ? "program" : "subprogram", source.texts()[i].path);
  return std::move(found.files);
}

}  // namespace proveout
