// Random macro programs: they end, whatever they say, and their paths are finite.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

class RandomMacroProgram {
 public:
  explicit RandomMacroProgram(unsigned seed) : random_(seed) {}
  std::string text() {
    std::string out = "O1\nG21 G90\nG1 F500\n";
    lines(out, 25);
    out += "M30\n";
    for (int sub = 2; sub <= 4; ++sub) {
      out += fmt::format("O{}\n", sub);
      lines(out, 8);
      out += pick(6) == 0 ? "" : pick(4) == 0 ? fmt::format("M99 P{}\n", pick(9)) : "M99\n";
    }
    return out;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string variable() {
    static constexpr int kNumbers[] = {0,    1,    2,     3,     33,     100,   149,  199,  500,
                                       999,  1000, 1100,  2001,  2201,   3001,  3003, 3011, 3901,
                                       4001, 4109, 4120,  5001,  5021,   5041,  5063, 5201, 5221,
                                       7001, 99,   10001, 13001, 900000, 100001};
    return pick(6) == 0 ? fmt::format("#[#{}+{}]", 1 + pick(3), pick(200))
                        : fmt::format("#{}", kNumbers[pick(33)]);
  }
  std::string value() {
    switch (pick(7)) {
      case 0:
        return variable();
      case 1:
        return fmt::format("[{}+{}]", variable(), pick(10));
      case 2:
        return fmt::format("ROUND[{}/{}]", variable(), pick(4));
      case 3:
        return fmt::format("ATAN[{}]/[{}]", pick(5) - 2, pick(5) - 2);
      case 4:
        return fmt::format("SQRT[{}]", pick(20) - 2);
      default:
        return fmt::format("{}", (pick(200) - 100) / 4.0);
    }
  }
  std::string condition() {
    static constexpr const char* kRelations[] = {"EQ", "NE", "GT", "GE", "LT", "LE"};
    std::string one = fmt::format("{} {} {}", variable(), kRelations[pick(6)], value());
    if (pick(4) == 0)
      one = fmt::format("[{}] {} [{} LT {}]", one, pick(2) ? "AND" : "OR", variable(), pick(9));
    return one;
  }
  void lines(std::string& out, int count) {
    for (int k = 0; k < count; ++k) out += line() + "\n";
  }
  std::string line() {
    const std::string number = pick(4) == 0 ? fmt::format("N{} ", pick(9)) : "";
    switch (pick(16)) {
      case 0:
        return number + fmt::format("IF[{}]GOTO{}", condition(), pick(10));
      case 1:
        return number + fmt::format("IF[{}]THEN {}={}", condition(), variable(), value());
      case 2:
        return number + fmt::format("WHILE[{}]DO{}", condition(), 1 + pick(4));
      case 3:
        return number + fmt::format("END{}", 1 + pick(3));
      case 4:
        return number + fmt::format("GOTO{}", pick(10));
      case 5:
        return number + fmt::format("M98 P{}", pick(2) ? 2 + pick(4) : 20002 + pick(3));
      case 6:
        return number + fmt::format("G65 P{} A{} I{} J{}", 2 + pick(3), pick(9), pick(9), pick(9));
      case 7:
        return number + (pick(2) ? fmt::format("G66 P{} A{}", 2 + pick(3), pick(5)) : "G67");
      case 8:
        return number + fmt::format("DPRNT[X{}[{}]]", variable(), pick(99));
      case 9:
        return number + fmt::format("G0 X{} Y{}", variable(), value());
      case 10:
        return number + fmt::format("G1 X#{} Z-#{}", 1 + pick(3), 1 + pick(3));
      case 11:
        return number + fmt::format("G91 G1 X{} F100", pick(5));
      default:
        return number + fmt::format("{}={}", pick(5) ? fmt::format("#{}", 1 + pick(4)) : variable(), value());
    }
  }
  std::mt19937 random_;
};

TEST(FanucPrograms, RandomMacroProgramsEnd) {
  int good = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const std::string text = RandomMacroProgram(seed).text();
    ControlSettings settings = runAtZero({{"unknown_variables", seed % 2 ? 1.0 : 0.0}});
    settings.block_limit = 3000;
    settings.max_errors = 1 + static_cast<int>(seed % 5);
    const IsoRun run(ControlId::kFanucMill, text, settings);
    good += run.summary.ok();
    for (const Motion& m : run.path.motions) ASSERT_TRUE(m.to.allFinite()) << text;
    for (const Diagnostic& d : run.path.diagnostics.all()) ASSERT_FALSE(d.message.empty()) << text;
  }
  EXPECT_GT(good, 0);
}

/// A grid of moves by loops, by a subprogram with repetitions and by a macro for each row, and written out.
TEST(FanucPrograms, LoopsAndCallsAreTheBlocksThatTheyStandFor) {
  std::mt19937 random(11);
  for (int round = 0; round < 30; ++round) {
    const int rows = 1 + static_cast<int>(random() % 5), columns = 1 + static_cast<int>(random() % 6);
    const std::string head = "O1\nG90 G0 X0 Y0 Z10.\nG91 G1 F500\n", tail = "G90 G0 Z50.\nM30\n";
    std::string plain = head;
    for (int r = 0; r < rows; ++r) {
      for (int k = 0; k < columns; ++k) plain += "X2.5 Z-0.5\n";
      plain += "Y3.\n";
    }
    plain += tail;
    const std::string loops =
        head +
        fmt::format(
            "#1=0\nWHILE[#1LT{}]DO1\n#2={}\nDO2\nIF[#2LE0]GOTO10\nX[5/2] Z-[1/2]\n#2=#2-1\nEND2\nN10 Y3.\n"
            "#1=#1+1\nEND1\n",
            rows, columns) +
        tail;
    const std::string subs = head + fmt::format("M98 P{}0002\n", rows) + tail + "O2\n" +
                             fmt::format("M98 P{}0003\nY3.\nM99\nO3\nX2.5 Z-.5\nM99\n", columns);
    const std::string macros = head + fmt::format("G65 P4 L{} K{}\n", rows, columns) + tail +
                               "O4\nWHILE[#6GT0]DO3\nX2.5 Z-.5\n#6=#6-1\nEND3\nY3.\nM99\n";
    const std::vector<std::string> expected = IsoRun(ControlId::kFanucMill, plain).motions();
    for (const std::string& text : {loops, subs, macros}) {
      const IsoRun run(ControlId::kFanucMill, text);
      ASSERT_EQ(run.error(), "") << text << run.message();
      ASSERT_EQ(run.motions(), expected) << text;
    }
  }
}

}  // namespace
}  // namespace proveout::test
