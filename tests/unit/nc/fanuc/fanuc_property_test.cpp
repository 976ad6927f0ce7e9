// Random blocks and random texts of Fanuc-like mills: every run ends, and every path is finite.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

constexpr auto kFanucCodes = std::to_array<const char*>(
    {"G0",  "G1",  "G2",    "G3",    "G02.2", "G03.2", "G02.4", "G03.4", "G06.2", "G4",  "G5",  "G05.1",
     "G8",  "G9",  "G10.6", "G12.1", "G13.1", "G07.1", "G17",   "G18",   "G19",   "G20", "G21", "G22",
     "G23", "G27", "G28",   "G29",   "G30",   "G31",   "G33",   "G40",   "G41",   "G42", "G43", "G49",
     "G52", "G53", "G54",   "G60",   "G61",   "G64",   "G68",   "G69",   "G80",   "G81", "G90", "G91",
     "G92", "G93", "G94",   "G95",   "G96",   "G97",   "M3",    "M5",    "M6",    "M77", "M8"});
constexpr auto kFanucValues = std::to_array<const char*>(
    {"0",  "1",        "-1", "2.", "0.001", "-5.5", "10",  "100.",         "999999.", "7", "-0",
     ".5", "99999999", "#1", "#2", "[1/3]", "-[2]", "45.", "[1/0.000001]", "-",       ""});
constexpr std::string_view kFanucLetters = "XYZIJKRQPLDFHSACN";

class FanucRandom {
 public:
  explicit FanucRandom(unsigned seed) : random_(seed) {}
  std::string program() {
    std::string all = "O1\nG21 G90 F100 S100\n#2=3.5\n";
    for (int line = 0; line < 14; ++line) all += block() + (chance(20) ? "; " + block() : "") + "\n";
    return all + "M30\n";
  }
  /// Characters that programs are made of, in any order.
  std::string noise() {
    constexpr std::string_view kSigns = "GXYZM01 9.-+#[]()/;:,%<>=ONEIF\n\nWHILEDO$";
    std::string all = "O1\n";
    for (int k = 0; k < 120; ++k)
      all += kSigns[std::uniform_int_distribution<std::size_t>(0, kSigns.size() - 1)(random_)];
    return all + "\nM30\n";
  }

 private:
  bool chance(int percent) { return std::uniform_int_distribution<int>(0, 99)(random_) < percent; }
  template <class List>
  auto any(const List& list) {
    return list[std::uniform_int_distribution<std::size_t>(0, list.size() - 1)(random_)];
  }
  std::string block() {
    std::string out = chance(5) ? "/2" : "";
    if (chance(80)) out += std::string(any(kFanucCodes)) + " ";
    if (chance(20)) out += std::string(any(kFanucCodes)) + " ";
    for (int k = 0; k < 5; ++k)
      if (chance(50)) out += any(kFanucLetters) + std::string(any(kFanucValues)) + " ";
    if (chance(10)) out += chance(50) ? ",R2." : ",C1.";
    return out;
  }
  std::mt19937 random_;
};

ControlSettings randomSettings(unsigned seed) {
  ControlSettings settings = runAtZero({{"decimal", seed % 3 == 0 ? 1.0 : 0.0}, {"flavour", seed % 2}});
  settings.max_errors = 30;
  settings.block_limit = 20000;
  settings.radius_offsets[1] = {1.5, 0.0};
  AxisSettings c;
  c.name = "C";
  settings.axes.push_back(c);
  if (seed % 5 == 0) settings.reference_points[0] = Vec3(300.0, 200.0, 100.0);
  return settings;
}

TEST(FanucProperty, RandomBlocksEnd) {
  for (unsigned seed = 1; seed <= 600; ++seed) {
    const std::string text = FanucRandom(seed).program();
    const IsoRun run(ControlId::kFanucMill, text, randomSettings(seed));
    for (const Motion& m : run.path.motions) ASSERT_TRUE(m.to.allFinite()) << text;
  }
}

TEST(FanucProperty, RandomTextEnds) {
  for (unsigned seed = 1; seed <= 600; ++seed) {
    const std::string text = FanucRandom(seed).noise();
    const IsoRun run(ControlId::kFanucMill, text, randomSettings(seed));
    for (const Motion& m : run.path.motions) ASSERT_TRUE(m.to.allFinite()) << text;
  }
}

}  // namespace
}  // namespace proveout::test
