// One program for all machines: under shank control the part does not tell which machine made it, without it
// the part does, and by what a dense reference says.
// Rows: nct-25.16-G43.5P1 nct-25.16-ARC nct-25.16-P0 nct-25.1-HH nct-25.1-TT nct-25.1-HT nct-25.1-INCL
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "five_axis_jobs.h"
#include "tests/support/golden_section.h"

namespace proveout::test {
namespace machine_independence {
namespace {

/// Parts of two machines are one, mm: room for single precision and what sweeps are off.
constexpr double kSamePart = 2e-3;
constexpr double kSameVolume = 1e-6;

std::string words(const char* letters, const Vec3& v) {
  char text[120];
  std::snprintf(text, sizeof text, "%c%.5f %c%.5f %c%.5f", letters[0], v.x(), letters[1], v.y(), letters[2],
                v.z());
  return text;
}
Vec3 leaning(double tilt, double azimuth) {
  const double a = degToRad(tilt), c = degToRad(azimuth);
  return {std::sin(a) * std::cos(c), std::sin(a) * std::sin(c), std::cos(a)};
}

void expectOnePart(const FiveAxisJob& job, const std::string& program, const char* what) {
  std::vector<MachinedPart> parts;
  for (std::size_t m = 0; m < kMachines; ++m) {
    parts.push_back(machined(job, m, program));
    ASSERT_EQ(parts.back().exit_code, 0) << what << " on " << placedMachine(m).file << parts.back().said;
  }
  double off = 0.0, volume = 0.0;
  for (std::size_t m = 1; m < kMachines; ++m) {
    off = std::max(
        {off, verticesFrom(parts[0].mesh, parts[m].mesh), verticesFrom(parts[m].mesh, parts[0].mesh)});
    volume = std::max(volume, std::abs(parts[m].volume / parts[0].volume - 1.0));
  }
  std::printf("%s on %zu machines: %zu vertices, parts differ by %.3g mm, volumes by %.3g\n", what, kMachines,
              parts[0].mesh.positions.size(), off, volume);
  EXPECT_LE(off, kSamePart);
  EXPECT_LE(volume, kSameVolume);
}

const char* const kBlock = "shape = \"box\"\nmin = [-20, -15, -12]\nmax = [20, 15, 0]";
const char* const kPlate = "shape = \"box\"\nmin = [-32, -32, -12]\nmax = [32, 32, 0]";
const char* const kStart = "G17 G21 G90 G54\nT1 M6\nS4000 M3\nG0 X0 Y0 Z150\n";

/// Passes of a ball end over waves, its axis on the way round a cone that opens and closes.
TEST(MachineIndependence, ABallWhoseVectorTurnsAllTheTime) {
  std::string program = kStart;
  int block = 0;
  const auto vector = [&] {
    return words("IJK", leaning(20.0 + 12.0 * std::sin(0.7 * block), 170.0 * std::cos(0.2 * block)));
  };
  program += "G43.5 P1 H1 X-26 Y-12 Z20 " + vector() + "\nG1 Z-1 F800\n";
  for (int pass = 0; pass < 5; ++pass) {
    const double y = -12.0 + 6.0 * pass;
    for (int k = 0; k <= 6; ++k) {
      const double x = (pass % 2 == 0 ? 1.0 : -1.0) * (-26.0 + 52.0 * k / 6.0);
      ++block;
      program += words("XYZ", {x, y, -3.5 + 1.2 * std::sin(0.2 * x + y)}) + " " + vector() + "\n";
    }
  }
  program += "G0 Z30\nG49 Z150\nM30\n";
  expectOnePart({kBlock, "type = \"ball\"\ndiameter = 8\nflute_length = 40\noverall_length = 70"}, program,
                "ball end");
}

/// The flank and bottom of a flat end: lines in which the vector turns, and arcs on which it goes round.
TEST(MachineIndependence, AFlatEndOnLinesAndArcs) {
  std::string program = kStart;
  program += "G43.5 P1 H1 X50 Y0 Z20 " + words("IJK", leaning(15, 180)) + "\nG1 Z-8 F800\nX14\n";
  for (int k = 1; k <= 4; ++k) {
    const double a = degToRad(90.0 * k);
    program += (k == 1 ? "G3 " : "") +
               words("XYZ", {14.0 * std::cos(a), 14.0 * std::sin(a), -8.0 - 0.5 * k}) + " R14 " +
               words("IJK", leaning(15.0 + 2.0 * k, 180.0 + 90.0 * k)) + "\n";
  }
  program += "G1 X50 Y2 Z-8 " + words("IJK", leaning(20, 80)) + "\nX33 Y31 " + words("IJK", leaning(30, 40)) +
             "\nX-31 Y33 " + words("IJK", leaning(25, -40)) + "\nX-33 Y-31 " +
             words("IJK", leaning(35, -120)) + "\nX34 Y-32 " + words("IJK", leaning(28, -30)) +
             "\nX60 Y-60\nG0 Z40\nG49 Z150\nM30\n";
  expectOnePart({kPlate, "type = \"flat\"\ndiameter = 8\nflute_length = 40\noverall_length = 70"}, program,
                "flat end");
}

/// A flat end whose axes go linearly between two directions while its tip goes along a line: dense places,
/// in double precision. It knows nothing of chains, sweeps and laws.
class DenseFlank {
 public:
  /// Angles of the axes at a direction, and the direction at such angles.
  using Angles = std::array<double, 2>;
  Vec3 from, to;
  Angles angles_from, angles_to;
  Vec3 (*direction)(const Angles&);

