#include "tests/unit/removal/cut_fixture.h"

#include <Eigen/Geometry>

namespace proveout::test {

PathMaker& PathMaker::arc(const Vec3& from, const Vec3& center, const Vec3& normal, double sweep_deg,
                          double rise) {
  ArcGeometry arc;
  arc.normal = normal.normalized();
  arc.center = center + arc.normal * arc.normal.dot(from - center);
  arc.sweep_rad = degToRad(sweep_deg);
  const Vec3 end =
      arc.center + Eigen::AngleAxisd(arc.sweep_rad, arc.normal) * (from - arc.center) + arc.normal * rise;
  Motion m = motion(from, end, MotionKind::kFeed);
  m.arc = static_cast<std::int32_t>(path_.arcs.size());
  path_.arcs.push_back(arc);
  path_.motions.push_back(m);
  return *this;
}

Cut cut(const StockShape& shape, const Toolpath& path, const std::vector<Tool>& tools, double resolution,
        int threads) {
  Cut out;
  RemovalOptions options;
  options.resolution_mm = resolution;
  options.threads = threads;
  Progress progress;
  auto stock = Stock::create(shape, options, progress);
  EXPECT_TRUE(stock.ok()) << stock.error().message;
  if (!stock) return out;
  auto summary = stock->remove(path, tools, options, progress);
  EXPECT_TRUE(summary.ok()) << summary.error().message;
  if (!summary) return out;
  SurfaceOptions fine;
  fine.simplify_mm = 0.0;
  fine.threads = threads;
  auto surface = stock->surface(fine, progress);
  EXPECT_TRUE(surface.ok()) << surface.error().message;
  if (!surface) return out;
  out.initial = stock->initialVolume();
  out.volume = surface->volume_mm3;
  out.thin_cells = surface->thin_cells;
  out.mesh = std::move(surface->mesh);
  out.mesh_volume = meshVolume(out.mesh);
  out.summary = std::move(*summary);
  const MeshTopology topology = analyseTopology(out.mesh);
  EXPECT_TRUE(topology.closedManifold())
      << "open " << topology.boundary_edges << " non-manifold " << topology.non_manifold_edges
      << " misoriented " << topology.misoriented_edges << " vertices " << topology.non_manifold_vertices
      << " degenerate " << topology.degenerate_triangles;
  return out;
}

Tool tool(const std::string& option) {
  auto parsed = parseToolOption(option);
  EXPECT_TRUE(parsed.ok());
  return parsed.value();
}

}  // namespace proveout::test
