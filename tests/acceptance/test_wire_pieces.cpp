// Pieces that a wire cuts free, and what hangs on: of whole jobs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

json report(const Workbench& bench, const std::string& stock, const std::string& program,
            const std::string& heights) {
  bench.write("p.nc", program);
  bench.write("job.toml",
              "schema = \"proveout.job/1\"\nname = \"j\"\nprogram = \"p.nc\"\n[control]\nname = "
              "\"wedm\"\n[control.wedm]\n" +
                  heights + "[stock]\n" + stock +
                  "[[tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.2\nspark_gap = 0.01\n");
  const Outcome outcome = bench.run("run job.toml --no-render --json --out out");
  EXPECT_LT(outcome.exit_code, 2) << outcome.err;
  return json::parse(outcome.out, nullptr, false);
}

double volumeOf(const json& bodies) {
  double sum = 0.0;
  for (const json& body : bodies) sum += body["volume_mm3"].get<double>();
  return sum;
}

/// A contour that is cut twice, leaning outwards and then inwards: the slug cannot fall when it comes free,
/// stays, and is cut in two.
TEST(WirePieces, AStuckSlugIsCutAgainAndCountedOnce) {
  const Workbench bench;
  const std::string contour =
      " G01 X14.370 Y16.410;\nG01 X10.524 Y16.654;\nG01 X13.630 Y7.708 R0.484;\nG01 X18.218 Y16.164;\n"
      "G01 X14.370 Y16.410;\nG40 G50 A0 G01 X14.862 Y17.932;\n";
  const json made = report(bench, "shape = \"box\"\nmin = [0, -5, -2.308]\nmax = [26.4, 18.272, 5.976]\n",
                           "H001=0.110;\nH002=0.160;\nG90 G92 X14.862 Y17.932;\nG42 H002 G52 A0.900" +
                               contour + "G42 H001 G51 A0.900" + contour + "M02;\n",
                           "ZB = -2.308\nT = 8.284\n");
  const double removed = made["stock"]["removed_mm3"].get<double>(),
               left = made["stock"]["final_mm3"].get<double>();
  // Two kerfs of 0.22 mm along 38 mm that cross half way up, at most.
  EXPECT_GT(removed, 0.22 * 36.0 * 8.0);
  EXPECT_LT(removed, 2.2 * 0.22 * 38.0 * 8.284);
  EXPECT_NEAR(volumeOf(made["stock"]["bodies"]), left, 1e-6 * left);
  int stuck = 0;
  for (const json& finding : made["findings"]) stuck += finding["kind"] == "stuck_slug" ? 1 : 0;
  EXPECT_GE(stuck, 1);
}

/// The motions of a leaning wire in a tube, whose ways are cut into pieces shorter than the kerf is wide.
TEST(WirePieces, MotionsOfALeaningWireRemoveWhatIsRemoved) {
  const Workbench bench;
  const json made = report(
      bench,
      "shape = \"tube\"\nbase = [8.59, 6.962, -4.278]\naxis = \"z\"\nlength = 4.478\nradius = "
      "7.558\ninner_radius = 2.988\n",
      "H002=0.160;\nG90 G92 X18.658 Y7.150;\nG42 H002 G52 A1.850 G01 X16.658 Y7.150;\n"
      "G03 X12.658 Y11.150 I-4.000 J0.000;\nG03 X8.658 Y7.150 I0.000 J-4.000;\nG03 X12.658 Y3.150 I4.000 "
      "J0.000;\nG03 X16.658 Y7.150 I0.000 J4.000;\nG40 G50 A0 G01 X18.658 Y7.150;\nM02;\n",
      "ZB = -4.278\nT = 4.478\n");
  const double removed = made["stock"]["removed_mm3"].get<double>();
  EXPECT_GT(removed, 10.0);
  EXPECT_NEAR(made["accounting"]["total"]["removed_mm3"].get<double>(), removed, 1e-4 * removed);
}

