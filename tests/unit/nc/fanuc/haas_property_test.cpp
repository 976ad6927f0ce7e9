// Random blocks of cycles, patterns, pockets and engraving: every run ends, and every path is finite.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

constexpr auto kCodes = std::to_array<const char*>(
    {"G0",  "G1",  "G2",  "G3",  "G12", "G13", "G16",  "G15",  "G17",  "G18",  "G28",  "G40",  "G41",
     "G42", "G47", "G49", "G52", "G53", "G54", "G68",  "G69",  "G51",  "G50",  "G70",  "G71",  "G72",
     "G73", "G74", "G76", "G77", "G80", "G81", "G82",  "G83",  "G84",  "G85",  "G86",  "G87",  "G88",
     "G89", "G90", "G91", "G92", "G98", "G99", "G100", "G101", "G110", "G141", "G150", "G154", "G187",
     "M29", "M97", "M98", "M3",  "M5",  "G4",  "G103", "G43",  "G20",  "G21"});
constexpr auto kValues =
    std::to_array<const char*>({"0", "1", "-1", "2.", "0.001", "-5.5", "10", "100.", "1e9", "7", "-0",
                                "99999999", "0.0000001", "#1", "[1/3]", "-[2]", "45."});
constexpr std::string_view kLetters = "XYZIJKRQPLDFHESABN";

class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {}
  std::string text() {
    std::string all = "O1\nG21 G90 F100 S100\n";
    for (int line = 0; line < 12; ++line) all += block() + "\n";
    return all + "M30\nN1 G1 X5.\nY5.\nX-5.\nY-5.\nX5.\nM99\nO12\nG81 Z-1. R1.\nM99\n";
  }

 private:
  template <class List>
  auto any(const List& list) {
    return list[std::uniform_int_distribution<std::size_t>(0, list.size() - 1)(random_)];
  }
  std::string block() {
    std::string out;
    const auto chance = [&](int percent) {
      return std::uniform_int_distribution<int>(0, 99)(random_) < percent;
    };
    for (int k = 0; k < 2; ++k)
      if (chance(70)) out += std::string(any(kCodes)) + " ";
    for (int k = 0; k < 7; ++k)
      if (chance(60)) out += any(kLetters) + std::string(any(kValues)) + " ";
    if (chance(10)) out += "(AB 12)";
    return out;
  }
  std::mt19937 random_;
};

/// Both flavours, and the same with words in increments.
TEST(HaasProperty, RandomBlocksEnd) {
  for (unsigned seed = 1; seed <= 600; ++seed) {
    const std::string text = RandomProgram(seed).text();
    ControlSettings settings = runAtZero({{"flavour", seed % 2}, {"decimal", seed % 3 == 0 ? 1 : 0}});
    settings.max_errors = 20;
    settings.block_limit = 20000;
    settings.radius_offsets[1] = {1.5, 0.0};
    const IsoRun run(ControlId::kFanucMill, text, settings);
    for (const Motion& m : run.path.motions) ASSERT_TRUE(m.to.allFinite()) << text;
  }
}

}  // namespace
}  // namespace proveout::test
