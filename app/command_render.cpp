#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/input_files.h"
#include "app/pictures.h"
#include "app/session/forecast/thread_supply.h"
#include "app/session/nominal/nominal_mesh.h"
#include "app/time_limit.h"
#include "core/geometry/place_text.h"
#include "io/atomic_file.h"
#include "io/mesh_io.h"
#include "io/output_guard.h"
#include "io/png.h"
#include "removal/compare/fit/fit.h"
#include "render/render.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxReportBytes = std::size_t{256} << 20;

/// What a report says of its comparison.
struct HeatMapSource {
  NominalSpec nominal;
  double resolution_mm = 0.2;
};

/// The motion of an alignment: its matrix has three rows of four numbers.
std::optional<RigidTransform> readMotion(const nlohmann::json& alignment) {
  constexpr double kRounding = 1e-6;
  const nlohmann::json rows =
      alignment.is_object() ? alignment.value("matrix", nlohmann::json()) : nlohmann::json();
  if (!rows.is_array() || rows.size() != 3) return std::nullopt;
  RigidTransform out;
  for (int row = 0; row < 3; ++row) {
    const nlohmann::json& numbers = rows[static_cast<std::size_t>(row)];
    if (!numbers.is_array() || numbers.size() != 4) return std::nullopt;
    for (int k = 0; k < 4; ++k) {
      const nlohmann::json& number = numbers[static_cast<std::size_t>(k)];
      if (!number.is_number() || !(std::abs(number.get<double>()) <= 1e9)) return std::nullopt;
      (k < 3 ? out.rotation(row, k) : out.translation[row]) = number.get<double>();
    }
  }
  const bool turns =
      (out.rotation * out.rotation.transpose()).isIdentity(kRounding) && out.rotation.determinant() > 0.0;
  return turns ? std::optional(out) : std::nullopt;
}

/// Three finite numbers.
std::optional<Vec3> readTriple(const nlohmann::json& object, const char* key) {
  const nlohmann::json list = object.is_object() ? object.value(key, nlohmann::json()) : nlohmann::json();
  if (!list.is_array() || list.size() != 3) return std::nullopt;
  Vec3 out;
  for (int k = 0; k < 3; ++k) {
    if (!list[static_cast<std::size_t>(k)].is_number()) return std::nullopt;
    out[k] = list[static_cast<std::size_t>(k)].get<double>();
    if (!(std::abs(out[k]) <= 1e9)) return std::nullopt;
  }
  return out;
}

std::optional<MeshPlacement> readPlacement(const nlohmann::json& placement) {
  const auto rotate = readTriple(placement, "rotate"), move = readTriple(placement, "move");
  const nlohmann::json scale =
      placement.is_object() ? placement.value("scale", nlohmann::json()) : nlohmann::json();
  if (!rotate || !move || !scale.is_number() || !(scale.get<double>() > 0.0)) return std::nullopt;
  return MeshPlacement{scale.get<double>(), *rotate, *move};
}

Result<HeatMapSource> readHeatMapSource(const std::string& path) {
  const Result<std::string> text = readWholeFile(path, kMaxReportBytes);
  if (!text) return text.error();
  const nlohmann::json root = nlohmann::json::parse(*text, nullptr, false);
  const auto wrong = [&](const char* what) { return inputError(fmt::format("{}: {}", path, what)); };
  if (root.is_discarded() || !root.is_object()) return wrong("not a report: it is no JSON document");
  if (!root.contains("comparison") || !root["comparison"].is_object()) {
    return wrong("the report has no comparison with a nominal mesh to colour by");
  }
  const nlohmann::json& comparison = root["comparison"];
  HeatMapSource source;
  const auto number = [](const nlohmann::json& object, const char* key, double& value) {
    if (!object.contains(key) || !object[key].is_number()) return false;
    value = object[key].get<double>();
    return value > 0 && value < 1e6;
  };
  const bool complete = comparison.contains("nominal") && comparison["nominal"].is_string() &&
                        number(comparison, "gouge_tolerance_mm", source.nominal.gouge_mm) &&
                        number(comparison, "excess_tolerance_mm", source.nominal.excess_mm) &&
                        number(root, "resolution_mm", source.resolution_mm);
  if (!complete) return wrong("the comparison in the report lacks its nominal, tolerances or resolution");
  const nlohmann::json unit = comparison.value("nominal_unit", nlohmann::json("mm"));
  const Result<MeshUnit> known = parseMeshUnit(unit.is_string() ? unit.get<std::string>() : "");
  if (!known) return wrong("the comparison's nominal_unit is none of mm, inch, m");
  source.nominal.mesh.unit = *known;
  source.nominal.mesh.path = comparison["nominal"].get<std::string>();
  if (comparison.contains("placement")) {
    const auto placement = readPlacement(comparison["placement"]);
    if (!placement)
      return wrong("the comparison's placement is none: scale above 0, rotate and move of three numbers");
    source.nominal.placement = *placement;
  }
  if (comparison.contains("alignment")) {
    const auto motion = readMotion(comparison["alignment"]);
    if (!motion) return wrong("the comparison's alignment has no matrix of three rows that turns and moves");
    source.nominal.placement = chained(source.nominal.placement, placementOf(*motion));
  }
  std::error_code error;
  const fs::path beside = fs::path(path).parent_path() / source.nominal.mesh.path;
  if (!fs::exists(source.nominal.mesh.path, error) && fs::exists(beside, error)) {
    source.nominal.mesh.path = beside.string();
  }
  return source;
}