  double at(const Vec3& p, double s) const {
    const Vec3 axis = direction({angles_from[0] + s * (angles_to[0] - angles_from[0]),
                                 angles_from[1] + s * (angles_to[1] - angles_from[1])});
    const Vec3 q = p - from - s * (to - from);
    const double z = q.dot(axis);
    const Vec2 out((q - z * axis).norm() - kRadius, -z);
    return out.cwiseMax(Vec2::Zero()).norm() + std::min(out.maxCoeff(), 0.0);
  }
  /// Outside the distance from what the tool sweeps, inside below 0.
  double distance(const Vec3& p) const {
    constexpr int kPlaces = 800;
    int least = 0;
    double best = 1e9;
    for (int i = 0; i <= kPlaces; ++i) {
      if (const double d = at(p, static_cast<double>(i) / kPlaces); d < best) best = d, least = i;
    }
    const auto f = [&](double s) { return at(p, s); };
    return std::min(best, f(leastAt(f, std::max(0.0, (least - 1.0) / kPlaces),
                                    std::min(1.0, (least + 1.0) / kPlaces), 1e-9)));
  }
  static constexpr double kRadius = 4.0;
};

Vec3 about(const Vec3& u, double angle, const Vec3& v) {
  return std::cos(angle) * v + std::sin(angle) * u.cross(v) + (1.0 - std::cos(angle)) * u.dot(v) * u;
}

/// Trunnion A-C, both left-handed: t = (sin A sin C, -sin A cos C, cos A).
DenseFlank::Angles trunnionAngles(const Vec3& t) { return {std::acos(t.z()), std::atan2(t.x(), -t.y())}; }
Vec3 trunnionDirection(const DenseFlank::Angles& a) {
  return {std::sin(a[0]) * std::sin(a[1]), -std::sin(a[0]) * std::cos(a[1]), std::cos(a[0])};
}

/// Table whose B leans by 45 degrees: t = Rz(C) Rot((0, 1, -1) / sqrt 2, B) e_z.
Vec3 inclinedDirection(const DenseFlank::Angles& a) {
  return about(Vec3::UnitZ(), a[1], about(Vec3(0, 1, -1).normalized(), a[0], Vec3::UnitZ()));
}
/// Of the two pairs the one with the smaller way of B, then of C.
DenseFlank::Angles inclinedAngles(const Vec3& t, const DenseFlank::Angles& now) {
  DenseFlank::Angles best{1e9, 1e9};
  const auto way = [&](const DenseFlank::Angles& a) {
    return std::pair(std::round(1e6 * std::abs(a[0] - now[0])), std::abs(a[1] - now[1]));
  };
  for (const double sign : {1.0, -1.0}) {
    const double b = sign * std::acos(2.0 * t.z() - 1.0);
    const Vec3 at_zero = inclinedDirection({b, 0.0});
    const double c = std::atan2(t.y(), t.x()) - std::atan2(at_zero.y(), at_zero.x());
    const DenseFlank::Angles pair{b, now[1] + std::remainder(c - now[1], 2 * kPi)};
    if (way(pair) < way(best)) best = pair;
  }
  return best;
}

/// The flank of a flat end along a wall: without shank control the axes go linearly, each machine's its way.
TEST(MachineIndependence, WithoutShankControlTheMachineShows) {
  const Vec3 low(-20, 6, -20), high(20, 26, 0), from(-40, 16, -25), to(40, 16, -25);
  const Vec3 v1 = Vec3(-30, -24, 40).normalized(), v2 = Vec3(12, -1, 70).normalized();
  const FiveAxisJob job{"shape = \"box\"\nmin = [-20, 6, -20]\nmax = [20, 26, 0]",
                        "type = \"flat\"\ndiameter = 8\nflute_length = 60\noverall_length = 70"};
  const auto program = [&](const char* shank) {
    return std::string(kStart) + "G0 X-90 Y16\nG43.5 " + shank + " H1 X-90 Y16 Z-25 " + words("IJK", v1) +
           "\nX-40\nG1 F800 X40 " + words("IJK", v2) + "\nG0 X90\nG49 Z150\nM30\n";
  };
  const DenseFlank::Angles inclined = inclinedAngles(v1, {0.0, 0.0});
  const DenseFlank flanks[2] = {{from, to, trunnionAngles(v1), trunnionAngles(v2), trunnionDirection},
                                {from, to, inclined, inclinedAngles(v2, inclined), inclinedDirection}};
  const MachinedPart parts[2] = {machined(job, 0, program("P0")), machined(job, 4, program("P0"))};
  double off = 0.0, differ = 0.0, told = 0.0;
  for (int m = 0; m < 2; ++m) {
    ASSERT_EQ(parts[m].exit_code, 0) << parts[m].said;
    const TriangleTree other(toSurface(parts[1 - m].mesh));
    for (const auto& vertex : parts[m].mesh.positions) {
      const Vec3 p = vertex.cast<double>();
      const double box = fromBox(low, high, p);
      if (box > -job.resolution) continue;  // on the blank's faces, or in a cell with an edge of them
      off = std::max(off, std::abs(flanks[m].distance(p)));
      // How far the other machine's part goes on from here, if it does.
      const double beyond = std::min(flanks[1 - m].distance(p), -box);
      if (beyond <= 0.0) continue;
      differ = std::max(differ, beyond);
      told = std::max(told, std::abs(std::sqrt(other.nearest(p).squared) - beyond));
    }
  }
  std::printf(
      "P0: vertices off by %.3g mm; the parts differ by up to %.4f mm, by %.3g mm from the reference\n", off,
      differ, told);
  EXPECT_LT(off, 1e-3);
  EXPECT_GT(differ, 0.1);
  EXPECT_LT(told, 0.01);  // chords of the grid on a radius of 4
  expectOnePart(job, program("P1"), "flank under P1");
}

}  // namespace
}  // namespace machine_independence
}  // namespace proveout::test
