// The mesh that the program writes, judged by a library that knows nothing of it; and the same mesh for any
// number of threads and any SIMD level.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "io/mesh_io.h"
#include "tests/acceptance/program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Sample {
  std::string name, input;       ///< job or program
  std::string options;           ///< of `proveout run`
  std::vector<double> grids_mm;  ///< on which CGAL judges the mesh
};

constexpr double kCoarseMm = 0.8;  ///< where many runs are compared

/// Names of tests must not hold addresses.
void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

std::vector<Sample> samples() {
  const std::string shared = PROVEOUT_SHARED_PROGRAMS "/", parts = PROVEOUT_SOURCE_DIR "/parts/";
  return {
      {"bear",
       shared + "bear.nc",
       "--control nct --stock box:0,0,-20:80,80,0 --tool 1=ball:3.175",
       {0.25, 0.33, 0.5}},
      {"flower_mold",
       shared + "flower_mold.nc",
       "--control nct --stock box:-3.92956,-3.92829,-9.95121:61.0796,61.0529,0 --tool 1=flat:1",
       {0.25, 0.5}},
      {"circle_diamond",
       shared + "circle_diamond_square.gcode",
       "--control nct --stock box:-60,-60,-10:60,60,0 --tool 1=flat:3",
       {0.5}},
      {"bracket", parts + "bracket/job.toml", "", {0.5}},
      {"circle_diamond_square", parts + "circle_diamond_square/job.toml", "", {0.25, 0.6}},
      {"freeform_patch", parts + "freeform_patch/job.toml", "", {0.5}},
      {"gouged_plate", parts + "gouged_plate/job.toml", "", {0.5}},
      {"macro_plate", parts + "macro_plate/job.toml", "", {0.5}},
      {"polar_boss", parts + "polar_boss/job.toml", "", {0.5}},
      {"two_sides", parts + "two_sides/job.toml", "", {0.5}},
  };
}

class MeshQuality : public testing::TestWithParam<Sample> {
 protected:
  void SetUp() override {
    if (!fs::exists(GetParam().input)) GTEST_SKIP() << GetParam().input << " is not here";
  }
  /// Runs the sample and returns its report; null where the run failed.
  json run(double grid_mm, const std::string& more, const std::string& environment = {}) const {
    const Sample& sample = GetParam();
    const Outcome outcome =
        bench_.run("run '" + sample.input + "' " + sample.options +
                       " --no-render --quiet --out out --resolution " + std::to_string(grid_mm) + " " + more,
                   "env " + environment + " timeout 100");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << more << "\n" << outcome.err;
    return json::parse(readFile(bench_.path("out/report.json")), nullptr, false);
  }
  std::string path(const std::string& file) const { return bench_.path("out/" + file); }

 private:
  Workbench bench_;
};

/// A mesh of CGAL's, or none where it does not take the triangles for a 2-manifold.
std::optional<SurfaceMesh> surfaceMesh(const TriMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const auto& p : mesh.positions) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& t : mesh.triangles) triangles.push_back({t[0], t[1], t[2]});
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles)) return std::nullopt;
  SurfaceMesh out;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, out);
  return out;
}

/// Pairs of triangles that run through each other, and some of the places.
std::size_t selfIntersections(const SurfaceMesh& surface, std::string& places) {
  using Face = SurfaceMesh::Face_index;
  std::vector<std::pair<Face, Face>> pairs;
  pmp::self_intersections(surface, std::back_inserter(pairs));
  for (std::size_t i = 0; i < std::min<std::size_t>(5, pairs.size()); ++i) {
    std::ostringstream place;
    place << surface.point(surface.source(surface.halfedge(pairs[i].first)));
    places += "\n  near " + place.str();
  }
  return pairs.size();
}

TEST_P(MeshQuality, ClosedManifoldWithoutSelfIntersections) {
  for (const double grid_mm : GetParam().grids_mm) {
    SCOPED_TRACE(grid_mm);
    const json report = run(grid_mm, {});
    ASSERT_TRUE(report.is_object());
    EXPECT_TRUE(report["stock"]["closed"].get<bool>());
    for (const json& output : report["outputs"]["meshes"]) {
      const Result<TriMesh> mesh = loadMesh(path(output["path"].get<std::string>()));
      ASSERT_TRUE(mesh.ok()) << mesh.error().message;
      const std::optional<SurfaceMesh> surface = surfaceMesh(*mesh);
      ASSERT_TRUE(surface.has_value());
      EXPECT_TRUE(CGAL::is_closed(*surface));
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(*surface));
      std::string places;
      EXPECT_EQ(selfIntersections(*surface, places), 0u)
          << "of " << mesh->triangles.size() << " triangles" << places;
    }
  }
}

TEST_P(MeshQuality, SameForAnyNumberOfThreads) {
  std::string first;
  for (const char* threads : {"1", "2", "3", "8"}) {
    const json report = run(kCoarseMm, std::string("--threads ") + threads);
    ASSERT_TRUE(report.is_object()) << threads;
    const std::string hash = report["hashes"]["part_sha256"];
    if (first.empty()) first = hash;
    EXPECT_EQ(hash, first) << threads << " threads";
  }
  EXPECT_EQ(first.size(), 64u);
}

/// Names of the SIMD levels that this machine has, for PROVEOUT_SIMD.
std::vector<std::string> simdLevels() {
  std::ifstream info("/proc/cpuinfo");
  const std::string text{std::istreambuf_iterator<char>(info), {}};
  std::vector<std::string> levels = {"baseline"};
  if (has(text, " avx2 ")) levels.push_back("avx2");
  if (has(text, " avx512f ") && has(text, " avx512dq ") && has(text, " avx512vl ") && has(text, " avx512bw "))
    levels.push_back("avx512");
  return levels;
}

TEST_P(MeshQuality, SameForEverySimdLevel) {
  std::string first;
  for (const std::string& level : simdLevels()) {
    const json report = run(kCoarseMm, {}, "PROVEOUT_SIMD=" + level);
    ASSERT_TRUE(report.is_object()) << level;
    const std::string hash = report["hashes"]["part_sha256"];
    if (first.empty()) first = hash;
    EXPECT_EQ(hash, first) << level;
  }
  EXPECT_EQ(first.size(), 64u);
}

INSTANTIATE_TEST_SUITE_P(Samples, MeshQuality, testing::ValuesIn(samples()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace proveout::test
