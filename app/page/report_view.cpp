#include "app/page/report_view.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "app/page/measured_surface.h"
#include "app/page/reduced_mesh.h"
#include "app/page/view_path.h"
#include "core/base/installed_file.h"
#include "io/report_text.h"
#include "render/color_map.h"

namespace proveout {

namespace {

// Sizes for which the page stays below some 6 MB: a triangle takes about 6 bytes of it, a point 8.
constexpr std::size_t kMostPart = 160'000, kMostColoured = 200'000, kMostNominal = 160'000,
                      kMostPoints = 150'000;
/// As many as report.html has rows.
constexpr std::size_t kMostFindings = 500;

/// What the program carries for it; empty: it was built without.
std::string viewScript() {
  for (const std::string& path : installedFiles("report_view.js")) {
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!text.empty()) return text;
  }
  return {};
}

ViewScale scaleOf(const Comparison& comparison) {
  const DeviationScale scale =
      deviationScaleFor(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm,
                        std::max(comparison.max_gouge_mm, comparison.max_excess_mm));
  ViewScale out;
  const auto add = [&](double at, double coloured_as) {
    out.stops.push_back({at, deviationColor(scale, coloured_as)});
  };
  const double little = 1e-9 * scale.limit, half = 0.5 * scale.limit;
  add(-scale.limit, -scale.limit);
  add(-half - 0.5 * scale.gouge, -half - 0.5 * scale.gouge);
  add(-scale.gouge, -scale.gouge - little);
  add(-scale.gouge, 0.0);
  add(scale.excess, 0.0);
  add(scale.excess, scale.excess + little);
  add(half + 0.5 * scale.excess, half + 0.5 * scale.excess);
  add(scale.limit, scale.limit);
  out.ticks_mm = {-scale.limit, scale.limit, -scale.gouge, scale.excess, 0.0, -half, half};
  return out;
}

ViewMesh coloured(const ViewInput& input, const Progress& progress) {
  ViewMesh view = reducedMesh(input.part, kMostPart, progress);
  const Comparison* c = input.comparison;
  if (c == nullptr || !c->field) return view;
  if (view.off_mm == 0.0) view.deviation_mm = c->vertex_deviation;  // its vertices are the part's
  addDeviations([&](const Vec3& p) { return c->field->at(p); }, shownDeviation(*c), kMostColoured, view);
  return view;
}

ViewScene sceneOf(const ViewInput& input, const Progress& progress) {
  ViewScene scene;
  scene.part = coloured(input, progress);
  if (input.nominal != nullptr && !input.nominal->triangles.empty())
    scene.nominal = reducedMesh(*input.nominal, kMostNominal, progress);
  if (!scene.part.deviation_mm.empty())
    scene.scale = input.bands.empty() ? scaleOf(*input.comparison) : scaleOf(input.bands);
  for (std::size_t i = 0; i < std::min(kMostFindings, input.findings.size()); ++i) {
    const Finding& f = input.findings[i];
    if (!f.where || !f.where->allFinite()) continue;
    scene.findings.push_back({i + 1, report_text::spoken(f.kind), f.known ? Severity::kNote : f.severity,
                              *f.where, f.area_mm2 ? std::sqrt(std::max(0.0, *f.area_mm2)) : 0.0});
  }
  return scene;
}

}  // namespace

double shownDeviation(const Comparison& comparison) {
  return std::max(1e-4, 0.5 * std::min(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm));
}

ReportView viewOfRun(const RunResult& run, const RunSources& sources, const ViewInput& input,
                     const Progress& progress) {
  ReportView view{viewScript(), {}, true};
  if (view.script.empty() || input.part.triangles.empty()) return view;
  ViewScene scene = sceneOf(input, progress);
  PathOfRun path(run, sources, kMostPoints);
  for (ViewFinding& finding : scene.findings)
    finding.block = path.blockOf(input.findings[finding.number - 1]);
  scene.path = path.take();
  view.data = encodeView(scene);
  return view;
}

ReportView viewOfMeshes(const ViewInput& input, const Progress& progress) {
  ReportView view{viewScript(), {}, true};
  if (!view.script.empty() && !input.part.triangles.empty()) view.data = encodeView(sceneOf(input, progress));
  return view;
}

}  // namespace proveout
