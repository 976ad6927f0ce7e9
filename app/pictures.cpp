#include "app/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/freed_pieces.h"
#include "core/mesh/shells.h"
#include "io/png.h"

namespace proveout {
namespace {

/// More numbers than this hide the part; the report lists all of them.
constexpr std::size_t kMaxMarkers = 12;

/// Captions are ASCII: other bytes become question marks.
std::string ascii(const std::string& text) {
  std::string result = text.substr(0, 60);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

/// By how much of their height freed pieces are moved.
constexpr float kLift = 1.3f;

/// The part, slugs above it, and frames, which are larger than the part, below.
TriMesh takenApart(const TriMesh& mesh, const std::vector<TriMesh>& pieces) {
  TriMesh out = withoutPieces(mesh, pieces);
  const double part_mm3 = meshVolume(out);
  for (TriMesh piece : pieces) {
    const float up = meshVolume(piece) <= part_mm3 ? kLift : -kLift;
    const Eigen::Vector3f lift(0.0f, 0.0f, up * static_cast<float>(meshBounds(piece).size().z()));
    for (Eigen::Vector3f& p : piece.positions) p += lift;
    append(out, piece);
  }
  return out;
}

std::vector<Marker> markersOf(const std::vector<Finding>& findings, bool deviations) {
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < findings.size() && markers.size() < kMaxMarkers; ++i) {
    if (!findings[i].where || isDeviation(findings[i].kind) != deviations) continue;
    markers.push_back({*findings[i].where, fmt::format("{}", i + 1), findings[i].severity});
  }
  return markers;
}

}  // namespace

void addHeatMap(const Comparison& comparison, RenderScene& scene) {
  scene.field.per = ScalarField::Per::kVertex;
  scene.field.values = comparison.vertex_deviation;
  if (comparison.field) {
    scene.field.at = [field = comparison.field](const Vec3& p) { return field->at(p); };
    scene.field.largest_mm = comparison.machined_spacing_mm;
  }
  scene.field.scale = deviationScaleFor(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm,
                                        std::max(comparison.max_gouge_mm, comparison.max_excess_mm));
  scene.show_legend = true;
  scene.legend.title = "deviation";
}

/// Annotations need a picture of some size; a thumbnail goes without.
bool PictureMaker::annotated() const { return request_.size.width >= 160 && request_.size.height >= 120; }

/// Errors: interrupted. Others are kept.
Status PictureMaker::add(RenderScene scene, const std::string& view_name, const std::string& file,
                         const std::string& title, Progress& progress) {
  Result<std::string> png = draw(std::move(scene), view_name, progress);
  if (png) {
    pictures.push_back({file, title, std::move(*png)});
  } else if (png.error().kind == ErrorKind::kInterrupted) {
    return png.error();
  } else {
    failures.push_back({png.error().kind, file + ": " + png.error().message});
  }
  return Done{};
}

/// Bytes of the PNG file.
Result<std::string> PictureMaker::draw(RenderScene scene, const std::string& view_name,
                                       Progress& progress) const {
  const bool turned = turned_axis_.has_value();
  const Result<View> view = turned ? findTurnedView(view_name) : findView(view_name);
  if (!view) return view.error();
  if (view->section && turned) scene.section = SectionCut{*turned_axis_, 1, 1};
  RenderOptions options;
  options.ground = !turned;  // the part lies on no table
  options.threads = request_.threads;
  const Result<Image> image = renderMesh(scene, *view, request_.size, options, progress);
  if (!image) return image.error();
  return encodePng(*image);
}

RenderScene PictureMaker::sceneOf(const TriMesh& mesh) {
  RenderScene scene(mesh);
  if (!drawn_) {
    // What is wrong with the mesh the picture says as well.
    if (auto drawn = prepareDrawing(mesh, request_.threads)) drawn_ = std::move(*drawn);
  }
  scene.drawn = drawn_;
  return scene;
}

Status PictureMaker::drawViews(const TriMesh& mesh, Progress& progress) {
  if (!drawsOf(mesh)) return Done{};
  for (const std::string& view : request_.views) {
    if (Status done = add(sceneOf(mesh), view, view + ".png", view, progress); !done) return done;
  }
  return Done{};
}

Status PictureMaker::drawApart(const TriMesh& mesh, const std::vector<TriMesh>& freed, Progress& progress) {
  if (!drawsOf(mesh) || freed.empty()) return Done{};
  const TriMesh apart = takenApart(mesh, freed);
  return add(RenderScene(apart), request_.views.front(), "apart.png", "bodies apart", progress);
}

Status PictureMaker::drawDeviation(const TriMesh& mesh, const Comparison& comparison,
                                   const std::vector<Finding>& findings, Progress& progress) {
  if (!drawsOf(mesh)) return Done{};
  RenderScene scene = sceneOf(mesh);
  addHeatMap(comparison, scene);
  scene.show_legend = annotated();
  if (annotated()) {
    scene.markers = markersOf(findings, true);
    scene.caption = fmt::format("{}: gouge {:.3g} mm (allowed {:g}), excess {:.3g} mm (allowed {:g})",
                                ascii(request_.name), comparison.max_gouge_mm, comparison.gouge_tolerance_mm,
                                comparison.max_excess_mm, comparison.excess_tolerance_mm);
  }
  return add(std::move(scene), request_.views.front(), "deviation.png", "deviation", progress);
}

Status PictureMaker::drawFindings(const TriMesh& mesh, const std::vector<Finding>& findings,
                                  Progress& progress) {
  const std::vector<Marker> markers = markersOf(findings, false);
  if (!drawsOf(mesh) || markers.empty() || !annotated()) return Done{};
  RenderScene scene = sceneOf(mesh);
  scene.markers = markers;
  const std::size_t located =
      static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.where.has_value() && !isDeviation(finding.kind);
      }));
  scene.caption =
      fmt::format("{}: {} {}{}", ascii(request_.name), located, located == 1 ? "finding" : "findings",
                  located > markers.size() ? fmt::format(", the first {} shown", markers.size()) : "");
  return add(std::move(scene), request_.views.front(), "findings.png", "findings", progress);
}

}  // namespace proveout