/// The wire stops 1.6 mm below the side of the block, between two pieces.
TEST(WirePieces, ABridgeIsFoundHoweverTheBlockLies) {
  const Workbench bench;
  const json upright =
      report(bench, "shape = \"box\"\nmin = [9.6, 5.916, -2.084]\nmax = [19.094, 13.734, 0]\n",
             "G90 G92 X8.600 Y8.216;\nG01 X15.664 Y10.248;\nG01 X12.138 Y12.024;\nM02;\n",
             "ZB = -2.084\nT = 2.084\n");
  const json turned =
      report(bench, "shape = \"box\"\nmin = [5.916, -19.094, -2.084]\nmax = [13.734, -9.6, 0]\n",
             "G90 G92 X8.216 Y-8.600;\nG01 X10.248 Y-15.664;\nG01 X12.024 Y-12.138;\nM02;\n",
             "ZB = -2.084\nT = 2.084\n");
  for (const json* made : {&upright, &turned}) {
    const auto is = [](const json& f) { return f["kind"] == "bridge"; };
    const auto found = std::ranges::find_if((*made)["findings"], is);
    ASSERT_NE(found, (*made)["findings"].end()) << (made == &turned);
  }
}

/// A punch of 20 x 12 mm out of a plate.
const char* const kPunch =
    "H001=110;\nT84T86;C001;\nG92X-18.Y0;\nG41H001G01X-10.;\nY6.;\nX10.;\nY-6.;\nX-10.;\nY0;\nG40X-18.;\nM02;"
    "\n";

/// Runs the punch and returns what is said of the part.
std::string partLine(const Workbench& bench, const std::string& stock, const std::string& options,
                     int exit_code) {
  bench.write("p.nc", kPunch);
  bench.write(
      "job.toml",
      "schema = \"proveout.job/1\"\nname = \"j\"\nprogram = \"p.nc\"\ncontrol = \"wedm\"\n[stock]\nshape = "
      "\"box\"\nmin = [-15, -12, 0]\nmax = [15, 12, 20]\n" +
          stock + "[[tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.2\nspark_gap = 0.01\n");
  const Outcome outcome = bench.run("run job.toml --no-render --out out" + options);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  const std::size_t at = outcome.out.find("  part ");
  return at == std::string::npos ? outcome.err : outcome.out.substr(at, outcome.out.find('\n', at) - at);
}

/// Triangles of a binary STL file.
std::uint32_t trianglesIn(const Workbench& bench, const std::string& file) {
  const std::string bytes = readFile(bench.path(file));
  std::uint32_t count = 0;
  if (bytes.size() > 84) std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

TEST(WirePieces, APointInThePartSaysWhatIsWritten) {
  const Workbench punch, frame;
  const std::string of_punch = partLine(punch, "part_point = [0, 0, 10]\n", "", 0);
  EXPECT_NE(of_punch.find("4800.00 mm3"), std::string::npos) << of_punch;
  EXPECT_NE(of_punch.find(fmt::format("; mesh {} triangles", trianglesIn(punch, "out/j.stl"))),
            std::string::npos)
      << of_punch;
  EXPECT_GT(trianglesIn(punch, "out/slugs/1-j.stl"), trianglesIn(punch, "out/j.stl")) << "the frame";
  const std::string of_frame = partLine(frame, "part_point = [14, 0, 10]\n", "", 0);
  EXPECT_NE(of_frame.find("9294.33 mm3"), std::string::npos) << of_frame;
  EXPECT_EQ(trianglesIn(frame, "out/j.stl"), trianglesIn(punch, "out/slugs/1-j.stl"));
  EXPECT_EQ(trianglesIn(frame, "out/slugs/1-j.stl"), trianglesIn(punch, "out/j.stl"));
}

TEST(WirePieces, EachBodyIsWrittenOnceWhereBodiesAreAskedFor) {
  const Workbench all, each, point;
  const std::string both = partLine(all, "", "", 0);
  EXPECT_NE(both.find(fmt::format("; mesh of all 2 pieces {} triangles", trianglesIn(all, "out/j.stl"))),
            std::string::npos)
      << both;
  EXPECT_FALSE(all.exists("out/slugs"));
  partLine(each, "", " --bodies", 0);
  EXPECT_EQ(trianglesIn(each, "out/j.stl") + trianglesIn(each, "out/slugs/1-j.stl"),
            trianglesIn(all, "out/j.stl"));
  partLine(point, "part_point = [0, 0, 10]\n", " --bodies", 0);
  EXPECT_EQ(trianglesIn(point, "out/j.stl"), trianglesIn(each, "out/slugs/1-j.stl")) << "the punch";
}

TEST(WirePieces, APointInNoBodyIsRefused) {
  const Workbench bench;
  const std::string said = partLine(bench, "part_point = [-10.1, 0, 10]\n", "", 2);
  EXPECT_NE(said.find("lies in no body that is left"), std::string::npos) << said;
  EXPECT_FALSE(bench.exists("out/j.stl"));
}

}  // namespace
}  // namespace proveout::test
