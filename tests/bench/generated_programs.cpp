#include "tests/bench/generated_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace proveout::bench {

namespace {

constexpr double kSide = 200.0;

double surfaceHeight(double x, double y) {
  return -8.0 + 3.0 * std::sin(x / 23.0) * std::cos(y / 31.0) + 1.5 * std::sin((x + 2.0 * y) / 17.0);
}

/// `text` without what goes from `first` up to `next`.
std::string without(const std::string& text, const std::string& first, const std::string& next) {
  const std::size_t from = text.find(first), to = text.find(next, from);
  if (from == std::string::npos || to == std::string::npos)
    throw std::runtime_error("the sample shaft has no '" + first + "' before '" + next + "'");
  return text.substr(0, from) + text.substr(to);
}

/// Volume of a cone's frustum, mm3.
double frustum(double length, double r0, double r1) {
  return std::numbers::pi / 3.0 * length * (r0 * r0 + r0 * r1 + r1 * r1);
}

/// Volume inside a quarter of a circle of radius `rho` round (c, z) in the half section, over its own length:
/// `side` 1 where the circle bulges out of the material, -1 where it is hollow. By Pappus' rule, mm3.
double quarter(double c, double rho, double side) {
  const double pi = std::numbers::pi;
  return pi * rho * (c * c + side * c * pi * rho / 2.0 + 2.0 / 3.0 * rho * rho);
}

}  // namespace

namespace {

/// Corner `k` of the gear's contour, to micrometres as in the program.
std::pair<double, double> gearCorner(int k, int blocks, double depth) {
  constexpr double kRadius = 50.0, kTeeth = 40.0;
  const double turn = 2.0 * std::numbers::pi * k / blocks, r = kRadius + depth * std::sin(kTeeth * turn);
  const auto rounded = [](double v) { return std::round(1e3 * v) / 1e3; };
  return {rounded(r * std::sin(turn)), rounded(-r * std::cos(turn))};
}

}  // namespace

std::string gearProgram(int blocks, double depth, double lean_deg) {
  constexpr double kHeight = 60.0;
  const double out = kHeight * std::tan(lean_deg * std::numbers::pi / 180.0);
  std::string text = "H000=0;\nH001=150;\nT84T86;\nG92X0Y-40.;\nC001;\n";
  text += lean_deg > 0.0 ? "G74;\n" : "G42H001;\n";
  for (int k = 0; k <= blocks; ++k) {
    const auto [x, y] = gearCorner(k, blocks, depth);
    fmt::format_to(std::back_inserter(text), "G01X{:.3f}Y{:.3f}", x, y);
    const double turn = 2.0 * std::numbers::pi * k / blocks;
    if (lean_deg > 0.0)
      fmt::format_to(std::back_inserter(text), "U{:.3f}V{:.3f}", out * std::sin(turn), -out * std::cos(turn));
    text += ";\n";
  }
  return text + (lean_deg > 0.0 ? "G75;\nM02;\n" : "G40H000X0Y-40.;\nM02;\n");
}

/// Teeth of two straight flanks, sharp, with a taper: their corners run along the walls.
std::string starProgram(int teeth, double depth, double taper_deg) {
  std::string text =
      fmt::format("H000=0;\nH001=150;\nT84T86;\nG92X0Y-40.;\nC001;\nG42H001G52A{:g};\n", taper_deg);
  for (int k = 0; k <= 2 * teeth; ++k) {
    const double turn = std::numbers::pi * k / teeth, r = 48.0 + (k % 2 == 0 ? depth : 0.0);
    fmt::format_to(std::back_inserter(text), "G01X{:.3f}Y{:.3f};\n", r * std::sin(turn), -r * std::cos(turn));
  }
  return text + "G40H000G50A0X0Y-40.;\nM02;\n";
}

std::string gearJob(const std::string& program_file) {
  return fmt::format(
      "schema = \"proveout.job/1\"\nname = \"gear\"\ncontrol = \"wedm\"\nprogram = \"{}\"\n[stock]\n"
      "shape = \"box\"\nmin = [-60, -60, 0]\nmax = [60, 60, 60]\nstart_hole = [{{ at = [0, -40], diameter = "
      "3 }}]\n[[tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.25\nspark_gap = 0.025\n",
      program_file);
}

std::string shortLinesProgram() {
  std::string text = "%A\nG54 G90 G95\nT1 M6\nG97 S1200 M3\nG0 X60 Z2\nX40\nG1 Z0 F0.1\n";
  for (int i = 1; i <= 20000; ++i) fmt::format_to(std::back_inserter(text), "G1 X40 Z-{:.4f}\n", 0.005 * i);
  return text + "G1 X52\nG0 X60 Z10\nM5\nM2\n%\n";
}