Result<Comparison> compareForHeatMap(const TriMesh& mesh, const HeatMapSource& source, int threads,
                                     Progress& progress) {
  const Result<PreparedMesh> nominal = loadNominal(source.nominal);
  if (!nominal) return nominal.error();
  CompareOptions options;
  options.gouge_mm = source.nominal.gouge_mm;
  options.excess_mm = source.nominal.excess_mm;
  options.resolution_mm = source.resolution_mm;
  options.threads = threads;
  options.nominal_faces = nominal->faces;
  options.measure_features = false;
  return compareToNominal(mesh, nominal->mesh, options, progress);
}

/// A cut shows what is inside: that needs a surface that tells inside from outside.
Status checkForSection(const TriMesh& mesh, const std::string& path) {
  const MeshTopology topology = analyseTopology(mesh);
  if (topology.boundary_edges + topology.misoriented_edges > 0) {
    return inputError(fmt::format(
        "{}: the view 'section' needs a closed mesh (open edges {}, inconsistent edges {}), "
        "first defect near {}",
        path, topology.boundary_edges, topology.misoriented_edges, placeText(topology.first_defect)));
  }
  if (meshVolume(mesh) > 0.0) return Done{};
  return inputError(path + ": the view 'section' needs a solid; this mesh is inside out or without volume");
}

/// Whether a mesh is round about Z and longer than wide, threads included: it is shown as a turned part.
bool isTurned(const TriMesh& mesh) {
  constexpr double kLean = 0.02;  // of the surface, towards or against the turning
  const Box3 box = meshBounds(mesh);
  const Vec3 size = box.size(), middle = box.center();
  if (size.z() < size.x() || std::abs(size.x() - size.y()) > 0.01 * size.x() ||
      middle.head<2>().norm() > 0.01 * size.x())
    return false;
  double area = 0.0, leaning = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    const Vec3 n = (b - a).cross(c - a), p = (a + b + c) / 3.0;
    const double r = p.head<2>().norm();
    area += n.norm();
    if (r > 0.0) leaning += std::abs(p.x() * n.y() - p.y() * n.x()) / r;
  }
  return leaning <= kLean * area;
}

/// Errors: the picture would be written over what it is made of.
Status checkOutput(const RenderCommandOptions& options, const std::string& output,
                   const std::optional<HeatMapSource>& colours) {
  OutputGuard guard;
  guard.protect("mesh", options.mesh);
  if (options.heatmap) guard.protect("report", *options.heatmap);
  if (colours) guard.protect("nominal", colours->nominal.mesh.path);
  return guard.check(output);
}

Status renderToFile(const RenderCommandOptions& options, const std::string& output, Progress& progress) {
  const ThreadSupply threads(options.threads.value_or(0));
  Result<View> view = findView(options.view);
  if (!view) return view.error();
  const Result<ImageSize> size = parseImageSize(options.size);
  if (!size) return size.error();
  const Result<MeshUnit> unit = parseMeshUnit(options.unit);
  if (!unit) return inputError("--unit: " + unit.error().message);
  std::optional<HeatMapSource> colours;
  if (Status settled =
          settleInputs({{"mesh", options.mesh}, {"report", options.heatmap.value_or(options.mesh)}});
      !settled)
    return settled;
  if (options.heatmap) {
    Result<HeatMapSource> source = readHeatMapSource(*options.heatmap);
    if (!source) return source.error();
    colours = std::move(*source);
  }
  if (Status free = checkOutput(options, output, colours); !free) return free;
  MeshLoadOptions loading;
  loading.unit = *unit;
  Result<TriMesh> mesh = loadMesh(options.mesh, loading);
  if (!mesh) return mesh.error();
  if (view->section) {
    if (Status closed = checkForSection(*mesh, options.mesh); !closed) return closed;
  }
  std::optional<Comparison> comparison;
  if (colours) {
    Result<PreparedMesh> solid = prepareNominal(*mesh, options.mesh);
    if (!solid) return solid.error();
    *mesh = std::move(solid->mesh);
    Result<Comparison> done = compareForHeatMap(*mesh, *colours, options.threads.value_or(0), progress);
    if (!done) return done.error();
    comparison = std::move(*done);
  }
  RenderScene scene(*mesh);
  if (comparison) addHeatMap(*comparison, scene);
  RenderOptions settings;
  if (isTurned(*mesh)) {
    view = findTurnedView(options.view);
    if (!view) return view.error();
    if (view->section) scene.section = SectionCut{Vec2::Zero(), 1, 1};
    settings.ground = false;
  }
  settings.threads = options.threads.value_or(0);
  const Result<Image> image = renderMesh(scene, *view, *size, settings, progress);
  if (!image) return image.error();
  return writePng(*image, output);
}

bool isPngName(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".png";
}

}  // namespace

int renderCommand(const RenderCommandOptions& options, Console& console, ConsoleProgress& progress) {
  if (!options.output.empty() && !isPngName(options.output)) {
    return printError(console, inputError(options.output + ": pictures are PNG; the name must end in .png"));
  }
  const std::string output =
      options.output.empty() ? fs::path(options.mesh).stem().string() + ".png" : options.output;
  TimeLimit limit(progress);
  limit.set(options.max_time_s.value_or(kDefaultMaxTimeS));
  progress.show(console.err_is_terminal);
  const Status done = renderToFile(options, output, progress);
  progress.clear();
  if (!done) return printError(console, limit.told(done.error()));
  return kExitOk;
}

}  // namespace proveout
