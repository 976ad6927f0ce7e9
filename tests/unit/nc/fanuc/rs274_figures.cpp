// rs274_figures COUNT: the motions that LinuxCNC's interpreter `rs274` gives for the programs of the common
// subset, for rs274_figures.txt. Built by its name, where the interpreter is installed.
#include <fmt/core.h>

#include <cstdlib>

#include "tests/peer/rs274.h"
#include "tests/unit/nc/fanuc/common_subset.h"

int main(int argc, char** argv) {
  using proveout::Vec3;
  constexpr double kPrinted = 3e-4;
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  fmt::print(
      "# Made by rs274 (LinuxCNC 2.9) of the programs of common_subset.h: build/release/bin/rs274_figures "
      "{}\n",
      count);
  for (int number = 0; number < count; ++number) {
    const auto program = proveout::test::commonProgram(static_cast<unsigned>(number));
    const auto run = proveout::peer::runInterpreter(program.linuxcnc, "out/rs274");
    if (!run || !run->error.empty()) {
      fmt::print(stderr, "program {}: {}\n{}", number, run ? run->error : "no interpreter", program.linuxcnc);
      return 1;
    }
    fmt::print("program {}\n", number);
    Vec3 at = Vec3::Zero();
    for (const auto& m : run->motions) {
      const bool goes = m.kind == 'A' || (m.to - at).cwiseAbs().maxCoeff() > kPrinted;
      at = m.to;
      if (!goes) continue;
      std::string line = fmt::format("{} {}", m.kind, proveout::test::IsoRun::shown(m.to));
      for (int axis = 0; axis < 3 && m.kind == 'A'; ++axis) {
        line += m.center_axes[static_cast<std::size_t>(axis)]
                    ? " " + proveout::test::IsoRun::number(m.center[axis])
                    : " -";
      }
      fmt::print("{}\n", line);
    }
  }
  return 0;
}
