// What the engine cuts: its volume against booleans by CGAL of tessellated swept solids, its vertices against
// distances to what is swept. Random small programs of lines and arcs. A few of them here;
// PROVEOUT_REFERENCE_PROGRAMS=N judges N, PROVEOUT_REFERENCE_FIRST=SEED from this one on,
// PROVEOUT_REFERENCE_FACETS=N with as many facets around a tool.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/reference/reference_cut.h"
#include "tests/support/feed_motion.h"

namespace proveout::reference {
namespace {

constexpr double kGrid = 0.25;
/// What the engine aims at: of the removed volume, of vertices on faces, of edges. Programs that tell of thin
/// walls need not keep the last two: so many of a hundred must, and these bounds all. All of the first 200 do
/// (docs/decisions/034-truth-by-another-library.md).
constexpr double kVolume = 1e-5, kFaceMm = 2e-3, kEdgeMm = 1e-2;
constexpr int kOfHundred = 99;
constexpr double kMostFaceMm = 3e-3, kMostEdgeMm = 0.02;
/// Beside walls and gaps that are thin in truth may be so many of a hundred of what is compared.
constexpr int kBesideThin = 2;
/// Less is removed by programs that pass the block, mm3.
constexpr double kNothing = 1e-5;
constexpr int kPrograms = 50, kFacets = 48;

int fromEnvironment(const char* variable, int usual) {
  const char* const text = getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

/// The reference itself, where there is a formula.
void expectHolds(const Tool& tool, const Toolpath& path, double exact) {
  SmallProgram program;
  program.block = {{0, 0, -8}, {24, 18, 0}};
  program.tools = {tool};
  program.path = path;
  const auto coarse = removedByReference(program, 48), fine = removedByReference(program, 96);
  ASSERT_TRUE(coarse && fine);
  std::printf("%s: %.1e, %.1e\n", std::string(toolTypeName(tool.type)).c_str(), *coarse / exact - 1.0,
              *fine / exact - 1.0);
  EXPECT_LT(std::abs(*coarse / exact - 1.0), 3e-6);
  EXPECT_LT(std::abs(*fine / exact - 1.0), 1e-6);
}

TEST(ReferencePart, HoldsAFlatSlot) {
  Tool tool;
  tool.diameter = 6.0;
  Toolpath path;
  path.motions = {test::feedMotion({6, 7, -2.5}, {17, 11, -2.5})};
  expectHolds(tool, path, (kPi * 9.0 + 6.0 * std::hypot(11.0, 4.0)) * 2.5);
}

TEST(ReferencePart, HoldsABallOnAnArc) {
  Tool tool;
  tool.type = ToolType::kBall;
  tool.diameter = 5.0;
  Toolpath path;
  path.motions = {test::feedMotion({16, 9, -3.1}, {8, 9, -3.1})};
  path.motions[0].arc = 0;
  path.arcs = {{{12, 9, -3.1}, Vec3::UnitZ(), 0.55 * kPi}};
  const double r = 2.5, section = kPi * r * r / 2 + 2 * r * 0.6;  // of the groove
  const double ends = 2.0 / 3.0 * kPi * r * r * r + kPi * r * r * 0.6;
  expectHolds(tool, path, section * 4.0 * 0.55 * kPi + ends);
}

void print(int seed, const SmallProgram& program, const Comparison& c) {
  std::printf(
      "seed %d (%s): %.3f mm3, %+.1e (reference of %d facets %.0e, told %.0e); %s; thin %zu, film %.2f, "
      "beside thin walls %zu, crowded %zu of %zu\n",
      seed, std::string(toolTypeName(program.tools[0].type)).c_str(), c.removed_mm3, c.more, c.facets,
      c.unsure, c.told, c.places.c_str(), c.thin_cells, c.film_mm2, c.beside_thin, c.crowded,
      c.crowded + c.vertices);
  std::fflush(stdout);
}

bool keeps(const Comparison& c, double volume, double face_mm, double edge_mm) {
  return std::abs(c.more) <= volume + c.told + c.unsure && c.face_mm <= face_mm && c.edge_mm <= edge_mm &&
         c.missed_mm <= edge_mm;
}

TEST(Reference, SmallProgramsAreCutAlike) {
  const int first = fromEnvironment("PROVEOUT_REFERENCE_FIRST", 1),
            count = fromEnvironment("PROVEOUT_REFERENCE_PROGRAMS", kPrograms),
            facets = fromEnvironment("PROVEOUT_REFERENCE_FACETS", kFacets);
  int judged = 0, kept = 0;
  for (int seed = first; seed < first + count; ++seed) {
    const SmallProgram program = smallProgram(static_cast<std::uint64_t>(seed));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + describe(program));
    const auto c = compareWithReference(program, kGrid, facets, kVolume);
    if (!c || c->removed_mm3 < kNothing) {
      std::printf("seed %d: %s\n", seed, c ? "nothing is removed" : "no reference");
      continue;
    }
    ++judged;
    print(seed, program, *c);
    EXPECT_GT(c->vertices, 10000u);
    EXPECT_LE(100 * c->beside_thin, kBesideThin * c->vertices);
    EXPECT_TRUE(keeps(*c, kVolume, kMostFaceMm, kMostEdgeMm));
    const bool all = keeps(*c, kVolume, kFaceMm, kEdgeMm);
    EXPECT_TRUE(all || c->thin_cells > 0 || c->film_mm2 > 0.0);
    if (!all) std::printf("  beyond the aim\n");
    kept += all ? 1 : 0;
  }
  std::printf("%d of %d keep 1e-5, 2 and 10 micrometres\n", kept, judged);
  EXPECT_GE(judged, count * 8 / 10);
  EXPECT_GE(100 * kept, kOfHundred * judged);
}

/// Programs that did not keep it once: for an edge between faces that nearly go over into each other (240),
/// one where a flat end's corner leaves the block between two samples (257), a vertex that had to stay in its
/// cell beside another on the same edge (294), the bottom of a groove (314), a ridge between the start of an
/// arc's cone and its end (354), the tip where two grooves of a drill meet (474), and a sliver at the block's
/// side that is taken without a crossing (41).
TEST(Reference, EdgesThatFewCrossingsShowAreMet) {
  for (const std::uint64_t seed : {41, 240, 257, 294, 314, 354, 474}) {
    const SmallProgram program = smallProgram(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + describe(program));
    const auto c = compareWithReference(program, kGrid, kFacets, kVolume);
    ASSERT_TRUE(c);
    EXPECT_TRUE(keeps(*c, kVolume, kFaceMm, kEdgeMm)) << c->places;
  }
}

}  // namespace
}  // namespace proveout::reference
