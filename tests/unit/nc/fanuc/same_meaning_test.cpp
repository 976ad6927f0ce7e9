// Programs that mean the same on nct and on a Fanuc-like mill, each written as its control wants it: same
// motions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

/// One program in two writings.
class Pair {
 public:
  explicit Pair(unsigned seed) : random_(seed) {}

  const std::string& nct() const { return nct_; }
  std::string fanuc() const { return "O1\n" + fanuc_ + subprogram_; }
  const std::string& subprogram() const { return subprogram_; }

  void fill() {
    both("G21 G90 G17 G40 G49 G80\n");
    both("G54\n");
    both(fmt::format("G0 X{} Y{}\n", place(), place()));
    both(fmt::format("G43 H1 Z{}\n", 20 + below(10)));
    both("S1000 M3\n");
    const int parts = 3 + below(6);
    for (int k = 0; k < parts; ++k) part();
    both("G40 G80 G69 G50\nG0 Z60\nM30\n");
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  /// A place in mm with a point: both controls read it alike.
  std::string place(int most = 60) {
    return fmt::format(
        "{:.3f}", 0.001 * (static_cast<int>(random_() % static_cast<unsigned>(2000 * most)) - 1000 * most));
  }
  void both(const std::string& line) { each(line, line); }
  void each(const std::string& nct, const std::string& fanuc) {
    nct_ += nct;
    fanuc_ += fanuc;
  }

  void part() {
    switch (below(10)) {
      case 0:
        return lines();
      case 1:
        return arcs();
      case 2:
        return holes();
      case 3:
        return dwell();
      case 4:
        return turned();
      case 5:
        return scaled();
      case 6:
        return called();
      case 7:
        return looped();
      case 8:
        return shifted();
      default:
        return compensated();
    }
  }

  void lines() {
    const bool steps = below(3) == 0;
    both(steps ? "G91\n" : "G90\n");
    for (int k = 0; k < 4; ++k) {
      const bool rapid = below(3) == 0;
      if (rapid) both(fmt::format("G0 {}{}\n", "XYZ"[below(3)], place(20)));
      if (!rapid) both(fmt::format("G1 X{} Y{} Z{} F{}\n", place(20), place(20), place(5), 100 + below(900)));
    }
    both("G90\n");
  }

  void arcs() {
    const double r = 5 + below(20);
    both(fmt::format("G0 X{} Y0.\nG0 Y{}\n", place(10), place(10)));
    both(fmt::format("G91 G{} X{:.3f} Y{:.3f} R{:.3f} F300\n", 2 + below(2), r, r, r));
    both(fmt::format("G{} X{:.3f} I{:.3f} J0.\n", 2 + below(2), 2 * r, r));
    both(fmt::format("G{} I{:.3f} Z{}\nG90\n", 2 + below(2), r, place(3)));
    both(fmt::format("G90 G1 X{} Y{}\n", place(), place()));
  }

  void holes() {
    const int cycle = std::vector<int>{81, 82, 83, 73, 85, 89, 86}[static_cast<std::size_t>(below(7))];
    const bool dwells = cycle == 82 || cycle == 89;
    const bool pecks = cycle == 83 || cycle == 73;
    const std::string rest =
        fmt::format(" Z-{}. R{}. F200{}", 5 + below(20), 2 + below(3), pecks ? " Q4." : "");
    both(fmt::format("G0 Z{}.\nG{} G{} X{}", 10 + below(20), 98 + below(2), cycle, place()));
    each(rest + (dwells ? " P0.5\n" : "\n"), rest + (dwells ? " P500\n" : "\n"));
    both(fmt::format("X{} Y{}\n", place(), place()));
    each("G91 X3. Y1. L3\n", "G91 X3. Y1. K3\n");
    both("G90 G80\n");
  }

  void dwell() { each("G4 P1.5\n", below(2) == 0 ? "G4 X1.5\n" : "G4 P1500\n"); }

  void turned() {
    // From where the tool stands the controls count in another way: the first motion names both axes.
    both(fmt::format("G68 X{} Y{} R{}\nG0 X{} Y{}\n", place(20), place(20), place(170), place(), place()));
    lines();
    both(fmt::format("G69\nG0 X{} Y{}\n", place(), place()));
  }

  void scaled() {
    const int percent = 50 + 10 * below(20);
    each(fmt::format("G51 X{0} Y{0} Z0 P{1}\n", 5, 0.01 * percent),
         fmt::format("G51 X{0}. Y{0}. Z0. P{1}\n", 5, 10 * percent));
    both(fmt::format("G1 X{} Y{} F400\nX{}\n", place(), place(), place()));
    both(fmt::format("G50\nG0 X{} Y{}\n", place(), place()));
  }

  void called() {
    if (subprogram_.empty())
      subprogram_ = fmt::format("O2\nG91 G1 X{} Y{} F250\nZ-1.\nG90\nM99\n", place(9), place(9));
    const int times = 1 + below(4);
    each(fmt::format("M98 P2 L{}\n", times), times == 1 ? "M98 P2\n" : fmt::format("M98 P{}0002\n", times));
  }

  void looped() {
    both(fmt::format("#1=0\n#2={}\nWHILE[#1 LT {}]DO1\n", place(9), 2 + below(4)));
    both("G1 X[#2+#1*2.5] Y[#2*SIN[30]*2-#1*COS[60]*8] F150\n#1=#1+1\nEND1\n");
    both(fmt::format("IF[#1 GT 3]GOTO {0}\nG1 Z#2\nN{0} G0 Z25.\n", 100 + label_++));
  }

  void shifted() {
    both(fmt::format("G10 L2 P2 X{} Y{} Z0\nG55\n", place(20), place(20)));
    lines();
    both(fmt::format("G52 X{}\nG1 X{} F300\nG52 X0 Y0 Z0\nG54\nG0 X{} Y{}\n", place(9), place(), place(),
                     place()));
  }

  /// The outside and the inside of a rectangle, lines at right angles.
  void compensated() {
    const double w = 30 + below(20), h = 30 + below(20);
    const bool outside = below(2) == 0;
    both("G0 Z5.\n");
    both(outside ? "G0 X-30. Y-30.\nG1 Z-1. F100\nG41 D1 X0 Y0\n"
                 : "G0 X15. Y15.\nG1 Z-1. F100\nG41 D1 X0\n");
    if (outside) both(fmt::format("Y{0}\nX{1}\nY0\nX-30.\nG40 Y-30.\n", h, w));
    if (!outside) both(fmt::format("Y0\nX{1}\nY{0}\nX0\nY10.\nG40 X15.\n", h, w));
    both("G0 Z30.\n");
  }

  std::mt19937 random_;
  std::string nct_, fanuc_, subprogram_;
  int label_ = 0;
};

ControlSettings settingsOf(ControlId control) {
  ControlSettings settings = runAtZero();
  settings.start = Vec3(0, 0, 100);
  settings.radius_offsets[1] = {4.0, 0.0};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.work_given[0] = true;
  settings.work_offsets[0] = Vec3(3, -2, 1);
  for (const ParameterInfo& p : parameterTable(control)) {
    if (p.name == "rapid") settings.parameters["rapid"] = 1;  // straight
    if (p.name == "g73_retract" || p.name == "g83_clearance") settings.parameters[std::string(p.name)] = 1;
    if (p.name == "N1500" || p.name == "N1501") settings.parameters[std::string(p.name)] = 1;
  }
  return settings;
}

/// Only counted: nobody has looked at these seeds.
constexpr unsigned kFirstSeed = 770000, kSeeds = 300;

TEST(FanucSameMeaning, MovesAsNctDoes) {
  int same = 0;
  for (unsigned seed = kFirstSeed; seed < kFirstSeed + kSeeds; ++seed) {
    Pair pair(seed);
    pair.fill();
    const IsoRun nct(ControlId::kNct, pair.nct(), settingsOf(ControlId::kNct),
                     {{"O0002.nc", pair.subprogram()}});
    const IsoRun fanuc(ControlId::kFanucMill, pair.fanuc(), settingsOf(ControlId::kFanucMill));
    ASSERT_EQ(nct.error(), "") << seed << ": " << nct.message() << "\n" << pair.nct();
    ASSERT_EQ(fanuc.error(), "") << seed << ": " << fanuc.message() << "\n" << pair.fanuc();
    ASSERT_EQ(nct.path.motions.size(), fanuc.path.motions.size()) << seed << "\n" << pair.fanuc();
    for (std::size_t k = 0; k < nct.path.motions.size(); ++k) {
      const Motion &a = nct.path.motions[k], &b = fanuc.path.motions[k];
      ASSERT_LT((a.to - b.to).norm(), 1e-9) << seed << " motion " << k << "\n" << pair.fanuc();
      ASSERT_EQ(a.kind, b.kind) << seed << " motion " << k;
      ASSERT_EQ(a.arc >= 0, b.arc >= 0) << seed << " motion " << k;
      ASSERT_NEAR(a.feed, b.feed, 1e-9) << seed << " motion " << k;
    }
    ASSERT_NEAR(nct.summary.cycle_s, fanuc.summary.cycle_s, 1e-6) << seed << "\n" << pair.fanuc();
    ++same;
  }
  EXPECT_EQ(same, static_cast<int>(kSeeds));
}

}  // namespace
}  // namespace proveout::test
