#include "app/page/setup_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "app/page/shape_mesh.h"
#include "app/session/nominal/nominal_mesh.h"
#include "core/geometry/place_text.h"
#include "core/path/origin_query.h"
#include "core/tool/tool_table.h"
#include "io/png.h"
#include "render/render.h"

namespace proveout {
namespace {

constexpr ImageSize kSheetPicture{640, 440};
constexpr Rgb kWorkpiece{0.72F, 0.75F, 0.78F}, kFixture{0.85F, 0.52F, 0.22F};

std::string shapeText(const StockSpec& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    const Vec3 size = box->max - box->min;
    return fmt::format("box {:g} x {:g} x {:g} mm, {}", size.x(), size.y(), size.z(),
                       extentText({box->min, box->max}));
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    const std::string inner =
        cylinder->inner_radius > 0.0 ? fmt::format(", bore {:g}", 2.0 * cylinder->inner_radius) : "";
    return fmt::format("{} of diameter {:g}{}, {:g} mm long along {}, from {}",
                       cylinder->inner_radius > 0.0 ? "tube" : "bar", 2.0 * cylinder->radius, inner,
                       cylinder->length, "XYZ"[cylinder->axis], placeText(cylinder->base));
  }
  if (const auto* mesh = std::get_if<MeshFile>(&shape))
    return mesh->path + (mesh->body.empty() ? "" : ", body " + mesh->body);
  return std::get<SavedStock>(shape).path;
}

/// "turned by A180 (about X), moved by X.. Y.. Z..".
std::string moveText(const RigidTransform& move) {
  const Vec3 turn = xyzDegOf(move.rotation);
  std::string out;
  if (!turn.isZero(1e-9)) {
    out = "turned by";
    for (int k = 0; k < 3; ++k)
      if (std::abs(turn[k]) > 1e-9) out += fmt::format(" {:.6g} about {}", turn[k], "XYZ"[k]);
  }
  if (!move.translation.isZero(1e-9))
    out += fmt::format("{}moved by {}", out.empty() ? "" : ", ", placeText(move.translation));
  return out.empty() ? "as it lies" : out;
}

/// The work systems that the program called, each once, in their order.
std::vector<const DataInForce*> zerosOf(const Toolpath& path) {
  std::vector<const DataInForce*> out;
  std::set<std::int32_t> seen;
  for (const DataInForce& data : path.origins.data)
    if (data.work_system > 0 && seen.insert(data.work_system).second) out.push_back(&data);
  return out;
}

std::string offsetText(const char* letter, const OffsetInForce& offset) {
  return offset.row > 0 ? fmt::format("{}{} = {:.3f}", letter, offset.row, offset.value()) : "";
}

void addText(const std::string& text, std::string& all) {
  if (text.empty() || (", " + all + ", ").find(", " + text + ", ") != std::string::npos) return;
  all += (all.empty() ? "" : ", ") + text;
}

/// What a cut of the tool was made with. D alone where it counts.
void addData(const Motion& motion, const DataInForce& data, SheetTool& tool) {
  addText(offsetText("H", data.length), tool.length_offset);
  if (motion.compensated) addText(offsetText("D", data.radius), tool.radius_offset);
  if (data.nose_tool != data.tool || data.nose_tool == 0) return;
  if (!data.tool_offset.isZero(0.0))
    addText(fmt::format("X{:.3f} Z{:.3f}", data.tool_offset.x(), data.tool_offset.z()), tool.length_offset);
  if (data.nose_radius > 0.0)
    addText(fmt::format("R{:.3f} tip {}", data.nose_radius, data.tip), tool.radius_offset);
}

SheetTool toolOf(const SetupRun& setup, std::int32_t number) {
  SheetTool row;
  row.number = number;
  const Tool* tool = ToolTable(setup.job.tools).find(number);
  if (tool == nullptr) return row;
  row.name = tool->name;
  row.description = describe(*tool);
  if (tool->overall_length > 0.0) row.stick_out = tool->overall_length;
  return row;
}

std::vector<SheetTool> toolsOf(const SetupRun& setup) {
  const Toolpath& path = setup.interpreted.path;
  std::vector<SheetTool> out;
  std::map<std::int32_t, std::size_t> rows;
  std::set<std::tuple<std::int32_t, const DataInForce*, bool>> seen;
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    const Motion& motion = path.motions[id];
    if (motion.tool == 0) continue;
    const auto [row, first] = rows.emplace(motion.tool, out.size());
    if (first) out.push_back(toolOf(setup, motion.tool));
    if (motion.kind == MotionKind::kRapid) continue;
    const DataInForce* data = dataOf(path, id);
    if (data != nullptr && seen.emplace(motion.tool, data, motion.compensated).second)
      addData(motion, *data, out[row->second]);
  }
  return out;
}

