#include "tests/peer/programs.h"

#include <fmt/core.h>

#include <cmath>
#include <random>
#include <sstream>

namespace proveout::peer {
namespace {

using Lines = std::vector<std::string>;

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}
  Lines program() {
    lines_ = {"G21 G90 F100", "G0 X0 Y0 Z0"};
    switch (upTo(5)) {
      case 0:
        motions();
        break;
      case 1:
        frames();
        break;
      case 2:
        cycles();
        break;
      case 3:
        compensation();
        break;
      case 4:
        mixture();
        break;
      default:
        threads();
    }
    lines_.push_back("M2");
    return singleLines();
  }

 private:
  Lines singleLines() const {
    Lines all;
    for (const std::string& entry : lines_) {
      std::istringstream in(entry);
      for (std::string line; std::getline(in, line);) all.push_back(line);
    }
    return all;
  }
  /// The module does not know where it is behind a tool change.
  std::string toolChange() {
    return fmt::format("T{} M6\nG90 G0 {} {} {}\nS200 M3", 1 + upTo(1), word('X'), word('Y'), word('Z'));
  }
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < p; }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::string number(double low, double high) { return fmt::format("{:.{}f}", real(low, high), upTo(3)); }
  std::string word(char letter, double low = -30.0, double high = 30.0) { return letter + number(low, high); }
  std::string one(const Lines& of) {
    return of[static_cast<std::size_t>(upTo(static_cast<int>(of.size()) - 1))];
  }
  std::string axes(const std::string& letters, double p = 0.6) {
    std::string text;
    for (const char a : letters)
      if (chance(p)) text += word(a) + ' ';
    return text.empty() ? word(letters[0]) : text;
  }
  std::string straight() { return one({"G0 ", "G1 ", "G1 ", ""}) + axes("XYZ"); }

  void arc(int plane, bool turns) {
    const char* const letters = plane == 17 ? "XYIJZ" : plane == 18 ? "ZXKIY" : "YZJKX";
    const double radius = real(1.0, 20.0), from = real(0.0, 6.28), to = real(0.0, 6.28);
    const double i = -radius * std::cos(from), j = -radius * std::sin(from);
    std::string line = fmt::format("G{} G91 G{} {}{:.9f} {}{:.9f} {}{:.9f} {}{:.9f}", plane, 2 + upTo(1),
                                   letters[0], radius * std::cos(to) + i, letters[1],
                                   radius * std::sin(to) + j, letters[2], i, letters[3], j);
    if (chance(0.3)) line += ' ' + word(letters[4], -5.0, 5.0);
    if (turns && chance(0.3)) line += fmt::format(" P{}", 1 + upTo(2));
    lines_.push_back(line);
    lines_.push_back("G90");
  }

  void motions() {
    for (int k = 0; k < 12; ++k) {
      if (chance(0.4)) {
        lines_.push_back(straight());
      } else if (chance(0.3)) {
        lines_.push_back(fmt::format("G{} {} R{}", 2 + upTo(1), axes("XYZ"), number(-60, 60)));
      } else if (chance(0.6)) {
        arc(17 + upTo(2), true);
      } else {
        lines_.push_back(one({"G90", "G91", "G17", "G18", "G19", "G94 F100", "G80", "F150", "G90.1", "G91.1",
                              "G7", "G8", "G61", "G64 P.1", "G4 P.2", "G93", "G95 F1", "S200 M3"}));
      }
    }
  }

  std::string frame() {
    switch (upTo(8)) {
      case 0:
        return fmt::format("G10 L2 P{} {}{}", upTo(9), axes("XYZ", 0.5),
                           chance(0.5) ? " R" + number(-90, 90) : "");
      case 1:
        return fmt::format("G10 L20 P{} {}", upTo(9), axes("XYZ", 0.5));
      case 2:
        return one({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"});
      case 3:
        return one({"G92 ", "G52 "}) + axes("XYZ", 0.5);
      case 4:
        return one({"G92.1", "G92.2", "G92.3", "G28.1", "G30.1"});
      case 5:
        return one({"G28", "G30", "G28 " + axes("XYZ"), "G30 " + axes("XYZ")});
      case 6:
        return one({toolChange(), toolChange(), "G43", "G43 H1", "G43 H2", "G43.1 " + axes("XYZ"), "G43.2 H1",
                    "G49"});
      case 7:
        return fmt::format("G53 G{} {}", upTo(1), axes("XYZ"));
      default:
        return fmt::format("G10 L{} P{} Z{}", one({"1", "10", "11"}), 1 + upTo(1), number(-20, 20));
    }
  }
  void frames() {
    for (int k = 0; k < 14; ++k)
      lines_.push_back(chance(0.45)   ? straight()
                       : chance(0.85) ? frame()
                                      : one({"G90", "G91", "F100", "G17"}));
  }

  /// Everything beside everything: what a line leaves behind meets all others.
  void mixture() {
    lines_.push_back("S200 M3");
    for (int k = 0; k < 20; ++k) {
      if (chance(0.3)) {
        lines_.push_back(straight());
      } else if (chance(0.25)) {
        arc(17 + upTo(2), true);
      } else if (chance(0.3)) {
        lines_.push_back(frame());
      } else if (chance(0.3)) {
        lines_.push_back(cycle());
      } else {
        lines_.push_back(
            one({"G90",       "G91",       "G17",        "G18",          "G19",    "G80",    "G98",
                 "G99",       "G20",       "G21",        "G94 F100",     "G93",    "G95 F1", "M3",
                 "M5",        "G7",        "G8",         "G90.1",        "G91.1",  "M70",    "M72",
                 "G0 G53 Z0", axes("XYZ"), "G33 Z-5 K1", "G33.1 Z-5 K1", "G52 X1", "G92.1"}));
      }
    }
  }

  std::string cycle() {
    const int code = std::stoi(one({"73", "74", "81", "82", "83", "84", "85", "86", "87", "89"}));
    std::string line =
        fmt::format("G{} {} {} {}", code, axes("XY", 0.7), word('Z', -20, 2), word('R', -3, 12));
    if (code == 73 || code == 83) line += " Q" + number(1, 8);
    if (code == 82 || code == 86 || code == 89) line += " P" + number(0, 2);
    if (code == 87) line += fmt::format(" I{} J{} K{}", number(-2, 2), number(-2, 2), number(-3, 3));
    if (chance(0.2)) line += fmt::format(" L{}", 1 + upTo(2));
    return line;
  }
  void cycles() {
    lines_.push_back(one({"S200 M3", "S200 M3", "S200 M4"}));
    lines_.push_back("G0 Z10");
    for (int k = 0; k < 10; ++k) {
      if (chance(0.5)) {
        lines_.push_back(cycle());
      } else if (chance(0.5)) {
        lines_.push_back(axes("XY") + one({"", "", "R" + number(0, 12), "Z" + number(-9, 0)}));
      } else {
        lines_.push_back(chance(0.4) ? straight()
                                     : one({"G98", "G99", "G90", "G91", "G80", "M3", "M4", "F80"}));
      }
    }
  }

  void compensation() {
    const bool lathe_plane = chance(0.3);
    const std::string in_plane = lathe_plane ? "XZ" : "XY";
    lines_.push_back("G0 " + word('X', -40, -20) + ' ' + word(in_plane[1], -20, 20));
    if (lathe_plane) lines_.push_back("G18");
    lines_.push_back(fmt::format("{}.1 D{} G1 X0 {}0", one({"G41", "G42"}), number(0.5, 8), in_plane[1]));
    for (int k = 0; k < 8; ++k) {
      if (chance(0.6)) {
        lines_.push_back(one({"", "G1 ", "G1 ", "G0 "}) + axes(in_plane, 0.7));
      } else if (chance(0.75)) {
        arc(lathe_plane ? 18 : 17, false);
      } else {
        lines_.push_back(one({lathe_plane ? word('Y') : word('Z'), "G4 P.1", "G91", "G90", "M8", "F50"}));
      }
    }
    lines_.push_back(one({"G90 G40 G1 X-60", "G90 G40 G0 X-60", "G40\nG91 G1 X3"}));
  }

  void threads() {
    lines_.push_back(one({"G18 G8 S100 M3", "G18 G7 S100 M3"}));
    lines_.push_back("G0 " + word('X', 10, 30) + ' ' + word('Z', -3, 5));
    for (int k = 0; k < 3; ++k) {
      std::string line = fmt::format("G76 P{} Z{} I{} J{} K{}", number(0.5, 3), number(-30, 5), number(-4, 4),
                                     number(0.1, 1), number(0.5, 2));
      if (chance(0.4)) line += " R" + number(0.5, 3);
      if (chance(0.5)) line += " Q" + number(0, 60);
      if (chance(0.3)) line += fmt::format(" H{}", upTo(2));
      if (chance(0.5)) line += fmt::format(" E{} L{}", number(0, 4), upTo(3));
      lines_.push_back(line);
      lines_.push_back(one({"G90", "G91", "G90 G0 X20 Z2"}));
    }
  }

  std::mt19937_64 random_;
  Lines lines_;
};

}  // namespace

Lines randomProgram(std::uint64_t seed) { return Writer(seed).program(); }

}  // namespace proveout::peer
