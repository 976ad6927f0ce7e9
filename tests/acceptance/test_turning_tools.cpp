// What tools leave whose axis turns, or under which a table turns, from program to mesh: closed forms.
// Rows: nct-25.15-G53.6 nct-25.16-G43.5P1 nct-25.16-ARC
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "five_axis_jobs.h"
#include "tests/support/golden_section.h"

namespace proveout::test {
namespace turning_tools {
namespace {

constexpr double kMicron = 1e-3;
const char* const kStart = "G17 G21 G90 G54\nT1 M6\nS4000 M3\n";

/// Distances from the surfaces that bound a form, mm.
using Surfaces = std::function<std::vector<double>(const Vec3&)>;

/// Vertices lie on the nearest surface, to a micrometre. Where two of them are within a cell the edge may be
/// sharp and end there: of such vertices one in a thousand may be off by more.
void expectForm(const char* what, const FiveAxisJob& job, const MachinedPart& part, double exact,
                const Surfaces& surfaces) {
  ASSERT_EQ(part.exit_code, 0) << part.said;
  ASSERT_GT(part.mesh.positions.size(), 5000u);
  double most = 0.0, at_edges = 0.0;
  std::size_t off_edges = 0;
  for (const auto& p : part.mesh.positions) {
    std::vector<double> off = surfaces(p.cast<double>());
    for (double& d : off) d = std::abs(d);
    std::partial_sort(off.begin(), off.begin() + 2, off.end());
    const bool edge = off[1] < std::sqrt(3.0) * job.resolution;
    (edge ? at_edges : most) = std::max(edge ? at_edges : most, off[0]);
    off_edges += edge && off[0] > kMicron ? 1 : 0;
  }
  std::printf(
      "%s: %zu vertices off faces by %.3g mm, in cells with edges by %.3g, %zu of them off; volume off "
      "by %.3g\n",
      what, part.mesh.positions.size(), most, at_edges, off_edges, part.volume / exact - 1.0);
  EXPECT_LE(most, kMicron);
  EXPECT_LE(off_edges, part.mesh.positions.size() / 1000);
  EXPECT_LE(at_edges, job.resolution);
  EXPECT_NEAR(part.volume, exact, 1e-5 * exact);
}
/// Faces of a box, as far as it goes.
std::vector<double> facesOf(const Vec3& low, const Vec3& high, const Vec3& p) {
  return {p.x() - low.x(),  p.y() - low.y(),  p.z() - low.z(),
          p.x() - high.x(), p.y() - high.y(), p.z() - high.z()};
}

/// A dividing head about X that turns as far as it likes.
const char* const kHead =
    "schema = \"proveout.machine/1\"\n[[axis]]\nname = \"X\"\n[[axis]]\nname = \"Y\"\non = \"X\"\n[[axis]]\n"
    "name = \"Z\"\non = \"Y\"\n[[axis]]\nname = \"A\"\ncarries = \"part\"\ndirection = [1, 0, 0]\n"
    "point = [0, 200, -300]\nsense = \"left\"\n[spindle]\non = \"Z\"\n";

/// X and A go together: the middle of a ball end goes along a helix.
TEST(TurningTools, ABallCutsAHelicalGroove) {
  constexpr double kBar = 10.0, kBall = 3.0, kMiddle = 10.5, kPitch = 15.0;
  FiveAxisJob job{"shape = \"cylinder\"\naxis = \"x\"\nbase = [-15, 0, 0]\ndiameter = 20\nlength = 30",
                  "type = \"ball\"\ndiameter = 6\nflute_length = 40\noverall_length = 70"};
  job.machine = kHead;
  job.resolution = 0.4;
  const MachinedPart part = machined(
      job, "", {100, 200, -300},
      std::string(kStart) + "G0 A0\nG0 X-30 Y0\nG43 H1 Z50\nG0 Z7.5\nG1 F500 X30 A1440\nG0 Z50\nM30\n");
  // The part turns right-handed under a table whose axis is left-handed, or the other way round.
  const auto from = [&](const Vec3& p) {
    const double sense = -1.0;
    const auto middle = [&](double x) {
      const double a = sense * 2.0 * kPi * (x + 30.0) / kPitch;
      return Vec3(x, kMiddle * std::sin(a), kMiddle * std::cos(a));
    };
    double best = 1e9;
    for (double x = p.x() - 4.0; x < p.x() + 4.0; x += 0.1) {
      if ((middle(x) - p).norm() < best) best = (middle(x) - p).norm();
    }
    for (double x = p.x() - 4.0; x < p.x() + 4.0; x += 0.1) {
      if ((middle(x) - p).norm() > best + 0.05) continue;
      const auto f = [&](double at) { return (middle(at) - p).norm(); };
      best = std::min(best, f(leastAt(f, x - 0.1, x + 0.1, 1e-10)));
    }
    return best - kBall;
  };
  // Two pitches, each of the groove's section at one place of X: at 0 it lies about +z.
  const auto half_angle = [&](double r) {
    const auto inside = [&](double angle) {
      return from(Vec3(0.0, r * std::sin(angle), r * std::cos(angle))) < 0.0;
    };
    double low = 0.0, high = kPi;
    while (high - low > 1e-12) (inside(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return low;
  };
  constexpr int kSteps = 64;
  double section = 0.0;  // r goes with the square: at the groove's bottom the angle begins as a root
  const double deep = kBar - (kMiddle - kBall);
  for (int i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps, r = kMiddle - kBall + deep * u * u;
    const double weight = (i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * kSteps);
    section += weight * 2.0 * half_angle(r) * r * 2.0 * deep * u;
  }
  const double exact = 30.0 * (kPi * kBar * kBar - section);
  expectForm("helical groove", job, part, exact, [&](const Vec3& p) {
    return std::vector<double>{from(p), p.tail<2>().norm() - kBar, std::abs(p.x()) - 15.0};
  });
}

/// The flank of a mill whose axis lies in the faces of a pyramid (25.16): faces at its radius below them.
TEST(TurningTools, TheFlankCutsAPyramid) {
  const FiveAxisJob job{"shape = \"box\"\nmin = [8, 8, 6]\nmax = [92, 92, 26]",
                        "type = \"flat\"\ndiameter = 20\nflute_length = 60\noverall_length = 70"};
  const std::string program = std::string(kStart) +
                              "G0 X150 Y150 Z150\nG43.5 P1 H1 Z0 I-20 J-20 K40\nG1 X100 Y100 F1000\n"
                              "X0 I20 J-20 K40\nY0 I20 J20 K40\nX100 I-20 J20 K40\nY100 I-20 J-20 K40\n"
                              "G0 X150 Y150\nG49 Z150\nM30\n";
  const double back = 10.0 * std::sqrt(1.25);  // level, of the faces
  const auto half = [&](double z) { return 50.0 - 0.5 * z - back; };
  const auto primitive = [&](double z) { return -8.0 / 3.0 * std::pow(half(z), 3); };
  const double exact = primitive(26.0) - primitive(6.0);
  for (const std::size_t machine : {std::size_t{0}, std::size_t{3}, std::size_t{4}}) {
    const Vec3 zero = placedMachine(machine).zero - Vec3(50, 50, 0);
    expectForm("pyramid", job, machined(job, placedMachine(machine).file, zero, program), exact,
               [&](const Vec3& p) {
                 const Vec2 q = (p.head<2>() - Vec2(50, 50)).cwiseAbs() - Vec2::Constant(half(p.z()));
                 return std::vector<double>{q.x() / std::sqrt(1.25), q.y() / std::sqrt(1.25), p.z() - 6.0,
                                            p.z() - 26.0};
               });
  }
}

/// The sample's cone, upright and tilted (NAS 979): each vertex, not only what the comparison tells.
TEST(TurningTools, TheFlankCutsACone) {
  for (const bool tilted : {false, true}) {
    const Workbench bench;
    const std::string file =
        std::string(PROVEOUT_SOURCE_DIR) + "/parts/cone_frustum/" + (tilted ? "tilted.toml" : "job.toml");
    const Outcome outcome = bench.run("run '" + file + "' --no-render --simplify 0 --out out");
    MachinedPart part;
    part.exit_code = outcome.exit_code;
    part.said = outcome.err;
    part.report = nlohmann::json::parse(readFile(bench.path("out/report.json")));
    part.volume = part.report["stock"]["final_mm3"].get<double>();
    for (const std::string& name : bench.files("out")) {
      if (name.ends_with(".stl")) part.mesh = *loadMesh(bench.path("out/" + name));
    }
    ASSERT_GT(part.mesh.positions.size(), 1000u);
    const double angle = degToRad(12.0), top = 30.0 - 24.0 * std::tan(angle);
    const double exact = kPi / 3.0 * 24.0 * (900.0 + 30.0 * top + top * top);
    const Eigen::Matrix3d back =
        Eigen::AngleAxisd(degToRad(tilted ? -10.0 : 0.0), Vec3::UnitX()).toRotationMatrix();
    expectForm(tilted ? "cone, tilted" : "cone", FiveAxisJob{}, part, exact, [&](const Vec3& at) {
      const Vec3 p = back * at;
      return std::vector<double>(
          {(p.head<2>().norm() - 30.0) * std::cos(angle) + p.z() * std::sin(angle), p.z(), p.z() - 24.0});
    });
  }
}

/// A table turns under a standing bull nose: the parallel of its section round the table's axis.
TEST(TurningTools, ATableTurnsARing) {
  constexpr double kFar = 20.0, kRadius = 5.0, kCorner = 1.5, kDeep = 3.0;
  const FiveAxisJob job{"shape = \"box\"\nmin = [-30, -30, -10]\nmax = [30, 30, 0]",
                        "type = \"bull\"\ndiameter = 10\ncorner_radius = 1.5\nflute_length = 30"};
  const MachinedPart part =
      machined(job, "trunnion_ac.toml", {400, 300, -430},
               std::string(kStart) +
                   "G0 A0 C0\nG0 X20 Y0\nG43 H1 Z50\nG0 Z2\nG1 F300 Z-3\nG1 C400\nG0 Z50\nG49 Z100\nM30\n");
  const double corner = (1.0 - kPi / 4.0) * kCorner * kCorner;
  // Pappus: the section is symmetric, its middle goes once round.
  const double ring = 2.0 * kPi * kFar * (2.0 * kRadius * kDeep - 2.0 * corner);
  expectForm("ring of a bull nose", job, part, 60.0 * 60.0 * 10.0 - ring, [&](const Vec3& p) {
    std::vector<double> off = facesOf({-30, -30, -10}, {30, 30, 0}, p);
    const double aside = std::abs(p.head<2>().norm() - kFar);
    off.push_back(aside - kRadius);
    off.push_back(p.z() + kDeep);
    off.push_back(std::hypot(aside - kRadius + kCorner, p.z() + kDeep - kCorner) - kCorner);
    return off;
  });
}

const char* const kSmall = "shape = \"box\"\nmin = [-8, -8, -8]\nmax = [8, 8, 0]";

/// G53.6 about the middle of a ball, which is R behind its tip: what was there stays.
TEST(TurningTools, ABallThatTiltsAboutItsMiddleCutsItsBallAlone) {
  FiveAxisJob job{kSmall, "type = \"ball\"\ndiameter = 6\nflute_length = 30\noverall_length = 60"};
  job.resolution = 0.3;
  for (const std::size_t machine : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
    const MachinedPart part =
        machined(job, machine,
                 std::string(kStart) +
                     "G0 X0 Y0\nG43 H1 Z50\nG1 F300 Z-1.5\nG68.2 X0 Y0 Z0 I30 J25 K0\nG53.6 H1 R-3\n"
                     "G68.2 X0 Y0 Z0 I-140 J28 K0\nG53.6 H1 R-3\nG0 Z40\nG69.1 G49\nM30\n");
    const double cap = kPi * 1.5 * 1.5 * (9.0 - 1.5) / 3.0;
    expectForm("ball about its middle", job, part, 16.0 * 16.0 * 8.0 - cap, [&](const Vec3& p) {
      std::vector<double> off = facesOf({-8, -8, -8}, {8, 8, 0}, p);
      off.push_back((p - Vec3(0, 0, 1.5)).norm() - 3.0);
      return off;
    });
  }
}

/// G53.6 about the tip of a flat end: its rim comes below the tip.
TEST(TurningTools, AFlatEndThatTiltsReachesBelowItsTip) {
  FiveAxisJob job{kSmall, "type = \"flat\"\ndiameter = 10\nflute_length = 30\noverall_length = 60"};
  job.resolution = 0.2;
  const MachinedPart part =
      machined(job, 0,
               std::string(kStart) +
                   "G0 X0 Y0\nG43 H1 Z50\nG1 F300 Z-1\nG68.2 X0 Y0 Z0 I0 J25 K0\nG53.6 H1\n"
                   "G0 Z40\nG69.1 G49\nM30\n");
  ASSERT_EQ(part.exit_code, 0) << part.said;
  double low = 0.0;
  for (const auto& p : part.mesh.positions) {
    if (p.head<2>().norm() < 7.0F && p.z() > -7.5F) low = std::min(low, static_cast<double>(p.z()));
  }
  const double exact = -1.0 - 5.0 * std::sin(degToRad(25.0));
  std::printf("flat end: lowest vertex at %.5f for %.5f\n", low, exact);
  EXPECT_GE(low, exact - kMicron);
  EXPECT_LE(low, exact + 0.01);
}

}  // namespace
}  // namespace turning_tools
}  // namespace proveout::test