std::vector<SheetLine> linesOf(const Job& job, const RunResult& run, std::size_t k) {
  const SetupRun& setup = run.setups[k];
  std::vector<SheetLine> lines;
  lines.push_back({"Control", setup.job.control});
  if (k == 0) {
    if (job.stock) lines.push_back({"Blank", shapeText(*job.stock)});
  } else {
    lines.push_back(
        {"Workpiece", fmt::format("from {}: {}", run.setups[k - 1].name, moveText(setup.from_previous))});
  }
  for (const FixtureSpec& fixture : setup.job.fixtures)
    lines.push_back({"Fixture " + fixture.name, shapeText(fixture.shape)});
  for (const DataInForce* data : zerosOf(setup.interpreted.path))
    lines.push_back({workSystemName(data->work_system),
                     placeText(data->work_offset.value + data->common_offset.value) + " in the machine"});
  return lines;
}

/// Where the work systems have their zero, in the workpiece frame.
std::vector<Marker> zeroMarkers(const SetupRun& setup) {
  std::vector<Marker> markers;
  const Vec3 origin = workpieceZero(setup.job.settings);
  for (const DataInForce* data : zerosOf(setup.interpreted.path)) {
    if (data->work_system >= kFirstExtendedSystem || markers.size() == 8) continue;
    markers.push_back({data->work_offset.value + data->common_offset.value - origin,
                       workSystemName(data->work_system), Severity::kNote});
  }
  if (markers.empty()) markers.push_back({Vec3::Zero(), "zero", Severity::kNote});
  return markers;
}

/// The workpiece as it comes into a clamping; none where its shape cannot be drawn.
std::optional<TriMesh> workpieceBefore(const Job& job, const RunResult& run, std::size_t k) {
  if (k > 0) {
    TriMesh mesh = run.setups[k - 1].surface.mesh;
    moveMesh(run.setups[k].from_previous, mesh);
    return mesh;
  }
  if (!job.stock) return std::nullopt;
  const Result<LoadedSolid> solid = loadSolid(*job.stock);
  return solid ? meshOfShape(solid->shape) : std::nullopt;
}

/// Bytes of a PNG file; empty where nothing can be drawn.
std::string draw(const RenderScene& scene, bool turns, int threads, Progress& progress) {
  const Result<View> view = turns ? findTurnedView("iso") : findView("iso");
  if (!view) return "";
  RenderOptions options;
  options.threads = threads;
  options.ground = !turns;
  const Result<Image> image = renderMesh(scene, *view, kSheetPicture, options, progress);
  if (!image) return "";
  Result<std::string> png = encodePng(*image);
  return png ? std::move(*png) : "";
}

std::string drawBefore(const Job& job, const RunResult& run, std::size_t k, Progress& progress) {
  const SetupRun& setup = run.setups[k];
  std::optional<TriMesh> mesh = workpieceBefore(job, run, k);
  if (!mesh || mesh->triangles.empty()) return "";
  std::vector<Rgb> colours(mesh->triangles.size(), kWorkpiece);
  mesh->motion.clear();
  for (const FixtureSpec& fixture : setup.job.fixtures) {
    const Result<LoadedSolid> solid = loadSolid(fixture.shape);
    if (!solid) continue;
    if (const std::optional<TriMesh> shape = meshOfShape(solid->shape)) appendMesh(*shape, *mesh);
    colours.resize(mesh->triangles.size(), kFixture);
  }
  RenderScene scene(*mesh);
  scene.triangle_colors = std::move(colours);
  scene.markers = zeroMarkers(setup);
  return draw(scene, setup.form->pictureAxis().has_value(), job.simulation.threads, progress);
}

}  // namespace

std::vector<SetupSheet> setupSheets(const Job& job, const RunResult& run, Progress& progress) {
  std::vector<SetupSheet> sheets;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    const SetupRun& setup = run.setups[k];
    const Toolpath& path = setup.interpreted.path;
    SetupSheet sheet;
    sheet.setup = setup.name;
    sheet.program = path.files.empty() ? "" : path.files.front();
    sheet.lines = linesOf(job, run, k);
    sheet.tools = toolsOf(setup);
    if (!job.output.views.empty()) {
      sheet.before = drawBefore(job, run, k, progress);
      // That of the last one is the first picture of the page.
      if (k + 1 < run.setups.size() && !setup.surface.mesh.triangles.empty())
        sheet.after = draw(RenderScene(setup.surface.mesh), setup.form->pictureAxis().has_value(),
                           job.simulation.threads, progress);
    }
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

}  // namespace proveout
