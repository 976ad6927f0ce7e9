// Programs of the nct control on the machines of parts/machines, run as a user runs them: what the part is
// then.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/geometry/types.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "io/mesh_io.h"
#include "program_runner.h"

namespace proveout::test {

/// A job but for its machine, in the sections of its file. One tool, of number 1 and the length kGauge.
struct FiveAxisJob {
  static constexpr double kGauge = 80.0;
  std::string stock;       ///< keys of [stock]
  std::string tool;        ///< keys of [[tool]] beside its number and length
  std::string more = {};   ///< tables of the file
  std::string blank = {};  ///< a mesh for `stock`, as blank.obj
  double resolution = 0.5;
  std::string machine = {};  ///< text of a machine file of its own, in place of one of parts/machines
};

/// Machine files, and where the part lies on them: on tables in the middle, some way above.
struct PlacedMachine {
  const char* file;
  Vec3 zero;
};
inline constexpr std::size_t kMachines = 5;
inline const PlacedMachine& placedMachine(std::size_t index) {
  static const PlacedMachine machines[kMachines] = {{"trunnion_ac.toml", {400, 300, -430}},
                                                    {"trunnion_bc.toml", {405, 297, -430}},
                                                    {"head_cb.toml", {0, 0, 0}},
                                                    {"head_b_table_c.toml", {410, 305, -430}},
                                                    {"inclined_bc.toml", {400, 300, -430}}};
  return machines[index];
}

struct MachinedPart {
  int exit_code = -1;
  std::string said;
  nlohmann::json report;
  TriMesh mesh;
  double volume = 0.0;
};

inline MachinedPart machined(const FiveAxisJob& job, const std::string& machine, const Vec3& zero,
                             const std::string& program) {
  const Workbench bench;
  const auto number = [](double value) { return std::to_string(value); };
  bench.write("part.nc", program);
  if (!job.blank.empty()) bench.write("blank.obj", job.blank);
  if (!job.machine.empty()) bench.write("machine.toml", job.machine);
  const std::string file =
      job.machine.empty() ? std::string(PROVEOUT_SOURCE_DIR) + "/parts/machines/" + machine : "machine.toml";
  bench.write("job.toml",
              "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"part.nc\"\n" + job.more +
                  "[machine]\nfile = \"" + file + "\"\n[stock]\n" + job.stock + "\n[[tool]]\nnumber = 1\n" +
                  job.tool + "\ngauge_length = " + number(FiveAxisJob::kGauge) + "\n[offsets.work]\nG54 = [" +
                  number(zero.x()) + ", " + number(zero.y()) + ", " + number(zero.z()) +
                  "]\n[offsets.length]\n1 = " + number(FiveAxisJob::kGauge) +
                  "\n[simulation]\nsimplify = 0\nresolution = " + number(job.resolution) + "\n");
  const Outcome outcome = bench.run("run job.toml --no-render --out out");
  MachinedPart part;
  part.exit_code = outcome.exit_code;
  part.said = outcome.err;
  if (!bench.exists("out/report.json")) return part;
  part.report = nlohmann::json::parse(readFile(bench.path("out/report.json")));
  part.volume = part.report["stock"]["final_mm3"].get<double>();
  for (const std::string& name : bench.files("out")) {
    if (!name.ends_with(".stl")) continue;
    Result<TriMesh> mesh = loadMesh(bench.path("out/" + name));
    EXPECT_TRUE(mesh.ok());
    if (mesh) part.mesh = std::move(*mesh);
  }
  EXPECT_GT(part.mesh.positions.size(), 100u) << part.said;
  return part;
}
inline MachinedPart machined(const FiveAxisJob& job, std::size_t machine, const std::string& program) {
  const PlacedMachine& on = placedMachine(machine);
  return machined(job, on.file, on.zero, program);
}

/// The largest distance of a mesh's vertices from another mesh, mm.
inline double verticesFrom(const TriMesh& from, const TriMesh& to) {
  const TriangleTree tree(toSurface(to));
  double most = 0.0;
  for (const auto& p : from.positions) most = std::max(most, tree.nearest(p.cast<double>()).squared);
  return std::sqrt(most);
}

/// Of a box, mm; below 0 inside.
inline double fromBox(const Vec3& low, const Vec3& high, const Vec3& p) {
  const Vec3 d = (low - p).cwiseMax(p - high);
  return d.cwiseMax(0.0).norm() + std::min(0.0, d.maxCoeff());
}

}  // namespace proveout::test
