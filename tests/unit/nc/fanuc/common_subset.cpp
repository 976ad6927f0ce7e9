#include "tests/unit/nc/fanuc/common_subset.h"

#include <array>
#include <cstdint>
#include <random>

namespace proveout::test {
namespace {

class Writer {
 public:
  explicit Writer(unsigned number) : random_(number) {}

  CommonProgram program() {
    both("G21 G90 G17 G40 G49 G80 G94");
    both("T1 M6");
    both("S500 M3");
    both("G54 G0 X0 Y0 Z0");
    both("G43 H1 Z30.");
    both("F100.");
    const int parts = 4 + below(5);
    for (int k = 0; k < parts; ++k) part();
    each("M30", "M2");
    text_.fanuc = "O1\n" + text_.fanuc;
    return text_;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(int percent) { return below(100) < percent; }
  /// From -most to most: mm with three decimals, inches with four.
  std::string place(int most = 40) {
    const int steps = inch_ ? 10000 : 1000, range = inch_ ? most / 25 + 1 : most;
    const int value = below(2 * range * steps + 1) - range * steps;
    return fmt::format("{:.{}f}", static_cast<double>(value) / steps, inch_ ? 4 : 3);
  }
  std::string axes(const std::string& letters) {
    std::string words;
    for (const char letter : letters) {
      if (chance(60)) words += fmt::format(" {}{}", letter, place());
    }
    return words.empty() ? fmt::format(" {}{}", letters[0], place()) : words;
  }
  void both(const std::string& line) { each(line, line); }
  void each(const std::string& fanuc, const std::string& linuxcnc) {
    text_.fanuc += fanuc + "\n";
    text_.linuxcnc += linuxcnc + "\n";
  }

  void part() {
    switch (below(9)) {
      case 0:
      case 1:
        return lines();
      case 2:
      case 3:
        return arcs();
      case 4:
        return frames();
      case 5:
        return shift();
      case 6:
        return holes();
      case 7:
        return formulas();
      default:
        return units();
    }
  }

  void lines() {
    const bool steps = chance(30);
    if (steps) both("G91");
    for (int k = 0; k < 4; ++k) both((chance(35) ? "G0" : "G1") + axes("XYZ"));
    if (steps) both("G90");
  }

  /// Arcs from one corner of a grid about the centre to another one: exact in three decimals.
  void arcs() {
    if (inch_) return lines();
    constexpr std::array<std::array<int, 2>, 12> kOnCircle{{{5, 0},
                                                            {4, 3},
                                                            {3, 4},
                                                            {0, 5},
                                                            {-3, 4},
                                                            {-4, 3},
                                                            {-5, 0},
                                                            {-4, -3},
                                                            {-3, -4},
                                                            {0, -5},
                                                            {3, -4},
                                                            {4, -3}}};
    const int plane = below(3);
    const char* const letters = plane == 0 ? "XYIJZ" : plane == 1 ? "ZXKIY" : "YZJKX";
    both(fmt::format("G{} G91", 17 + plane));
    const int size = 1 + below(4);
    for (int k = 0; k < 3; ++k) {
      const auto& a = kOnCircle[static_cast<std::size_t>(below(12))];
      const auto& b = kOnCircle[static_cast<std::size_t>(below(12))];
      const auto word = [&](int which, int value) {
        return fmt::format(" {}{}.", letters[which], size * value);
      };
      std::string line = fmt::format("G{}", 2 + below(2));
      const bool full = a == b;
      if (!full) line += word(0, b[0] - a[0]) + word(1, b[1] - a[1]);
      const bool half = a[0] == -b[0] && a[1] == -b[1];
      if (!full && !half && chance(40)) {
        line += fmt::format(" R{}{}.", chance(30) ? "-" : "", 5 * size);
      } else {
        line += word(2, -a[0]) + word(3, -a[1]);
      }
      if (chance(30)) line += fmt::format(" {}{}", letters[4], place(9));
      both(line);
    }
    both("G90 G17");
  }

  void frames() {
    const int frame = 2 + below(5);
    both(fmt::format("G10 L2 P{}{}", frame, axes("XYZ")));
    both(fmt::format("G{}", 53 + frame));
    both("G1" + axes("XYZ"));
    // Without an INI file the interpreter has the length of the tool in other units behind G20.
    if (!inch_ && chance(50)) both("G53 G0" + axes("XYZ"));
    both("G0" + axes("XYZ"));
    both("G54");
    both(fmt::format("G0 X{} Y{} Z{}", place(), place(), place()));
  }

  void shift() {
    both("G92" + axes("XYZ"));
    lines();
    each("G92.1 X0 Y0 Z0", "G92.1");
    both(fmt::format("G0 X{} Y{} Z{}", place(), place(), place()));
  }

  void holes() {
    if (inch_) return lines();
    both("G49");
    both("G43 H1");
    both(fmt::format("G0 X{} Y{} Z{}.", place(), place(), 50 + below(9)));
    constexpr std::array<int, 6> kCycles{81, 82, 83, 85, 89, 73};
    const int cycle = kCycles[static_cast<std::size_t>(below(6))];
    const bool dwells = cycle == 82 || cycle == 89, pecks = cycle == 83 || cycle == 73;
    const int level = 3 + below(40);  // LinuxCNC goes up to a level above the tool before it goes across
    const bool feeds_out = cycle == 85 || cycle == 89;  // by G98 LinuxCNC feeds up to the start level
    const bool to_start = !feeds_out && chance(60);
    const std::string words = fmt::format("G{} G{} X{} Y{} Z-{}. R{}.{}", to_start ? 98 : 99, cycle, place(),
                                          place(), 5 + below(9), level, pecks ? " Q4." : "");
    each(words + (dwells ? " P500" : ""), words + (dwells ? " P0.5" : ""));
    both(axes("XY").substr(1));
    both(fmt::format("R{}.", 1 + below(level)) + axes("XY"));
    // Behind G99 LinuxCNC counts R from where the tool stands, Fanuc-like controls from the start level.
    if (to_start) each("G91 X3. Y1. Z-2. R-1. K3", "G91 X3. Y1. Z-2. R-1. L3");
    both("G90 G80");
    both(fmt::format("G0 Z{}.", 50 + below(9)));
  }

  void formulas() {
    both(fmt::format("#1={}", place(9)));
    both(fmt::format("#2=[[#1*2.5-[{}]]/[{}+ABS[#1]]]", place(9), 1 + below(5)));
    both("#3=[SIN[30+#1]*8+COS[#2]*3-SQRT[ABS[#1]+4]]");
    both("#4=[ATAN[ABS[#2]+1]/[2]+FIX[ABS[#3]]-FUP[ABS[#2]]+ROUND[#1]]");
    // Fanuc-like controls round words to their least increment.
    const int steps = inch_ ? 10000 : 1000;
    const auto rounded = [&](int variable, const std::string& value) {
      both(fmt::format("#{}=[ROUND[{}*{}]/{}]", variable, value, steps, steps));
    };
    rounded(5, "[#3+#1]");
    rounded(6, "#2");
    rounded(7, "[#4/20]");
    both("G1 X#5 Y#6");
    both("G1 Z#7 X-#6");
  }

  void units() {
    inch_ = !inch_;
    both(inch_ ? "G20" : "G21");
    both(inch_ ? "F8." : "F200.");
    both("G1" + axes("XYZ"));
  }

  std::mt19937 random_;
  bool inch_ = false;
  CommonProgram text_;
};

}  // namespace

CommonProgram commonProgram(unsigned number) { return Writer(number).program(); }

ControlSettings commonSettings(ControlId control) {
  ControlSettings settings = runAtZero();
  settings.length_offsets[1] = {50.0, 0.0};
  if (control != ControlId::kFanucMill) return settings;
  for (const char* name : {"g73_retract", "g83_clearance"}) settings.parameters[name] = 0.254;
  settings.work_given[0] = true;  // machine zero is where the program counts from
  return settings;
}

}  // namespace proveout::test
