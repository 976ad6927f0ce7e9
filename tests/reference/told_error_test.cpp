// What the engine tells of its own errors against what they are: facets and volumes of random programs with
// ramps, plunges and tools that are small for the grid. The generator is this file's own. A few programs
// here; PROVEOUT_TOLD_PROGRAMS=N judges N, PROVEOUT_TOLD_FIRST=SEED from this one on, PROVEOUT_TOLD_PRINT=1
// prints each.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "removal/grid/stock.h"
#include "tests/reference/small_program.h"
#include "tests/reference/swept_distance.h"
#include "tests/soak/soak_case.h"
#include "tests/support/feed_motion.h"

namespace proveout::reference {
namespace {

constexpr double kGrid = 0.25;
/// What is told holds in so many of a thousand programs, and is so many times the truth in the median at
/// most.
constexpr int kOfThousand = 995;
constexpr double kMostTimes = 30.0;
/// Errors below this are none: mm, and of the removed volume.
constexpr double kNoneMm = 5e-4, kNoneShare = 1e-6;
/// The volume is taken for true on a grid so many times as fine.
constexpr double kFiner = 4.0;
constexpr int kPrograms = 40;

int fromEnvironment(const char* variable, int usual) {
  const char* const text = getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

Tool toolOf(soak::Random& random, int kind) {
  Tool tool;
  tool.number = 1;
  tool.diameter = random.number(1.5, 6.0);
  switch (kind) {
    case 0:
      break;  // flat
    case 1:
      tool.type = ToolType::kBall;
      break;
    case 2:
      tool.type = ToolType::kBull;
      tool.corner_radius = random.number(0.1, 0.45) * tool.diameter;
      break;
    case 3:
      tool.type = ToolType::kDrill;
      tool.point_angle_deg = random.number(90, 140);
      break;
    case 4:
      tool.type = ToolType::kCone;
      tool.tip_diameter = random.number(0.05, 0.4) * tool.diameter;
      tool.cone_angle_deg = random.number(30, 100);
      break;
    default:
      tool.type = ToolType::kTaperBall;
      tool.tip_diameter = random.number(0.3, 0.7) * tool.diameter;
      tool.cone_angle_deg = random.number(8, 40);
  }
  return tool;
}

SmallProgram programOf(std::uint64_t seed) {
  soak::Random random(seed ^ 0x54AF00D5ull);
  SmallProgram out;
  out.block = {{0, 0, -6}, {random.number(10, 14), random.number(8, 11), 0}};
  out.tools = {toolOf(random, static_cast<int>(seed % 6))};
  out.path.files = {"told"};
  Vec3 at(random.number(2, 8), random.number(2, 7), 3.0);
  const auto go = [&](const Vec3& to) {
    if ((to - at).norm() < 1e-3) return;
    Motion motion = test::feedMotion(at, to);
    motion.tool = 1;
    motion.source.line = static_cast<int>(out.path.motions.size()) + 1;
    out.path.motions.push_back(motion);
    at = to;
  };
  go({at.x(), at.y(), -random.number(0.2, 2.0)});
  const int motions = random.whole(1, 4);
  for (int i = 0; i < motions; ++i) {
    const Vec3 to(random.number(1, 11), random.number(1, 8), -random.number(0.2, 2.5));
    const int style = random.whole(0, 3);
    if (style == 0) go({to.x(), to.y(), at.z()});
    if (style == 1) go(to);
    if (style == 2) go({at.x(), at.y(), to.z()});
    if (style == 3) go({to.x(), at.y(), at.z() - random.number(0.0, 0.4)});
  }
  return out;
}

struct Cut {
  StockSurface surface;
  double removed_mm3 = 0.0, told_mm3 = 0.0;
};

std::optional<Cut> cut(const SmallProgram& program, double grid_mm) {
  RemovalOptions options;
  options.resolution_mm = grid_mm;
  Progress progress;
  auto stock = Stock::create(program.block, options, progress);
  if (!stock) return std::nullopt;
  SurfaceOptions all;
  all.simplify_mm = 0.0;
  const auto before = stock->volume(all, progress);
  const auto removal = stock->remove(program.path, program.tools, options, progress);
  auto surface = stock->surface(all, progress);
  if (!before || !removal || !surface) return std::nullopt;
  const double removed_mm3 = before->mm3 - surface->volume_mm3 - surface->unseen_mm3;
  const double told_mm3 = surface->volume_error_mm3 + removal->lost_mm3;
  return Cut{std::move(*surface), removed_mm3, told_mm3};
}

struct Off {
  double mm = 0.0;
  Vec3 where = Vec3::Zero();
};

/// The farthest of corners, middles of edges and middles of all facets.
Off farthestFacet(const TriMesh& mesh, const ExactPart& part) {
  Off out;
  const auto see = [&](const Vec3& p) {
    const double off = part.off(p);
    if (off > out.mm) out = {off, p};
  };
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.positions[t[i]].cast<double>();
    for (std::size_t i = 0; i < 3; ++i) {
      see(p[i]);
      see(0.5 * (p[i] + p[(i + 1) % 3]));
    }
    see((p[0] + p[1] + p[2]) / 3.0);
  }
  return out;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

TEST(ToldError, BoundsFacetsAndVolumes) {
  const int first = fromEnvironment("PROVEOUT_TOLD_FIRST", 1),
            count = fromEnvironment("PROVEOUT_TOLD_PROGRAMS", kPrograms);
  const bool print = fromEnvironment("PROVEOUT_TOLD_PRINT", 0) != 0;
  int judged = 0, facets_held = 0, volumes_held = 0, thin = 0;
  std::vector<double> facet_times, volume_times;
  for (int seed = first; seed < first + count; ++seed) {
    const SmallProgram program = programOf(static_cast<std::uint64_t>(seed));
    const auto coarse = cut(program, kGrid), fine = cut(program, kGrid / kFiner);
    if (!coarse || !fine || fine->removed_mm3 < 1e-3) continue;
    ++judged;
    const Off off = farthestFacet(coarse->surface.mesh, ExactPart(program));
    const FacetError told = coarse->surface.facets;
    const double more = std::abs(coarse->removed_mm3 - fine->removed_mm3);
    const bool facets = off.mm <= told.mm + kNoneMm,
               volume = more <= coarse->told_mm3 + fine->told_mm3 + kNoneShare * fine->removed_mm3;
    facets_held += facets ? 1 : 0;
    volumes_held += volume ? 1 : 0;
    thin += coarse->surface.thin_cells > 0 ? 1 : 0;
    if (off.mm > kNoneMm) facet_times.push_back(told.mm / off.mm);
    if (more > kNoneShare * fine->removed_mm3) volume_times.push_back(coarse->told_mm3 / more);
    if (print || !facets || !volume) {
      std::printf(
          "seed %d %s %zu motions: facet %.4f at %.3f %.3f %.3f, told %.4f at %.3f %.3f %.3f%s; volume off "
          "%.2e "
          "told %.2e of %.3f%s; thin %zu\n",
          seed, std::string(toolTypeName(program.tools[0].type)).c_str(), program.path.motions.size(), off.mm,
          off.where.x(), off.where.y(), off.where.z(), told.mm, told.where.x(), told.where.y(),
          told.where.z(), facets ? "" : " SHORT", more, coarse->told_mm3, fine->removed_mm3,
          volume ? "" : " SHORT", coarse->surface.thin_cells);
      std::fflush(stdout);
    }
  }
  std::printf(
      "%d programs: facets told in %d, %.1f times the truth in the median; volumes in %d, %.1f times; thin "
      "told in "
      "%d\n",
      judged, facets_held, median(facet_times), volumes_held, median(volume_times), thin);
  EXPECT_GE(judged, count * 8 / 10);
  EXPECT_GE(1000 * facets_held, kOfThousand * judged);
  EXPECT_GE(1000 * volumes_held, kOfThousand * judged);
  EXPECT_LE(median(facet_times), kMostTimes);
  EXPECT_LE(median(volume_times), kMostTimes);
}

}  // namespace
}  // namespace proveout::reference
