#include "app/deviation/deviation_outputs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <optional>

#include "app/deviation/shaded_vertices.h"
#include "app/deviation/surface_blocks.h"
#include "app/job_setup.h"
#include "app/session/findings/feature_table.h"
#include "core/base/memory.h"
#include "core/base/parallel_for.h"
#include "io/exchange/deviation_mesh.h"
#include "io/exchange/hashed_file.h"
#include "io/exchange/inspection_csv.h"
#include "removal/compare/sample_mesh.h"
#include "render/color_map.h"

namespace proveout {
namespace {

/// So many points are measured between two looks at whether the command was told to stop.
constexpr std::size_t kMeasuredAtOnce = 4096;

/// The same sampled surface that was compared: of large triangles the middles count, too.
SampleMesh sampledPart(const TriMesh& machined, const Comparison& comparison) {
  return makeSampleMesh(machined, comparison.machined_spacing_mm, std::numeric_limits<std::size_t>::max());
}

/// Of the mesh's own vertices as compared, of those between by the same measure.
std::vector<float> deviationsOf(const SampleMesh& sample, const Comparison& comparison, Progress& progress) {
  std::vector<float> out(sample.surface.points.size());
  const std::size_t known = comparison.vertex_deviation.size();
  std::copy(comparison.vertex_deviation.begin(), comparison.vertex_deviation.end(), out.begin());
  const std::size_t pieces = (out.size() - known + kMeasuredAtOnce - 1) / kMeasuredAtOnce;
  parallelFor(std::size_t{0}, pieces, [&](std::size_t piece) {
    if (progress.cancelled()) return;
    const std::size_t first = known + piece * kMeasuredAtOnce;
    for (std::size_t i = first; i < std::min(out.size(), first + kMeasuredAtOnce); ++i)
      out[i] = comparison.field->at(sample.surface.points[i]);
  });
  return out;
}

std::array<std::uint8_t, 3> byteColour(const Rgb& colour) {
  std::array<std::uint8_t, 3> out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = static_cast<std::uint8_t>(std::lround(255.0F * colour[k]));
  return out;
}

/// Without blocks.
DeviationMesh deviationMesh(const SampleMesh& sample, const Comparison& comparison, Progress& progress) {
  const DeviationScale scale =
      deviationScaleFor(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm,
                        std::max(comparison.max_gouge_mm, comparison.max_excess_mm));
  DeviationMesh out;
  out.gouge_mm = scale.gouge;
  out.excess_mm = scale.excess;
  out.limit_mm = scale.limit;
  out.triangles = sample.surface.triangles;
  out.deviation = deviationsOf(sample, comparison, progress);
  out.positions.reserve(out.deviation.size());
  out.colours.reserve(out.deviation.size());
  for (const Vec3& p : sample.surface.points) out.positions.push_back(p.cast<float>());
  for (const float deviation : out.deviation)
    out.colours.push_back(byteColour(deviationColor(scale, deviation)));
  return out;
}

/// Vertices over tolerance, the largest deviation first.
std::vector<std::uint32_t> overTolerance(const DeviationMesh& mesh) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < mesh.deviation.size(); ++i) {
    const double deviation = mesh.deviation[i];
    if (deviation > mesh.excess_mm || deviation < -mesh.gouge_mm) out.push_back(i);
  }
  std::stable_sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::abs(mesh.deviation[a]) > std::abs(mesh.deviation[b]);
  });
  return out;
}

void setBlock(const DeviationMesh& mesh, std::uint32_t vertex, DeviationPoint& row) {
  if (mesh.made_by.empty()) return;
  const SurfaceBlock& by = mesh.blocks[mesh.made_by[vertex]];
  if (by.setup >= 0) row.setup = mesh.setups[static_cast<std::size_t>(by.setup)];
  if (by.file >= 0) row.file = mesh.files[static_cast<std::size_t>(by.file)];
  row.line = by.line;
  row.block = by.block;
  row.tool = by.tool;
}

