#include "app/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/freed_pieces.h"
#include "app/page/crest_map.h"
#include "io/png.h"
#include "io/report_text.h"

namespace proveout {
namespace {

/// More numbers than this hide the part; the report lists all of them.
constexpr std::size_t kMaxMarkers = 12;

/// Of a close-up, pixels.
constexpr int kCloseUpWidth = 480, kCloseUpHeight = 320;

/// Captions are ASCII: other bytes become question marks.
std::string ascii(const std::string& text) {
  std::string result = text.substr(0, 60);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
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

std::string deviationViewName(const std::string& view) { return "deviation-" + view; }

/// Annotations need a picture of some size; a thumbnail goes without.
bool PictureMaker::annotated() const { return request_.size.width >= 160 && request_.size.height >= 120; }

/// Errors: interrupted. Others are kept.
Status PictureMaker::add(Result<Image> image, const std::string& file, const std::string& title) {
  Result<std::string> png = image ? encodePng(*image) : image.error();
  if (png) {
    pictures.push_back({file, title, std::move(*png)});
  } else if (png.error().kind == ErrorKind::kInterrupted) {
    return png.error();
  } else {
    failures.push_back({png.error().kind, file + ": " + png.error().message});
  }
  return Done{};
}

RenderOptions PictureMaker::options() const {
  RenderOptions options;
  options.ground = !turned_axis_.has_value();  // turned parts lie on no table
  options.threads = request_.threads;
  return options;
}

Result<View> PictureMaker::prepare(RenderScene& scene, const std::string& view_name) const {
  const bool turned = turned_axis_.has_value();
  Result<View> view = turned ? findTurnedView(view_name) : findView(view_name);
  if (view && view->section && turned) scene.section = SectionCut{*turned_axis_, 1, 1};
  return view;
}

Result<Image> PictureMaker::draw(RenderScene scene, const std::string& view_name, Progress& progress) const {
  const Result<View> view = prepare(scene, view_name);
  if (!view) return view.error();
  return renderMesh(scene, *view, request_.size, options(), progress);
}

Result<Image> PictureMaker::drawBare(const TriMesh& mesh, const std::string& view_name, Progress& progress) {
  RenderScene scene = sceneOf(mesh);
  scene.caption_room = annotated();
  return draw(std::move(scene), view_name, progress);
}

/// Of a scene that differs from the first view's in its annotations alone.
Result<Image> PictureMaker::drawOverFirstView(RenderScene scene, Progress& progress) {
  const std::string& name = request_.views.front();
  Result<Image> image = first_view_ ? std::move(*first_view_) : drawBare(scene.mesh, name, progress);
  first_view_.reset();
  if (!image) return image;
  const Result<View> view = prepare(scene, name);
  if (!view) return view.error();
  if (const Status done = annotate(scene, *view, *image); !done) return done.error();
  return image;
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
    Result<Image> image = drawBare(mesh, view, progress);
    if (image && view == request_.views.front()) first_view_ = *image;
    if (Status done = add(std::move(image), view + ".png", view); !done) return done;
  }
  return Done{};
}

Status PictureMaker::drawApart(const TriMesh& mesh, const std::vector<TriMesh>& freed,
                               const std::vector<StockBody>& bodies, Progress& progress) {
  if (!drawsOf(mesh) || freed.empty()) return Done{};
  const TriMesh apart = takenApart(mesh, freed, bodies);
  return add(draw(RenderScene(apart), request_.views.front(), progress), "apart.png", "bodies apart");
}

Status PictureMaker::drawDeviation(const TriMesh& mesh, const Comparison& comparison,
                                   const std::vector<Finding>& findings, Progress& progress) {
  if (!drawsOf(mesh)) return Done{};
  RenderScene scene = sceneOf(mesh);
  addHeatMap(comparison, scene);
  scene.show_legend = annotated();
  if (annotated()) {
    scene.markers = markersOf(findings, true);
    scene.caption =
        fmt::format("{}: gouge {} mm (allowed {:g}), excess {} mm (allowed {:g})", ascii(request_.name),
                    report_text::figure(comparison.max_gouge_mm), comparison.gouge_tolerance_mm,
                    report_text::figure(comparison.max_excess_mm), comparison.excess_tolerance_mm);
  }
  for (const std::string& view : request_.views) {
    const std::string name = &view == &request_.views.front() ? "deviation" : deviationViewName(view);
    if (Status done = add(draw(scene, view, progress), name + ".png",
                          &view == &request_.views.front() ? "deviation" : "deviation " + view);
        !done)
      return done;
  }
  return Done{};
}

Status PictureMaker::drawScallops(const TriMesh& mesh, const std::vector<CrestSample>& crests,
                                  double allowed_mm, Progress& progress) {
  if (!drawsOf(mesh) || crests.empty()) return Done{};
  double most = 0.0;
  for (const CrestSample& crest : crests) most = std::max(most, crest.height_mm);
  RenderScene scene = sceneOf(mesh);
  scene.field.per = ScalarField::Per::kTriangle;
  scene.field.values = crestHeights(mesh, crests);
  scene.field.scale = deviationScaleFor(allowed_mm, allowed_mm, most);
  scene.show_legend = annotated();
  scene.legend.title = "scallop height";
  if (annotated())
    scene.caption = fmt::format("{}: scallops up to {} mm, {} measured", ascii(request_.name),
                                report_text::figure(most), crests.size());
  return add(draw(std::move(scene), request_.views.front(), progress), "scallops.png", "scallop height");
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
  return add(drawOverFirstView(std::move(scene), progress), "findings.png", "findings");
}

Result<std::string> PictureMaker::drawCloseUp(const TriMesh& mesh, const Comparison* comparison,
                                              const Marker& marker, const Vec3& back, double width_mm,
                                              Progress& progress) {
  RenderScene scene = sceneOf(mesh);
  if (comparison != nullptr) {
    addHeatMap(*comparison, scene);
    scene.show_legend = false;
  }
  scene.markers = {marker};
  scene.focus = RenderScene::Focus{marker.at, width_mm};
  View view{"close-up", back, Vec3::UnitZ(), false};
  const Vec3 hint = std::abs(back.z()) > 0.999 ? Vec3::UnitY() : Vec3::UnitZ();
  view.up = (hint - back * hint.dot(back)).normalized();
  RenderOptions close = options();
  close.ground = false;
  const Result<Image> image = renderMesh(scene, view, {kCloseUpWidth, kCloseUpHeight}, close, progress);
  if (!image)
    return image.error().kind == ErrorKind::kInterrupted ? Result<std::string>(image.error()) : std::string();
  Result<std::string> png = encodePng(*image);
  return png ? std::move(png) : Result<std::string>(std::string());
}

Result<std::vector<FindingDetail>> PictureMaker::drawDetails(const TriMesh& mesh,
                                                             const Comparison* comparison,
                                                             const std::vector<Finding>& findings,
                                                             const RunResult* run, const RunSources* sources,
                                                             Progress& progress) {
  if (!drawsOf(mesh) || !annotated()) return std::vector<FindingDetail>{};
  const auto draw = [&](std::size_t number, const Finding& finding, const Vec3& back, double width_mm) {
    const Marker marker{*finding.where, fmt::format("{}", number), finding.severity};
    return drawCloseUp(mesh, isDeviation(finding.kind) ? comparison : nullptr, marker, back, width_mm,
                       progress);
  };
  return findingDetails(draw, mesh, findings, run, sources);
}

}  // namespace proveout
