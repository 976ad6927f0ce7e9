// The same cut by tip control and as a post-processor writes it for one machine: blocks of a tenth of a
// degree whose axes go linearly. Rows: nct-25.14-G43.4 nct-25.2-G43.1 nct-25.1-TT nct-25.1-HH
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "five_axis_jobs.h"

namespace proveout::test {
namespace posted_axes {
namespace {

constexpr double kGauge = FiveAxisJob::kGauge, kStepDegrees = 0.1;
constexpr double kHighestCut = 60.0;  // of the tool that is in the material, from its tip
constexpr double kRadius = 5.0;       // of the tool
constexpr double kWordMm = 0.5e-6;    // half of the last digit of a linear word
constexpr double kSweepMm = 5e-4;     // what both parts may be off, and single precision

/// One block: tip on a line, axes linearly.
struct Block {
  Vec3 from, to;
  double first_from, second_from, first_to, second_to;
};
/// A machine by its equations, written for this test.
struct Posting {
  const char* machine;
  Vec3 zero;
  const char *first, *second;
  /// Where the axes are, from the zero, with a tip in the workpiece frame.
  Vec3 (*axes)(const Vec3& zero, const Vec3& tip, double first, double second);
  /// Tip in the workpiece frame, of axes from the zero.
  Vec3 (*tip)(const Vec3& zero, const Vec3& axes, double first, double second);
};

Eigen::Matrix3d about(const Vec3& u, double degrees) {
  return Eigen::AngleAxisd(degToRad(degrees), u).toRotationMatrix();
}

// Trunnion: A about X through (400, 300, -500), C about Z on it 40 mm above, both left-handed.
const Vec3 kTrunnion(400, 300, -500), kTable(0, 0, 40);
Vec3 trunnionAxes(const Vec3& zero, const Vec3& tip, double a, double c) {
  const Eigen::Matrix3d m1 = about(Vec3::UnitX(), -a), m2 = about(Vec3::UnitZ(), -c);
  const Vec3 at = kTrunnion + m1 * (kTable + m2 * (zero - kTrunnion - kTable + tip));
  return at + Vec3(0, 0, kGauge) - zero;
}
Vec3 trunnionTip(const Vec3& zero, const Vec3& axes, double a, double c) {
  const Eigen::Matrix3d m1 = about(Vec3::UnitX(), a), m2 = about(Vec3::UnitZ(), c);
  const Vec3 at = axes - Vec3(0, 0, kGauge) + zero;
  return m2 * (m1 * (at - kTrunnion) - kTable) - (zero - kTrunnion - kTable);
}
// Head: C carries B, both through a point 150 mm above the gauge point.
const Vec3 kPivot(0, 0, 150);
Vec3 headDirection(double c, double b) {
  return about(Vec3::UnitZ(), c) * (about(Vec3::UnitY(), b) * Vec3::UnitZ());
}
Vec3 headAxes(const Vec3&, const Vec3& tip, double c, double b) {
  return tip + (kGauge + kPivot.z()) * headDirection(c, b) - kPivot;
}
Vec3 headTip(const Vec3&, const Vec3& axes, double c, double b) {
  return axes + kPivot - (kGauge + kPivot.z()) * headDirection(c, b);
}

std::string word(char letter, double value, const char* format = "%c%.6f ") {
  char text[40];
  std::snprintf(text, sizeof text, format, letter, value);
  return text;
}

/// What a point of the cutting tool is off, between where tip control and the posted block take it.
double chordOf(const Posting& on, const Block& block, double s0, double s1) {
  const auto first = [&](double s) { return block.first_from + s * (block.first_to - block.first_from); };
  const auto second = [&](double s) { return block.second_from + s * (block.second_to - block.second_from); };
  const auto axesAt = [&](double s) {
    return on.axes(on.zero, block.from + s * (block.to - block.from), first(s), second(s));
  };
  double most = 0.0;
  for (const double part : {0.25, 0.5, 0.75}) {
    const double s = s0 + part * (s1 - s0);
    // Angles go linearly either way, so that the directions are the same: only the tips part.
    const Vec3 posted = on.tip(on.zero, axesAt(s0) + part * (axesAt(s1) - axesAt(s0)), first(s), second(s));
    most = std::max(most, (posted - block.from - s * (block.to - block.from)).norm());
  }
  return most;
}

class PostedAxes : public testing::TestWithParam<int> {};

TEST_P(PostedAxes, DifferByTheirChords) {
  const bool head = GetParam() == 1;
  const Posting on =
      head ? Posting{"head_cb.toml", Vec3::Zero(), "C", "B", headAxes, headTip}
           : Posting{"trunnion_ac.toml", Vec3(405, 297, -430), "A", "C", trunnionAxes, trunnionTip};
  // Through a block, the tool swinging on the way.
  const Block block{{-30, 4, -8},        {30, -3, -9},       head ? -60.0 : 20.0,
                    head ? 20.0 : -30.0, head ? 10.0 : 38.0, head ? 38.0 : 10.0};
  const auto angles = [&](double first, double second) {
    return word(on.first[0], first) + word(on.second[0], second);
  };
  const auto xyz = [](const Vec3& p) { return word('X', p.x()) + word('Y', p.y()) + word('Z', p.z()); };
  const std::string start =
      "G17 G21 G90 G54\nT1 M6\nS4000 M3\nG0 " + angles(block.first_from, block.second_from) + "\n";
  std::string source = start + "G43.4 H1 X-30 Y4 Z60\nG1 F1000 Z-8\n";
  std::string posted = start + "G49 G0 ";
  const Vec3 above(-30, 4, 60);
  posted += xyz(on.axes(on.zero, above, block.first_from, block.second_from)) + "\nG1 F1000\n" +
            xyz(on.axes(on.zero, block.from, block.first_from, block.second_from)) + "\n";
  double chord = 0.0;
  source += xyz(block.to) + angles(block.first_to, block.second_to) + "\n";
  const double most =
      std::max(std::abs(block.first_to - block.first_from), std::abs(block.second_to - block.second_from));
  const int pieces = static_cast<int>(std::ceil(most / kStepDegrees));
  for (int i = 1; i <= pieces; ++i) {
    const double s = static_cast<double>(i) / pieces;
    const double first = block.first_from + s * (block.first_to - block.first_from),
                 second = block.second_from + s * (block.second_to - block.second_from);
    posted += xyz(on.axes(on.zero, block.from + s * (block.to - block.from), first, second)) +
              angles(first, second) + "\n";
    chord = std::max(chord, chordOf(on, block, static_cast<double>(i - 1) / pieces, s));
  }
  source += "G0 Z72\nG49 Z150\nM30\n";

  posted +=
      "G0 " + xyz(on.axes(on.zero, block.to + Vec3(0, 0, 80), block.first_to, block.second_to)) + "\nM30\n";

  const Vec3 low(-10, -10, -16), high(10, 12, 0);
  const FiveAxisJob job{"shape = \"box\"\nmin = [-10, -10, -16]\nmax = [10, 12, 0]",
                        "type = \"ball\"\ndiameter = 10\nflute_length = 60\noverall_length = 70", "", "",
                        0.2};
  const MachinedPart by_tip = machined(job, on.machine, on.zero, source);
  ASSERT_EQ(by_tip.exit_code, 0) << by_tip.said;
  const MachinedPart by_axes = machined(job, on.machine, on.zero, posted);
  ASSERT_EQ(by_axes.exit_code, 0) << by_axes.said;
  // Words of angles are off by half of their last digit, at the highest point that cuts; and where a cell has
  // several blocks, its vertex may lie on a chord of the grid.
  const double words = std::sqrt(3.0) * kWordMm + 2.0 * kHighestCut * degToRad(0.5e-6);
  const double grid = job.resolution * job.resolution / (8.0 * kRadius);
  double off = 0.0;
  std::size_t seen = 0;
  const auto look = [&](const MachinedPart& from, const MachinedPart& to) {
    const TriangleTree tree(toSurface(to.mesh));
    for (const auto& vertex : from.mesh.positions) {
      const Vec3 p = vertex.cast<double>();
      if (fromBox(low, high, p) > -job.resolution) continue;  // on the blank's faces and edges
      off = std::max(off, std::sqrt(tree.nearest(p).squared));
      ++seen;
    }
  };
  look(by_tip, by_axes);
  look(by_axes, by_tip);
  std::printf(
      "%s: %d posted blocks, chords of %.3g mm; %zu vertices of the cut differ by %.3g mm, volumes by %.3g\n",
      on.machine, pieces, chord, seen, off, by_axes.volume / by_tip.volume - 1.0);
  EXPECT_GT(seen, 10000u);
  EXPECT_LE(off, chord + words + 2.0 * grid + kSweepMm);
  // A groove through the block: walls of no more than twice its depth, and a round below.
  const double area = (high.x() - low.x()) * (2.0 * 20.0);
  const auto told = [](const MachinedPart& part) { return part.report["stock"]["error_mm3"].get<double>(); };
  EXPECT_NEAR(by_axes.volume, by_tip.volume, (chord + words) * area + told(by_tip) + told(by_axes));
  std::printf("%s: volumes differ by %.3g mm3, told are %.3g and %.3g\n", on.machine,
              by_axes.volume - by_tip.volume, told(by_tip), told(by_axes));
}

INSTANTIATE_TEST_SUITE_P(TrunnionAndHead, PostedAxes, testing::Range(0, 2));

}  // namespace
}  // namespace posted_axes
}  // namespace proveout::test
