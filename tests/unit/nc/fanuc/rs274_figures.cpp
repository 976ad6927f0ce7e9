// rs274_figures COUNT: the motions that LinuxCNC's interpreter gives for the programs of the common subset,
// for rs274_figures.txt. Built by its name, where the interpreter's module for Python is installed.
#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/peer/interpreter_run.h"
#include "tests/unit/nc/fanuc/common_subset.h"

namespace {

using namespace proveout;  // NOLINT

constexpr double kNowhereMm = 1e-6;

/// Seven decimals: the figures are held to 1e-6 mm.
std::string figure(double value) {
  std::string text = fmt::format("{:.7f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

void print(const peer::PeerRun& run) {
  Vec3 at = Vec3::Zero();
  for (const peer::PeerMotion& m : run.motions) {
    const bool goes = m.kind == 'A' || (m.to - at).cwiseAbs().maxCoeff() > kNowhereMm;
    at = m.to;
    if (!goes) continue;
    std::string line =
        fmt::format("{} {} {} {}", m.kind, figure(m.to.x()), figure(m.to.y()), figure(m.to.z()));
    for (int axis = 0; m.kind == 'A' && axis < 3; ++axis)
      line += std::abs(m.sweep[axis]) > 0.0 ? " -" : " " + figure(m.center[axis]);
    fmt::print("{}\n", line);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  const std::filesystem::path folder = std::filesystem::absolute("out/rs274");
  std::filesystem::create_directories(folder);
  std::vector<std::string> paths;
  for (int number = 0; number < count; ++number) {
    paths.push_back((folder / fmt::format("{}.ngc", number)).string());
    std::ofstream(paths.back()) << test::commonProgram(static_cast<unsigned>(number)).linuxcnc;
  }
  const auto runs = peer::runInterpreter(paths, {{1, 50.0, 10.0}}, folder.string());
  fmt::print(
      "# Made by LinuxCNC's interpreter of the programs of common_subset.h: build/release/bin/rs274_figures "
      "{}\n",
      count);
  for (int number = 0; number < count; ++number) {
    const auto k = static_cast<std::size_t>(number);
    if (k >= runs.size() || !runs[k].error.empty()) {
      fmt::print(stderr, "program {}: {}\n", number, k < runs.size() ? runs[k].error : "no interpreter");
      return 1;
    }
    fmt::print("program {}\n", number);
    print(runs[k]);
  }
  return 0;
}
