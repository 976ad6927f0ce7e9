// Random blocks of lathes: every run ends, and every path is finite.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

constexpr auto kLatheWords = std::to_array<const char*>(
    {"G0",   "G1",   "G2",   "G3",   "G4",   "G10", "G18",   "G20",   "G21",   "G24",   "G28",
     "G32",  "G34",  "G40",  "G41",  "G42",  "G50", "G50.3", "G53",   "G54",   "G68.1", "G69.1",
     "G70",  "G71",  "G72",  "G73",  "G74",  "G75", "G76",   "G77",   "G78",   "G79",   "G80",
     "G83",  "G84",  "G85",  "G87",  "G88",  "G89", "G90",   "G91",   "G92",   "G94",   "G96",
     "G97",  "G98",  "G99",  "M3",   "M5",   "M23", "M24",   "M98P7", "T0101", "T0202", "T0",
     "P1Q2", "P1Q2", "P1Q2", "P3Q2", "U-1.", "W.2", ",C1.",  ",R2.",  ",A135."});
constexpr auto kLatheValues =
    std::to_array<const char*>({"0", "1", "-1", "2.", "0.001", "-5.5", "10", "100.", "1e9", "7", "-0",
                                "99999999", "0.0000001", "#1", "[1/3]", "-[2]", "45.", "-20.", "30."});
constexpr std::string_view kLatheLetters = "XZUWIKRQPDFHEACS";

class RandomLatheProgram {
 public:
  explicit RandomLatheProgram(unsigned seed) : random_(seed) {}
  std::string text() {
    std::string all = "O1\nG21 F.2 S500 M3\n";
    for (int line = 0; line < 14; ++line) all += block() + "\n";
    return all +
           "M30\nN1 G0 X20.\nG1 Z-20.\nX30. Z-30. ,R1.\nZ-40.\nN2 X44.\nN3 G0 X10. Z0\nG1 X5. Z-5.\nN2 X44.\n"
           "O7\nG1 U1.\nM99\n";
  }

 private:
  template <class List>
  auto any(const List& list) {
    return list[std::uniform_int_distribution<std::size_t>(0, list.size() - 1)(random_)];
  }
  bool chance(int percent) { return std::uniform_int_distribution<int>(0, 99)(random_) < percent; }
  std::string block() {
    std::string out;
    for (int k = 0; k < 2; ++k)
      if (chance(70)) out += std::string(any(kLatheWords)) + " ";
    for (int k = 0; k < 6; ++k)
      if (chance(45)) out += any(kLatheLetters) + std::string(any(kLatheValues)) + " ";
    return out;
  }
  std::mt19937 random_;
};

TEST(FanucLatheProperty, RandomBlocksEnd) {
  for (unsigned seed = 1; seed <= 900; ++seed) {
    const std::string text = RandomLatheProgram(seed).text();
    ControlSettings settings = latheAt(50, 5,
                                       {{"flavour", seed % 2},
                                        {"decimal", seed % 3 == 0 ? 1 : 0},
                                        {"gcode_system", seed % 5 % 3},
                                        {"nose_radius.1", 0.8},
                                        {"tip.1", 3},
                                        {"offset_x.2", 12.5}});
    settings.max_errors = 20;
    settings.block_limit = 20000;
    const IsoRun run = lathe(text, settings);
    for (const Motion& m : run.path.motions) {
      ASSERT_TRUE(m.to.allFinite() && m.from.allFinite() && std::isfinite(m.feed) && std::isfinite(m.time_s))
          << "seed " << seed << "\n"
          << text;
    }
  }
}

}  // namespace
}  // namespace proveout::test
