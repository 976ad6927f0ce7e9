#include "app/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/deviation/deviation_outputs.h"
#include "app/exit_codes.h"
#include "app/freed_pieces.h"
#include "app/job_setup.h"
#include "app/session/run/process.h"
#include "core/mesh/level_cut.h"
#include "io/atomic_file.h"
#include "io/exchange/hashed_file.h"
#include "io/exchange/inspection_csv.h"
#include "io/mesh_io.h"
#include "io/report/section_chart.h"
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
    case OutputFormat::kThreeMf:
      return MeshFormat::kThreeMf;
    case OutputFormat::kGlb:
      return MeshFormat::kGlb;
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

/// Name of the mesh file, or of the saved stock, of this format.
std::string meshFileName(const Job& job, OutputFormat format) {
  const bool second_stl = format == OutputFormat::kStlAscii && job.output.formats.size() > 1;
  return fmt::format("{}{}.{}", fileName(job.name), second_stl ? "-ascii" : "",
                     outputFormatExtension(format));
}

bool needsModule(const Job& job) {
  const auto isMesh = [](const StockSpec& spec) { return std::holds_alternative<MeshFile>(spec); };
  if (savesStock(job)) return true;
  if (job.stock && (isMesh(*job.stock) || std::holds_alternative<SavedStock>(*job.stock))) return true;
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    for (const FixtureSpec& fixture : jobOfSetup(job, k).fixtures) {
      if (isMesh(fixture.shape)) return true;
    }
    if (k > 0 && !movesExactly(job.setups[k].from_previous)) return true;
  }
  return false;
}

void keep(const Status& status, OutputFailures& failures) {
  if (!status) failures.push_back(status.error());
}

Status writeText(const std::string& name, const std::string& text, StagingFolder& staging) {
  return staging.write(name, [&](const std::string& path) { return writeFileAtomically(path, text); });
}

}  // namespace

std::vector<std::string> outputNames(const Job& job) {
  std::vector<std::string> names = {"report.json", "report.html", "junit.xml"};
  for (const OutputFormat format : job.output.formats) names.push_back(meshFileName(job, format));
  for (const std::string& view : job.output.views) names.push_back(view + ".png");
  if (!job.output.views.empty())
    names.insert(names.end(), {"deviation.png", "findings.png", "apart.png", "scallops.png"});
  for (std::size_t k = 1; k < job.output.views.size(); ++k)
    names.push_back(deviationViewName(job.output.views[k]) + ".png");
  if (job.output.csv) names.insert(names.end(), {"blocks.csv", "mrr.svg", "findings.csv"});
  for (const DeviationOutput output : job.output.deviation)
    names.push_back(deviationFileName(job.name, output));
  for (const double z : job.output.sections) names.push_back(sectionFileName(z));
  if (processOf(job, setupCount(job) - 1).part_turns) names.emplace_back("profile.svg");
  return names;
}

std::vector<std::string> comparisonOutputNames(const std::vector<std::string>& deviations) {
  std::vector<std::string> names = {"report.json", "report.html", "junit.xml", "deviation.png",
                                    "findings.png"};
  for (const std::string& view : PictureRequest().views) names.push_back(view + ".png");
  names.insert(names.end(), deviations.begin(), deviations.end());
  return names;
}

Status checkNames(const std::vector<std::string>& names, const std::string& folder,
                  const OutputGuard& guard) {
  for (const std::string& name : names) {
    if (Status allowed = guard.check((fs::path(folder) / name).string()); !allowed) return allowed;
  }
  return Done{};
}

Status checkOutputs(const Job& job, const std::string& folder, const OutputGuard& guard) {
  if (Status allowed = checkNames(outputNames(job), folder, guard); !allowed) return allowed;
  if (Status streams = guard.checkStandardOutput(); !streams) return streams;
  // The only proof that a folder can be made and written; it goes at once.
  if (const Result<StagingFolder> proof = StagingFolder::create(folder); !proof) return proof.error();
  return needsModule(job) ? checkStockFiles() : Status(Done{});
}

std::string programFileName(const std::string& setup, const std::string& name) {
  return (setup.empty() ? "files/" : "files/" + fileName(setup) + "/") + name;
}

void writeProgramFiles(const std::map<std::string, std::string>& files, const std::string& setup,
                       StagingFolder& staging, OutputFailures& failures) {
  for (const auto& [name, bytes] : files)
    keep(writeText(programFileName(setup, name), bytes, staging), failures);
}

namespace {

/// Writes one mesh, or the grid, and records it.
void writeMesh(const TriMesh& mesh, const Stock* stock, OutputFormat format, const std::string& file,
               StagingFolder& staging, Report& report, OutputFailures& failures) {
  std::string hash;
  const Status written = staging.write(file, [&](const std::string& path) -> Status {
    Result<std::string> made = format == OutputFormat::kVdb ? saveHashed(*stock, path)
                                                            : writeMeshHashed(mesh, path, meshFormat(format));
    if (!made) return made.error();
    hash = std::move(*made);
    return Done{};
  });
  keep(written, failures);
  if (written) report.outputs.meshes.push_back({file, std::string(outputFormatName(format)), hash});
}

}  // namespace