std::string longThreadProgram() {
  return "%T\nG54 G90 G95\nT1 M6\nG97 S600 M3\nG0 X30 Z8\nX18.8\nG33 Z-392 F1\nG0 X60\nZ20\nM5\nM2\n%\n";
}

std::string manyPassesProgram() {
  return "%T\nG54 G90 G95\nT1 M6\nG97 S600 M3\nG0 X30 Z8\n"
         "G31 X20 Z-28 F2.5 #1=1.5 #2=0.055 #3=0 #4=29 #5=0\nG0 X60 Z20\nM5\nM2\n%\n";
}

namespace {

std::string turningJob(const std::string& program_file, int diameter, int length, const std::string& insert) {
  return fmt::format(
      "schema = \"proveout.job/1\"\nprogram = \"{}\"\ncontrol = \"wl4-lathe\"\n[stock]\nshape = "
      "\"cylinder\"\nbase = [0, 0, {}]\ndiameter = {}\nlength = {}\n[[tool]]\nnumber = 1\ntype = "
      "\"insert\"\n{}",
      program_file, -length, diameter, length, insert);
}

}  // namespace

std::string shortLinesJob(const std::string& program_file) {
  return turningJob(
      program_file, 50, 130,
      "nose_radius = 0.4\norientation = 3\ninsert_angle = 55\nlead_angle = 93\nedge_length = 11\n");
}

std::string threadJob(const std::string& program_file, int length_mm) {
  return turningJob(
      program_file, 20, length_mm,
      "shape = \"thread\"\ninsert_angle = 60\ntip_flat = 0.1\norientation = 8\nedge_length = 2.2\n");
}

std::string wormProgram() {
  return "T1M06D1\nS100M03\nG99F0.2\nG90G00X30Z20\nG30A34X40Z60R3Q1F40H0.32P0.15U60L12K4\nG81X100Z100\nM02\n";
}

std::string wormJob(const std::string& program_file) {
  return fmt::format(
      "schema = \"proveout.job/1\"\nprogram = \"{}\"\ncontrol = \"flexnc\"\n[stock]\nshape = \"cylinder\"\n"
      "base = [0, 0, -80]\ndiameter = 40\nlength = 80\n[[tool]]\nnumber = 1\ntype = \"insert\"\n"
      "shape = \"round\"\nnose_radius = 1\norientation = 8\n[output]\nviews = [\"iso\"]\n",
      program_file);
}

std::string slotProgram() {
  return "T1M6\nG21G90G17G94\nS8000M3\nG0X-10Y25Z5\nG0Z-5\nG1X110F800\nG0Z5\nM30\n";
}

std::string pocketProgram() {
  std::string text = "T1M6\nG21G90G17G94\nS8000M3\nG0X10Y10Z5\nG1Z-5F200\n";
  for (int i = 0; i <= 5; ++i) {  // tool centres fill 10..40 x 10..30
    text += fmt::format("G1Y{}F800\nX{}\n", 10 + 4 * i, i % 2 == 0 ? 40 : 10);
  }
  return text + "Y10\nX40\nY30\nX10\nY10\nG0Z5\nM30\n";
}

std::string finishingProgram(int lines, int moves_a_line) {
  std::string text = "T1M6\nG21G90G17G94\nS18000M3\n";
  text.reserve(static_cast<std::size_t>(lines) * static_cast<std::size_t>(moves_a_line) * 22);
  text += fmt::format("G0X0Y0Z20\nG1Z{:.4f}F3000\n", surfaceHeight(0, 0));
  for (int line = 0; line < lines; ++line) {
    const double y = kSide * line / (lines - 1);
    const bool back = line % 2 == 1;
    const double start = back ? kSide : 0.0;
    if (line > 0) text += fmt::format("Y{:.4f}Z{:.4f}\n", y, surfaceHeight(start, y));
    for (int i = 1; i <= moves_a_line; ++i) {
      const double along = kSide * i / moves_a_line, x = back ? kSide - along : along;
      fmt::format_to(std::back_inserter(text), "X{:.4f}Z{:.4f}\n", x, surfaceHeight(x, y));
    }
  }
  return text + "G0Z20\nM30\n";
}

