// The common subset of Fanuc-like mills and LinuxCNC: the motions that LinuxCNC's interpreter gives,
// and those of the control `linuxcnc`, which `make peer` holds to it. fan-20-rs274
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/unit/nc/fanuc/common_subset.h"

namespace proveout::test {
namespace {

struct CommonMotion {
  char kind = 'R';  ///< R rapid, F feed, A arc
  Vec3 to = Vec3::Zero(), center = Vec3::Zero();
};

/// Motions that go somewhere by more than `least`.
std::vector<CommonMotion> motionsOf(const IsoRun& run, double least) {
  std::vector<CommonMotion> all;
  Vec3 at = Vec3::Zero();
  for (const Motion& m : run.path.motions) {
    const bool arc = m.arc >= 0;
    if (arc || (m.to - at).cwiseAbs().maxCoeff() > least)
      all.push_back({arc                            ? 'A'
                     : m.kind == MotionKind::kRapid ? 'R'
                                                    : 'F',
                     m.to, arc ? run.path.arcs[static_cast<std::size_t>(m.arc)].center : Vec3(Vec3::Zero())});
    at = m.to;
  }
  return all;
}

struct Figures {
  unsigned number = 0;
  std::vector<CommonMotion> motions;
};

/// "program 7" and its motions: kind, X Y Z of the end, of arcs X Y Z of the centre with - across the plane.
std::vector<Figures> readFigures() {
  std::ifstream in(std::string(PROVEOUT_SOURCE_DIR) + "/tests/unit/nc/fanuc/rs274_figures.txt");
  std::vector<Figures> all;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string first;
    if (!(words >> first) || first == "#") continue;
    if (first == "program") {
      words >> all.emplace_back().number;
      continue;
    }
    CommonMotion m;
    m.kind = first[0];
    words >> m.to.x() >> m.to.y() >> m.to.z();
    for (int axis = 0; m.kind == 'A' && axis < 3; ++axis) {
      std::string value;
      words >> value;
      m.center[axis] = value == "-" ? std::nan("") : std::stod(value);
    }
    all.back().motions.push_back(m);
  }
  return all;
}

/// `other` may have no figure for a centre across the plane.
bool sameMotion(const CommonMotion& ours, const CommonMotion& other, double most) {
  if (ours.kind != other.kind || (ours.to - other.to).cwiseAbs().maxCoeff() > most) return false;
  for (int axis = 0; axis < 3 && ours.kind == 'A'; ++axis) {
    if (std::abs(ours.center[axis] - other.center[axis]) > most) return false;
  }
  return true;
}

void expectSame(const std::vector<CommonMotion>& ours, const std::vector<CommonMotion>& theirs, double most,
                const std::string& program) {
  ASSERT_EQ(ours.size(), theirs.size()) << program;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    ASSERT_TRUE(sameMotion(ours[k], theirs[k], most))
        << "motion " << k << ": " << ours[k].kind << ' ' << IsoRun::shown(ours[k].to) << " for "
        << theirs[k].kind << ' ' << IsoRun::shown(theirs[k].to) << "\n"
        << program;
  }
}

TEST(FanucRs274, MovesAsTheInterpreterDoes) {
  constexpr double kSameMm = 1.5e-6;  // the figures have seven decimals
  int compared = 0;
  for (const Figures& figures : readFigures()) {
    const CommonProgram program = commonProgram(figures.number);
    const IsoRun run(ControlId::kFanucMill, program.fanuc, commonSettings(ControlId::kFanucMill));
    ASSERT_EQ(run.error(), "") << run.message() << "\n" << program.fanuc;
    expectSame(motionsOf(run, kSameMm), figures.motions, kSameMm, program.fanuc);
    if (testing::Test::HasFatalFailure()) return;
    compared += static_cast<int>(figures.motions.size());
  }
  EXPECT_GT(compared, 1500);
}

TEST(FanucRs274, MovesAsLinuxCncDoes) {
  constexpr double kSameMm = 1e-6;
  constexpr unsigned kPrograms = 1000;
  std::size_t compared = 0;
  for (unsigned number = 0; number < kPrograms; ++number) {
    const CommonProgram program = commonProgram(number);
    const IsoRun fanuc(ControlId::kFanucMill, program.fanuc, commonSettings(ControlId::kFanucMill));
    const IsoRun other(ControlId::kLinuxCnc, program.linuxcnc, commonSettings(ControlId::kLinuxCnc));
    ASSERT_EQ(fanuc.error(), "") << number << ": " << fanuc.message() << "\n" << program.fanuc;
    ASSERT_EQ(other.error(), "") << number << ": " << other.message() << "\n" << program.linuxcnc;
    const auto theirs = motionsOf(other, kSameMm);
    expectSame(motionsOf(fanuc, kSameMm), theirs, kSameMm, program.fanuc);
    if (testing::Test::HasFatalFailure()) return;
    compared += theirs.size();
  }
  EXPECT_GT(compared, 15000U);
}

}  // namespace
}  // namespace proveout::test