void writeMeshes(const TriMesh& mesh, const Stock* stock, const Job& job, StagingFolder& staging,
                 Report& report, OutputFailures& failures) {
  for (const OutputFormat format : job.output.formats) {
    if (format == OutputFormat::kVdb && stock == nullptr) continue;  // turning left nothing to make a grid of
    writeMesh(mesh, stock, format, meshFileName(job, format), staging, report, failures);
  }
}

std::string bodyFileName(const Job& job, OutputFormat format, std::size_t number) {
  return fmt::format("slugs/{}-{}", number, meshFileName(job, format));
}

void writeBodies(const std::vector<TriMesh>& bodies, const Job& job, StagingFolder& staging, Report& report,
                 OutputFailures& failures) {
  for (const OutputFormat format : job.output.formats) {
    if (format == OutputFormat::kVdb) continue;
    for (std::size_t k = 0; k < bodies.size(); ++k)
      writeMesh(bodies[k], nullptr, format, bodyFileName(job, format, k + 1), staging, report, failures);
  }
}

std::string sectionFileName(double z) { return fmt::format("section-z{:g}.svg", z); }

void writeSections(const TriMesh& mesh, const std::vector<TriMesh>& freed, const Job& job,
                   StagingFolder& staging, Report& report, OutputFailures& failures) {
  if (job.output.sections.empty()) return;
  const TriMesh part = withoutPieces(mesh, freed);
  for (const double z : job.output.sections) {
    const SectionPolygons polygons = cutAtHeight(part, z);
    std::vector<SectionPolygons> pieces;
    for (const TriMesh& piece : freed) pieces.push_back(cutAtHeight(piece, z));
    const std::string svg = sectionSvgFile(
        fmt::format("{}, z = {:g} mm: {:.4f} mm2", job.name, z, areaOf(polygons)), polygons, pieces);
    if (svg.empty()) {
      failures.push_back(inputError(fmt::format("sections: there is no material at the height {:g}", z)));
      continue;
    }
    const Status written = writeText(sectionFileName(z), svg, staging);
    keep(written, failures);
    if (written) report.outputs.tables.push_back(sectionFileName(z));
  }
}

namespace {

Status writeBlocks(const std::vector<CutPath>& paths, const std::string& path) {
  Result<AtomicFile> file = AtomicFile::create(path);
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
  return file->commit();
}

}  // namespace

void writeTables(const std::vector<CutPath>& paths, StagingFolder& staging, Report& report,
                 OutputFailures& failures) {
  const auto table = [&](const std::string& name, const Status& written) {
    keep(written, failures);
    if (written) report.outputs.tables.push_back(name);
  };
  table("blocks.csv",
        staging.write("blocks.csv", [&](const std::string& path) { return writeBlocks(paths, path); }));
  const std::string svg = report.accounting ? rateSvgFile(report.accounting->rate) : std::string();
  if (!svg.empty()) table("mrr.svg", writeText("mrr.svg", svg, staging));
}

void writeProfileChart(const std::vector<std::vector<Vec2>>& machined, const TriMesh* nominal,
                       const ProfileChartOptions& options, StagingFolder& staging, Report& report,
                       OutputFailures& failures) {
  const std::vector<SectionSegment> section = nominal ? halfSection(*nominal) : std::vector<SectionSegment>();
  ProfileChart chart = drawProfileChart(machined, section, options);
  if (chart.file.empty()) return;
  report.profile_svg = std::move(chart.page);
  const Status written = writeText("profile.svg", chart.file, staging);
  keep(written, failures);
  if (written) report.outputs.tables.push_back("profile.svg");
}

namespace {

void writeFindings(StagingFolder& staging, Report& report, OutputFailures& failures) {
  const std::string name = "findings.csv";
  std::string hash;
  const Status written = staging.write(name, [&](const std::string& path) -> Status {
    Result<std::string> made = writeHashed(path, findingsCsv(report.findings));
    if (!made) return made.error();
    hash = std::move(*made);
    return Done{};
  });
  keep(written, failures);
  if (written) report.outputs.data.push_back({name, "findings", hash});
}

}  // namespace

void writeReport(const std::vector<Picture>& pictures, StagingFolder& staging, Report& report,
                 OutputFailures& failures, PageContent page, bool findings_csv) {
  std::size_t told = 0;
  const auto tell = [&] {
    for (; told < failures.size(); ++told) {
      Finding finding(FindingKind::kOutput);
      finding.message = failures[told].message;
      report.findings.push_back(std::move(finding));
    }
    report.verdict = verdictOf(report);
  };
  for (const Picture& picture : pictures) {
    page.pictures.push_back({picture.title, picture.png});
    const Status written = writeText(picture.file, picture.png, staging);
    keep(written, failures);
    if (written) report.outputs.images.push_back({picture.file, picture.title});
  }
  tell();
  if (findings_csv) writeFindings(staging, report, failures);
  report.outputs.html = "report.html";
  tell();
  if (const Status html = writeText("report.html", reportPage(report, page), staging); !html) {
    keep(html, failures);
    report.outputs.html.clear();
    tell();
  }
  keep(writeText("junit.xml", reportJunit(report), staging), failures);
  tell();
  keep(writeText("report.json", reportJson(report), staging), failures);
  tell();
}

int exitCodeOf(const Report& report, const OutputFailures& failures) {
  int code = failures.empty() ? exitCodeOf(report.verdict) : kExitInput;
  for (const Error& failure : failures) code = std::max(code, exitCodeOf(failure.kind));
  return code;
}

}  // namespace proveout