std::string fiveAxisFinishing(int lines, int moves_a_line, FinishingAxis axis) {
  constexpr double kWide = 100.0, kLeast = 5.0, kMost = 25.0;
  const auto height = [](double x, double y) { return -8.0 + 3.0 * std::sin(x / 12.0) * std::cos(y / 9.0); };
  int block = 0;
  const auto direction = [&]() -> std::string {
    if (axis == FinishingAxis::kUpright) return "";
    const bool turns = axis == FinishingAxis::kTurning;
    const double half = 0.5 * (kMost - kLeast);
    const double around = turns ? 2.0 * std::numbers::pi * block / 500.0 : 0.5;
    const double swing = turns ? half * std::sin(2.0 * std::numbers::pi * block / 731.0) : 0.0;
    const double lean = (kLeast + half + swing) * std::numbers::pi / 180.0;
    return fmt::format("I{:.6f}J{:.6f}K{:.6f}", std::sin(lean) * std::cos(around),
                       std::sin(lean) * std::sin(around), std::cos(lean));
  };
  std::string text = "T1M6\nG21G90G17G94\nS18000M3\nG54G0X0Y0Z100\n";
  text += axis == FinishingAxis::kUpright ? "G43H1X0Y0Z20\n" : "G43.5H1X0Y0Z20I0J0K1\n";
  text += fmt::format("G1Z{:.4f}F3000\n", height(0, 0));
  for (int line = 0; line < lines; ++line) {
    const double y = kWide * line / (lines - 1);
    for (int i = line == 0 ? 1 : 0; i <= moves_a_line; ++i) {
      const double along = kWide * i / moves_a_line, x = line % 2 == 1 ? kWide - along : along;
      ++block;
      fmt::format_to(std::back_inserter(text), "X{:.4f}Y{:.4f}Z{:.4f}{}\n", x, y, height(x, y), direction());
    }
  }
  return text + (axis == FinishingAxis::kUpright ? "G0Z100\nG49\nM30\n" : "G0Z20I0J0K1\nG49\nM30\n");
}

std::string fiveAxisJob(const std::string& program_file, const std::string& machine_file,
                        const std::string& tool) {
  return fmt::format(
      "schema = \"proveout.job/1\"\nprogram = \"{}\"\ncontrol = \"nct\"\n[machine]\nfile = \"{}\"\n[stock]\n"
      "shape = \"box\"\nmin = [0, 0, -20]\nmax = [100, 100, 0]\n[[tool]]\nnumber = 1\n{}\n"
      "flute_length = 30\noverall_length = 60\ngauge_length = 80\n[offsets.work]\n"
      "G54 = [0, 0, 0]\n[offsets.length]\n1 = 80.0\n",
      program_file, machine_file, tool);
}

std::string tiltedPocket(int layers) {
  constexpr double kMiddle = 25.0, kCorner = 3.0, kStep = 0.8;
  std::string text =
      "T1 M6\nG0 G54 G17 G90 G49 Z100\nX0 Y0\nB-15 C0\nM3 S1000\nG43.1 H1\n"
      "G68.1 X0 Y0 Z0 I0 J1 K0 R-15\n";
  for (int layer = 1; layer <= layers; ++layer) {
    fmt::format_to(std::back_inserter(text), "G0 X25 Y25\nZ30\nG1 Z{:.3f} F500\n", -kStep * layer);
    for (double half = 4.0; half <= 17.0; half += 3.0) {
      const double low = kMiddle - half, high = kMiddle + half;
      fmt::format_to(std::back_inserter(text), "G1 X{:.3f} Y{:.3f} F2000\n", high, low + kCorner);
      fmt::format_to(std::back_inserter(text), "Y{:.3f}\nG3 X{:.3f} Y{:.3f} R3\n", high - kCorner,
                     high - kCorner, high);
      fmt::format_to(std::back_inserter(text), "G1 X{:.3f}\nG3 X{:.3f} Y{:.3f} R3\n", low + kCorner, low,
                     high - kCorner);
      fmt::format_to(std::back_inserter(text), "G1 Y{:.3f}\nG3 X{:.3f} Y{:.3f} R3\n", low + kCorner,
                     low + kCorner, low);
      fmt::format_to(std::back_inserter(text), "G1 X{:.3f}\nG3 X{:.3f} Y{:.3f} R3\n", high - kCorner, high,
                     low + kCorner);
    }
    text += "G0 Z30\n";
  }
  return text + "G0 Z100\nG69.1\nG49\nG0 Z100\nM30\n";
}

