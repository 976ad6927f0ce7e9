#include "app/outputs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

#include "app/job_setup.h"
#include "io/atomic_file.h"
#include "io/mesh_io.h"
#include "io/sha256.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

/// So much of a table is gathered before it is written.
constexpr std::size_t kFlushBytes = std::size_t{1} << 20;

MeshFormat meshFormat(OutputFormat format) {
  switch (format) {
    case OutputFormat::kStlAscii:
      return MeshFormat::kStlAscii;
    case OutputFormat::kObj:
      return MeshFormat::kObj;
    case OutputFormat::kPly:
      return MeshFormat::kPly;
    case OutputFormat::kStl:
    case OutputFormat::kVdb:
      break;
  }
  return MeshFormat::kStlBinary;
}

Result<std::string> saveHashed(const Stock& stock, const std::string& path) {
  if (const Status saved = stock.save(path); !saved) return saved.error();
  return sha256OfFile(path);
}

}  // namespace

Result<StagingFolder> StagingFolder::create(const std::string& target) {
  if (const Status made = makeFolders(target); !made) return made.error();
  std::string pattern = (fs::path(target) / (".proveout-" + std::string(6, 'X'))).string();
  if (mkdtemp(pattern.data()) == nullptr) {
    return inputError(fmt::format("{}: cannot write into this folder: {}", target,
                                  std::error_code(errno, std::generic_category()).message()));
  }
  StagingFolder staging;
  staging.target_ = target;
  staging.aside_ = pattern;
  return staging;
}

StagingFolder::StagingFolder(StagingFolder&& other) noexcept
    : target_(std::move(other.target_)),
      aside_(std::exchange(other.aside_, {})),
      names_(std::move(other.names_)) {}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  if (!aside_.empty()) fs::remove_all(aside_, ignored);
}

std::string StagingFolder::path(const std::string& name) {
  names_.push_back(name);
  return (fs::path(aside_) / name).string();
}

Status StagingFolder::commit() {
  for (const std::string& name : names_) {
    const fs::path target = fs::path(target_) / name;
    if (Status done = makeFolders(target.parent_path().string()); !done) return done;
    std::error_code error;
    fs::rename(fs::path(aside_) / name, target, error);
    if (error) return inputError(fmt::format("{}: cannot be written: {}", target.string(), error.message()));
  }
  return Done{};
}

Status writeProgramFiles(const std::map<std::string, std::string>& files, const std::string& setup,
                         StagingFolder& staging) {
  const std::string folder = setup.empty() ? "files/" : "files/" + fileName(setup) + "/";
  for (const auto& [name, bytes] : files) {
    const std::string path = staging.path(folder + name);
    if (Status done = makeFolders(fs::path(path).parent_path().string()); !done) return done;
    if (Status done = writeFileAtomically(path, bytes); !done) return done;
  }
  return Done{};
}

Status writeMeshes(const TriMesh& mesh, const Stock* stock, const Job& job, StagingFolder& staging,
                   Report& report) {
  for (const OutputFormat format : job.output.formats) {
    if (format == OutputFormat::kVdb && stock == nullptr) continue;  // turning left nothing to make a grid of
    const bool second_stl = format == OutputFormat::kStlAscii && job.output.formats.size() > 1;
    const std::string file =
        fmt::format("{}{}.{}", fileName(job.name), second_stl ? "-ascii" : "", outputFormatExtension(format));
    const std::string path = staging.path(file);
    Result<std::string> hash = format == OutputFormat::kVdb ? saveHashed(*stock, path)
                                                            : writeMeshHashed(mesh, path, meshFormat(format));
    if (!hash) return hash.error();
    report.outputs.meshes.push_back({file, std::string(outputFormatName(format)), std::move(*hash)});
  }
  return Done{};
}

Status writeTables(const std::vector<CutPath>& paths, StagingFolder& staging, Report& report) {
  Result<AtomicFile> file = AtomicFile::create(staging.path("blocks.csv"));
  if (!file) return file.error();
  std::string buffer = blockCsvHeader();
  double start_s = 0.0;
  for (const CutPath& cut : paths) {
    double end_s = start_s;
    forEachBlock(cut, start_s, [&](const BlockFigures& row) {
      appendBlockCsv(row, buffer);
      end_s = row.start_s + row.figures.time_s();
      if (buffer.size() < kFlushBytes) return;
      file->write(buffer);
      buffer.clear();
    });
    start_s = end_s;
  }
  file->write(buffer);
  if (Status done = file->commit(); !done) return done;
  report.outputs.tables.push_back("blocks.csv");
  const std::string svg = report.accounting ? rateSvgFile(report.accounting->rate) : std::string();
  if (svg.empty()) return Done{};
  report.outputs.tables.push_back("mrr.svg");
  return writeFileAtomically(staging.path("mrr.svg"), svg);
}

Status writeProfileChart(const std::vector<std::vector<Vec2>>& machined, const TriMesh* nominal,
                         const ProfileChartOptions& options, StagingFolder& staging, Report& report) {
  const std::vector<SectionSegment> section = nominal ? halfSection(*nominal) : std::vector<SectionSegment>();
  ProfileChart chart = drawProfileChart(machined, section, options);
  if (chart.file.empty()) return Done{};
  report.outputs.tables.push_back("profile.svg");
  report.profile_svg = std::move(chart.page);
  return writeFileAtomically(staging.path("profile.svg"), chart.file);
}

Status writeReport(const std::vector<Picture>& pictures, StagingFolder& staging, Report& report) {
  std::vector<ReportPicture> embedded;
  for (const Picture& picture : pictures) {
    report.outputs.images.push_back({picture.file, picture.title});
    embedded.push_back({picture.title, picture.png});
    if (Status done = writeFileAtomically(staging.path(picture.file), picture.png); !done) return done;
  }
  report.outputs.html = "report.html";
  const std::pair<const char*, std::string> texts[] = {{"report.html", reportHtml(report, embedded)},
                                                       {"junit.xml", reportJunit(report)},
                                                       {"report.json", reportJson(report)}};
  for (const auto& [name, text] : texts) {
    if (Status done = writeFileAtomically(staging.path(name), text); !done) return done;
  }
  return Done{};
}

}  // namespace proveout