Result<std::string> writePoints(const DeviationMesh& mesh, const Comparison& comparison,
                                const std::string& path) {
  const std::vector<std::uint32_t> points = overTolerance(mesh);
  std::vector<NominalFoot> feet(points.size());
  parallelFor(std::size_t{0}, points.size(), [&](std::size_t i) {
    feet[i] = comparison.field->footOf(mesh.positions[points[i]].cast<double>());
  });
  Result<HashedFile> file = HashedFile::create(path);
  if (!file) return file.error();
  std::map<std::uint32_t, std::string> features;
  std::string piece = pointsCsvHeader();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t vertex = points[i], face = feet[i].face;
    DeviationPoint row;
    row.at = mesh.positions[vertex].cast<double>();
    row.deviation_mm = mesh.deviation[vertex];
    row.normal = feet[i].normal;
    row.tolerance_mm = row.deviation_mm > 0.0 ? mesh.excess_mm : mesh.gouge_mm;
    if (face != kNoFace && comparison.nominal_faces != nullptr) {
      const auto [place, is_new] = features.try_emplace(face);
      if (is_new) place->second = featureAt(face, comparison);
      row.feature = place->second;
    }
    setBlock(mesh, vertex, row);
    appendPointsCsv(row, piece);
    if (piece.size() < (std::size_t{1} << 20)) continue;
    file->write(piece);
    piece.clear();
  }
  file->write(piece);
  return file->commit();
}

Result<std::string> writeOne(const DeviationMesh& mesh, const Comparison& comparison, DeviationOutput output,
                             const std::string& path) {
  switch (output) {
    case DeviationOutput::kPly:
      return writeDeviationPly(mesh, path);
    case DeviationOutput::kGlb:
      return writeDeviationGlb(mesh, shadedVertices(mesh), path);
    case DeviationOutput::kCsv:
      break;
  }
  return writePoints(mesh, comparison, path);
}

void writeFiles(const std::string& part, const DeviationMesh& mesh, const Comparison& comparison,
                const std::vector<DeviationOutput>& outputs, StagingFolder& staging, Report& report,
                OutputFailures& failures) {
  for (const DeviationOutput output : outputs) {
    const std::string name = deviationFileName(part, output);
    std::string hash;
    const Status written = staging.write(name, [&](const std::string& path) -> Status {
      Result<std::string> made = writeOne(mesh, comparison, output, path);
      if (!made) return made.error();
      hash = std::move(*made);
      return Done{};
    });
    if (!written) failures.push_back(written.error());
    if (written)
      report.outputs.data.push_back(
          {name, output == DeviationOutput::kCsv ? "points" : "deviation", std::move(hash)});
  }
}

/// `run`: null where no program is known.
void writeDeviations(const std::string& part, const TriMesh& machined, const Comparison& comparison,
                     const std::vector<DeviationOutput>& outputs, const RunResult* run,
                     const RunSources& sources, Progress& progress, StagingFolder& staging, Report& report,
                     OutputFailures& failures) {
  if (outputs.empty() || comparison.field == nullptr) return;
  try {
    std::optional<SampleMesh> sample = sampledPart(machined, comparison);
    DeviationMesh mesh = deviationMesh(*sample, comparison, progress);
    if (run != nullptr) addBlocks(*sample, *run, sources, mesh);
    sample.reset();
    if (progress.cancelled()) return;
    writeFiles(part, mesh, comparison, outputs, staging, report, failures);
  } catch (const std::bad_alloc&) {
    failures.push_back(outOfMemory("the deviations do not fit into memory", "use a coarser grid"));
  }
}

}  // namespace

std::string deviationFileName(const std::string& part, DeviationOutput output) {
  if (output == DeviationOutput::kCsv) return "points.csv";
  return fileName(part) + "-deviation." + std::string(deviationOutputName(output));
}

void writeRunDeviation(const Job& job, const RunResult& run, const RunSources& sources, Progress& progress,
                       StagingFolder& staging, Report& report, OutputFailures& failures) {
  if (!run.comparison) return;
  writeDeviations(job.name, run.surface().mesh, *run.comparison, job.output.deviation, &run, sources,
                  progress, staging, report, failures);
}

void writePairDeviation(const std::string& part, const TriMesh& machined, const Comparison& comparison,
                        const std::vector<DeviationOutput>& outputs, Progress& progress,
                        StagingFolder& staging, Report& report, OutputFailures& failures) {
  writeDeviations(part, machined, comparison, outputs, nullptr, {}, progress, staging, report, failures);
}

}  // namespace proveout