std::string arcsProgram() {
  std::string text = "T1 M6\nS9000 M3\nG0 X20 Y5\nZ2\nG1 Z-2 F800\nG18\n";
  for (int i = 0; i < 80; ++i) {
    fmt::format_to(std::back_inserter(text), "G{} X{} Z-2 R40\nG1 Y{:.2f} Z-2.5\nZ-2\n", i % 2 == 0 ? 3 : 2,
                   i % 2 == 0 ? 60 : 20, 5.0 + 0.5 * (i + 1));
  }
  return text + "G17\nG0 Z50\nM30\n";
}

std::string reliefProgram() {
  constexpr int kLines = 53, kPoints = 40;
  constexpr double kFirst = 0.5, kLength = 19.0;
  const auto height = [](double x, double y) {
    return -1.5 + 0.8 * std::sin(0.7 * x) * std::cos(0.5 * y) + 0.3 * std::sin(2.1 * x + y);
  };
  std::string text = "G21 G90 G17\nT1 M6\nS10000 M3\nG0 Z5\n";
  for (const bool across : {false, true}) {
    for (int line = 0; line < kLines; ++line) {
      for (int i = 0; i < kPoints; ++i) {
        const int k = line % 2 == 0 ? i : kPoints - 1 - i;
        const double a = kFirst + kLength * line / (kLines - 1), b = kFirst + kLength * k / (kPoints - 1);
        const double x = across ? b : a, y = across ? a : b;
        if (line == 0 && i == 0) fmt::format_to(std::back_inserter(text), "G0 X{:.4f} Y{:.4f} Z5\n", x, y);
        fmt::format_to(std::back_inserter(text), "{}X{:.4f} Y{:.4f} Z{:.4f}{}\n", i == 0 ? "G1 " : "", x, y,
                       height(x, y), i == 0 ? " F500" : "");
      }
    }
    text += "G0 Z5\n";
  }
  return text + "M30\n";
}

std::string threadMillProgram() {
  return "T1 M6\nS4000 M3\nG0 X50 Y25\nZ-18\nG1 X51 F500\nG2 X51 Y25 I-1 J0 Z-16.5\nG1 X50\nG0 Z5\n"
         "G0 X20 Y25\nG0 Z-18\nG1 X26\nG3 X26 Y25 I-6 J0 Z-16.5\nG1 X27\nG3 X27 Y25 I-7 J0 Z-15\nG1 X28\n"
         "G3 X28 Y25 I-8 J0 Z-13.5\nG1 X20\nG0 Z50\nM30\n";
}

std::string threadMillJob(const std::string& program_file) {
  return fmt::format(
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"{}\"\n[stock]\nshape = \"box\"\n"
      "min = [0, 0, -20]\nmax = [80, 50, 0]\n[[tool]]\nnumber = 1\ntype = \"thread-mill\"\n"
      "diameter = 10\npitch = 1.5\nteeth = 10\n",
      program_file);
}

std::string repeatedProgram(const std::string& program, int blocks) {
  const std::string body = program.substr(0, program.rfind("M30"));
  const auto lines = std::max<std::ptrdiff_t>(1, std::count(body.begin(), body.end(), '\n'));
  std::string text;
  for (std::ptrdiff_t i = 0; i < blocks; i += lines) text += body;
  return text + "M30\n";
}

std::string macroLoopProgram(int passes) {
  return fmt::format(
      "#1=0\n#2=0\nWHILE[#1LT{}]DO1\n#1=#1+1\n#2=#2+SQRT[#1*2.5]/3\n#100=[#1MOD7]*COS#2\nEND1\nM30\n",
      passes);
}

std::string shaftWithoutThread(const std::string& program) { return without(program, "N25 ", "N30 "); }

std::string shaftJob(const std::string& job, const std::string& program_file) {
  std::string text = without(job, "[nominal]", "[[tool]]");
  const std::string named = "program = \"shaft.nc\"";
  const std::size_t at = text.find(named);
  if (at == std::string::npos) throw std::runtime_error("the sample shaft's job names another program");
  return text.replace(at, named.size(), "program = \"" + program_file + "\"");
}

double shaftVolumeWithoutThread() {
  const double thread = frustum(2, 8, 10) + frustum(24, 10, 10);
  const double undercut = 2 * quarter(8.2, 0.2, -1) + frustum(3.6, 8, 8);
  const double cone = frustum(20, 12, 16) + frustum(12, 16, 16) + quarter(20, 4, -1);
  return thread + undercut + cone + quarter(20.5, 2, 1) + frustum(32, 22.5, 22.5);
}

}  // namespace proveout::bench
