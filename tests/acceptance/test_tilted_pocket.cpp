// A pocket and holes on a tilted plane, on machines of all kinds, against the exact faces of the same program
// upright. Rows: nct-25.6-G68.2 nct-25.6-G69.1 nct-25.11-G53.1
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "five_axis_jobs.h"

namespace proveout::test {
namespace tilted_pocket {
namespace {

const Vec3 kLow(-30, -20, -20), kHigh(30, 20, 0);
constexpr double kRadius = 4.0;  // of the mill
constexpr double kDeep = 5.0;    // of the pocket

struct Hole {
  double x, y, z;
};
constexpr Hole kHoles[] = {{20, 10, -9}, {20, -10, -9}, {-20, 12, -12}};

/// Contour by lines and arcs with compensation, holes by cycles.
std::string programOf(const std::string& plane, const std::string& level) {
  return "G17 G21 G40 G80 G90 G54\nT1 M6\nS4000 M3\nG0 X0 Y0\nG43 Z90 H1\n" + plane +
         "G0 X0 Y0 Z10\nG1 Z-5 F300\nG41 D1 X0 Y-7\nX5\nG3 X10 Y-2 R5\nG1 Y2\nG3 X5 Y7 R5\nG1 X-5\n"
         "G3 X-10 Y2 I0 J-5\nG1 Y-2\nG3 X-5 Y-7 I5 J0\nG1 X0\nG40 X0 Y0\nG0 Z10\n"
         "G81 X20 Y10 R2 Z-9 F200\nY-10\nG83 X-20 Y12 R2 Z-12 Q4\nG80\nG0 Z60\n" +
         level + "M30\n";
}

/// The box where a plane lies, as triangles.
std::string blankAt(const Eigen::Matrix3d& turn, const Vec3& origin) {
  std::string text;
  char line[120];
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) ? kHigh.x() : kLow.x(), (i & 2) ? kHigh.y() : kLow.y(),
                      (i & 4) ? kHigh.z() : kLow.z());
    const Vec3 p = turn * corner + origin;
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p.x(), p.y(), p.z());
    text += line;
  }
  return text +
         "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\n"
         "f 2 4 8\nf 2 8 6\n";
}

/// Of a rounded rectangle of 20 x 14 with radii of 5, mm; below 0 inside.
double fromContour(const Vec2& p) {
  const Vec2 q = p.cwiseAbs() - Vec2(5.0, 2.0);
  return q.cwiseMax(0.0).norm() + std::min(0.0, q.maxCoeff()) - 5.0;
}
/// How far a point is off the nearest face of the part, and off the one after it.
std::array<double, 2> fromFaces(const Vec3& p) {
  std::vector<double> off;
  for (int k = 0; k < 3; ++k) {
    off.push_back(std::abs(p[k] - kLow[k]));
    off.push_back(std::abs(p[k] - kHigh[k]));
  }
  const auto add = [&](double aside, double depth) {
    if (p.z() > -depth - 0.1) off.push_back(std::abs(aside));
    if (aside < 0.1) off.push_back(std::abs(p.z() + depth));
  };
  add(fromContour(p.head<2>()), kDeep);
  for (const Hole& hole : kHoles) add((p.head<2>() - Vec2(hole.x, hole.y)).norm() - kRadius, -hole.z);
  std::partial_sort(off.begin(), off.begin() + 2, off.end());
  return {off[0], off[1]};
}

/// Largest distance of a mesh's vertices from the faces, mm. Where two faces meet within a cell the vertex is
/// where the cell's crossings see their edge.
struct Off {
  double faces = 0.0, edges = 0.0;
};
template <typename ToPlane>
Off offOf(const TriMesh& mesh, double resolution, const ToPlane& to_plane) {
  Off most;
  for (const auto& vertex : mesh.positions) {
    const auto [off, next] = fromFaces(to_plane(vertex.cast<double>()));
    double& of = next > std::sqrt(3.0) * resolution ? most.faces : most.edges;
    of = std::max(of, off);
  }
  return most;
}

class TiltedPocket : public testing::TestWithParam<std::size_t> {};

TEST_P(TiltedPocket, HasTheFacesOfItsUprightTwin) {
  const double a = degToRad(30.0), b = degToRad(25.0), c = degToRad(-40.0);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(a, Vec3::UnitZ()) * Eigen::AngleAxisd(b, Vec3::UnitX()) *
                                Eigen::AngleAxisd(c, Vec3::UnitZ()))
                                   .toRotationMatrix();
  const Vec3 origin(15, -8, 5);
  FiveAxisJob job{"shape = \"mesh\"\nfile = \"blank.obj\"",
                  "type = \"flat\"\ndiameter = 8\nflute_length = 40\noverall_length = 70",
                  "[offsets.radius]\n1 = 4.0\n"};
  job.blank = blankAt(Eigen::Matrix3d::Identity(), Vec3::Zero());
  const MachinedPart upright = machined(job, GetParam(), programOf("", "G49 Z100\n"));
  ASSERT_EQ(upright.exit_code, 0) << upright.said;
  job.blank = blankAt(turn, origin);
  const MachinedPart tilted =
      machined(job, GetParam(), programOf("G68.2 X15 Y-8 Z5 I30 J25 K-40\nG53.1\n", "G69.1 G49\n"));
  ASSERT_EQ(tilted.exit_code, 0) << tilted.said;

  const double pocket = (20.0 * 14.0 - (4.0 - kPi) * 25.0) * kDeep;
  double exact = (kHigh - kLow).prod() - pocket;
  for (const Hole& hole : kHoles) exact -= kPi * kRadius * kRadius * -hole.z;
  const Off off = offOf(tilted.mesh, job.resolution,
                        [&](const Vec3& p) -> Vec3 { return turn.transpose() * (p - origin); });
  const Off twin = offOf(upright.mesh, job.resolution, [](const Vec3& p) { return p; });
  std::printf(
      "tilted pocket on %s: vertices off faces by %.3g mm, off edges by %.3g, volume by %.3g; upright %.3g, "
      "%.3g, %.3g\n",
      placedMachine(GetParam()).file, off.faces, off.edges, tilted.volume / exact - 1.0, twin.faces,
      twin.edges, upright.volume / exact - 1.0);
  EXPECT_LE(off.faces, 1e-3);
  EXPECT_LE(twin.faces, 1e-3);
  EXPECT_LE(off.edges, 2e-3);
  EXPECT_LE(twin.edges, 2e-3);
  EXPECT_NEAR(tilted.volume, exact, 1e-6 * exact);
  EXPECT_NEAR(upright.volume, exact, 1e-6 * exact);
  EXPECT_NEAR(tilted.volume, upright.volume, 1e-6 * exact);
}

INSTANTIATE_TEST_SUITE_P(Machines, TiltedPocket, testing::Range(std::size_t{0}, kMachines));

}  // namespace
}  // namespace tilted_pocket
}  // namespace proveout::test
