// Comparisons of files, as child processes: two large meshes, and a part with a STEP file of 2,000 faces.
// With --against another build of the program runs in turn with this one; figures are medians.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/child_process.h"
#include "tests/bench/workplace.h"

namespace proveout::bench {
namespace {

namespace fs = std::filesystem;

/// A torus with waves along it as binary STL of 2 `rings` `sides` triangles: nothing in it is flat, and no
/// face of one mesh is one of the other.
std::string torusStl(int rings, int sides) {
  struct P {
    float x, y, z;
  };
  const auto at = [&](int i, int j) {
    const double u = 2.0 * std::numbers::pi * (i % rings) / rings,
                 v = 2.0 * std::numbers::pi * (j % sides) / sides;
    const double tube = 15.0 + 2.0 * std::sin(9.0 * u), r = 50.0 + tube * std::cos(v);
    return P{static_cast<float>(r * std::cos(u)), static_cast<float>(r * std::sin(u)),
             static_cast<float>(tube * std::sin(v))};
  };
  std::string out(80, ' ');
  const auto append = [&out](const void* from, std::size_t bytes) {
    out.append(static_cast<const char*>(from), bytes);
  };
  const auto count = static_cast<std::uint32_t>(2 * rings * sides);
  append(&count, 4);
  const P none{0, 0, 0};
  const std::uint16_t attributes = 0;
  const auto triangle = [&](const P& a, const P& b, const P& c) {
    for (const P* p : {&none, &a, &b, &c}) append(p, sizeof(P));
    append(&attributes, 2);
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return out;
}

struct Asked {
  std::string against;
  int times = 1;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void compare(const std::string& name, const std::string& part, const std::string& nominal, const Asked& asked,
             const Workplace& work) {
  std::vector<std::string> programs{programPath()};
  if (!asked.against.empty()) programs.push_back(asked.against);
  std::vector<std::vector<double>> wall(programs.size()), cpu(programs.size()), peak(programs.size());
  for (int time = 0; time < asked.times; ++time) {
    for (std::size_t k = 0; k < programs.size(); ++k) {
      const ChildOutcome child = runChild({programs[k], "compare", part, nominal}, work.path("errors"), 600);
      if (!child.ended || child.exit_code > 1) {
        fmt::print("{}: ended with code {}: {}\n", name, child.exit_code, readFile(work.path("errors")));
        return;
      }
      wall[k].push_back(child.wall_s);
      cpu[k].push_back(child.cpu_s);
      peak[k].push_back(child.peak_mb);
    }
  }
  for (std::size_t k = 0; k < programs.size(); ++k)
    fmt::print("{:<44} {:>8.2f} {:>8.2f} {:>8.0f}\n", k == 0 ? name : "  before", median(wall[k]),
               median(cpu[k]), median(peak[k]));
  std::fflush(stdout);
}

int run(const Asked& asked) {
  const Workplace work;
  fmt::print("{:<44} {:>8} {:>8} {:>8}\n", "comparison", "whole s", "cpu s", "peak MB");
  const std::string small = work.write("small.stl", torusStl(500, 200)),
                    large = work.write("large.stl", torusStl(2000, 500)),
                    huge = work.write("huge.stl", torusStl(2500, 1000));
  compare("200,000 triangles with as many", small, small, asked, work);
  compare("2 million triangles with 5 million", large, huge, asked, work);
  const std::string maker = (fs::path(programPath()).parent_path() / "step_plate").string();
  if (!fs::exists(maker)) {
    fmt::print("without OpenCASCADE: STEP files are left out\n");
    return 0;
  }
  const std::string step = work.path("plate.step"), stl = work.path("plate.stl");
  const ChildOutcome made = runChild({maker, "15", step, stl}, work.path("errors"), 600);
  if (!made.ended || made.exit_code != 0) {
    fmt::print("{}: ended with code {}\n", maker, made.exit_code);
    return 1;
  }
  compare("STEP of 2,031 faces with its facets", stl, step, asked, work);
  return 0;
}

}  // namespace
}  // namespace proveout::bench

int main(int argc, char** argv) {
  proveout::bench::Asked asked;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--against" && i + 1 < argc) {
      asked.against = argv[++i];
    } else if (word == "--times" && i + 1 < argc) {
      asked.times = std::max(1, std::atoi(argv[++i]));
    } else {
      fmt::print(stderr, "usage: {} [--against PROGRAM] [--times RUNS]\n", argv[0]);
      return 2;
    }
  }
  return proveout::bench::run(asked);
}
