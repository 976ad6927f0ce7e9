#include "tests/bench/bench_cases.h"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <utility>

#include "tests/bench/generated_programs.h"
#include "tests/bench/workplace.h"

namespace proveout::bench {
namespace {

constexpr const char* kShared = PROVEOUT_SHARED_PROGRAMS;
constexpr const char* kShaft = PROVEOUT_PARTS "/wl4_shaft";

std::vector<Case> samplePrograms() {
  const Case bear{.name = "bear", .file = "bear.nc", .stock = "box:0,0,-20:80,80,0", .tool = "1=ball:3.175"};
  const Case flower{.name = "flower_mold",
                    .file = "flower_mold.nc",
                    .stock = "box:-3.92956,-3.92829,-9.95121:61.0796,61.0529,0",
                    .tool = "1=flat:1"};
  const Case diamond{.name = "circle_diamond",
                     .file = "circle_diamond_square.gcode",
                     .stock = "box:-60,-60,-10:60,60,0",
                     .tool = "1=flat:3"};
  std::vector<Case> cases;
  const auto add = [&](Case c, double grid, bool heavy) {
    c.grid_mm = grid;
    c.heavy = heavy;
    cases.push_back(std::move(c));
  };
  add(bear, 0.25, false);
  add(bear, 0.1, false);
  add(bear, 0.05, true);
  add(flower, 0.25, false);
  Case drawn = bear;
  drawn.name += ", with pictures";
  drawn.picture = true;
  add(drawn, 0.25, false);
  for (Case c : {bear, flower}) {  // beside the default, a tenth of the grid
    c.name += ", all triangles";
    c.simplify = "0";
    add(c, 0.25, false);
  }
  add(flower, 0.05, true);
  add(diamond, 0.25, false);
  return cases;
}

std::vector<Case> generatedCases() {
  std::vector<Case> cases;
  cases.push_back({.name = "slot 100x50x20",
                   .file = "slot.nc",
                   .text = slotProgram,
                   .stock = "box:0,0,-20:100,50,0",
                   .tool = "1=flat:10",
                   .grid_mm = 0.1,
                   .exact_mm3 = 95000.0});
  cases.push_back({.name = "pocket 50x40x10",
                   .file = "pocket.nc",
                   .text = pocketProgram,
                   .stock = "box:0,0,-10:50,40,0",
                   .tool = "1=flat:10",
                   .grid_mm = 0.25,
                   .exact_mm3 = 20000.0 - 5.0 * (1200.0 - (4.0 - std::numbers::pi) * 25.0)});
  for (const int lines : {250, 500, 1000}) {
    constexpr int kMovesALine = 2000;
    cases.push_back({.name = fmt::format("finishing {}k moves", lines * kMovesALine / 1000),
                     .file = fmt::format("finishing{}.nc", lines),
                     .text = [lines] { return finishingProgram(lines, kMovesALine); },
                     .stock = "box:0,0,-20:200,200,0",
                     .tool = "1=ball:6",
                     .grid_mm = 0.1,
                     .heavy = lines == 1000});
  }
  return cases;
}

/// The turned sample: without its thread, where there is no grid and the mesh follows the job's profile
/// resolution, and whole on a grid.
std::vector<Case> turnedCases() {
  const auto program = [] { return readFile(std::string(kShaft) + "/shaft.nc"); };
  const auto job = [](const std::string& file) {
    return [file] { return shaftJob(readFile(std::string(kShaft) + "/job.toml"), file); };
  };
  return {{.name = "shaft profile",
           .file = "profile.nc",
           .text = [program] { return shaftWithoutThread(program()); },
           .grid_mm = 0.01,
           .exact_mm3 = shaftVolumeWithoutThread(),
           .job_file = "profile.toml",
           .job = job("profile.nc")},
          {.name = "shaft",
           .file = "shaft.nc",
           .text = program,
           .grid_mm = 0.05,
           .exact_mm3 = 87338.98,  // parts/make_nominals.py: the thread's sections added up
           .job_file = "shaft.toml",
           .job = job("shaft.nc")},
          {.name = "shaft profile, with a picture",
           .file = "profile.nc",
           .text = [program] { return shaftWithoutThread(program()); },
           .grid_mm = 0.01,
           .job_file = "profile.toml",
           .job = job("profile.nc"),
           .picture = true},
          {.name = "20000 short lines",
           .file = "lines.nc",
           .text = shortLinesProgram,
           .grid_mm = 0.01,
           .job_file = "lines.toml",
           .job = [] { return shortLinesJob("lines.nc"); }},
          {.name = "thread of 400 turns",
           .file = "turns.nc",
           .text = longThreadProgram,
           .grid_mm = 0.2,
           .job_file = "turns.toml",
           .job = [] { return threadJob("turns.nc", 420); }},
          {.name = "30 thread passes",
           .file = "passes.nc",
           .text = manyPassesProgram,
           .grid_mm = 0.1,
           .job_file = "passes.toml",
           .job = [] { return threadJob("passes.nc", 60); }},
          {.name = "worm, with a picture",
           .file = "worm.pmc",
           .text = wormProgram,
           .grid_mm = 0.1,
           .job_file = "worm.toml",
           .job = [] { return wormJob("worm.pmc"); },
           .picture = true}};
}

/// Contours of a wire, whole processes: 20,000 blocks in a plate of 60 mm, upright as an exact section (aim:
/// 0.3 s and 100 MB) and leaning by two degrees (aim: 2 s).
std::vector<Case> wireCases() {
  constexpr int kBlocks = 20000;
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, double lean_deg) {
    Case c{.name = name, .file = name + ".nc", .text = [lean_deg] {
             return gearProgram(kBlocks, 2.5, lean_deg);
           }};
    c.grid_mm = 0.1;
    c.job_file = name + ".toml";
    c.job = [file = c.file] { return gearJob(file); };
    cases.push_back(std::move(c));
  };
  add("wire gear", 0.0);
  add("wire gear, leaning", 2.0);
  return cases;
}

/// One surface by an upright tool, a leaning one and one that turns in every block; five lines of it as well,
/// as all take long. Aim: 1.5 and 6 times the processor time of the upright tool.
std::vector<Case> fiveAxisCases() {
  constexpr int kMovesALine = 1001;
  std::vector<Case> cases;
  for (const int lines : {5, 100}) {
    for (const auto& [name, axis] :
         {std::pair{"upright", FinishingAxis::kUpright}, std::pair{"leaning", FinishingAxis::kLeaning},
          std::pair{"turning", FinishingAxis::kTurning}}) {
      Case c{.name = fmt::format("ball {}, {} lines", name, lines),
             .file = fmt::format("{}{}.nc", name, lines),
             .text = [lines, axis] { return fiveAxisFinishing(lines, kMovesALine, axis); }};
      c.grid_mm = 0.1;
      c.heavy = lines > 5;
      c.job_file = fmt::format("{}{}.toml", name, lines);
      c.job = [file = c.file] { return fiveAxisJob(file, PROVEOUT_PARTS "/machines/head_cb.toml"); };
      cases.push_back(std::move(c));
    }
  }
  return cases;
}

/// What cost users most once: triangles of flat faces, pictures, curves, mending.
std::vector<Case> dearCases() {
  std::vector<Case> cases;
  for (const double grid : {0.5, 0.25}) {
    cases.push_back({.name = "slot 100x50x20",
                     .file = "slot.nc",
                     .text = slotProgram,
                     .stock = "box:0,0,-20:100,50,0",
                     .tool = "1=flat:10",
                     .grid_mm = grid,
                     .exact_mm3 = 95000.0});
  }
  for (const char* simplify : {"", "0.025"}) {
    cases.push_back({.name = *simplify != 0 ? "bracket, 0.025 mm allowed" : "bracket",
                     .file = "bracket.nc",
                     .grid_mm = 0.25,
                     .job_file = PROVEOUT_PARTS "/bracket/job.toml",
                     .simplify = simplify});
  }
  cases.push_back({.name = "bracket, with pictures",
                   .file = "bracket.nc",
                   .grid_mm = 0.25,
                   .job_file = PROVEOUT_PARTS "/bracket/job.toml",
                   .picture = true});
  cases.push_back({.name = "thread mill",
                   .file = "threadmill.nc",
                   .text = threadMillProgram,
                   .grid_mm = 0.1,
                   .job_file = "threadmill.toml",
                   .job = [] { return threadMillJob("threadmill.nc"); }});
  cases.push_back({.name = "ball on arcs and ramps",
                   .file = "arcs.nc",
                   .text = arcsProgram,
                   .stock = "box:0,0,-20:100,50,0",
                   .tool = "1=ball:6",
                   .grid_mm = 0.25});
  cases.push_back({.name = "relief, ball of 0.8 mm",
                   .file = "relief.nc",
                   .text = reliefProgram,
                   .stock = "box:0,0,-5:20,20,0",
                   .tool = "1=ball:0.8",
                   .grid_mm = 0.25});
  return cases;
}

}  // namespace

std::string sharedFolder() { return kShared; }

std::vector<Case> allCases() {
  const bool shared = std::filesystem::exists(sharedFolder() + "/bear.nc");
  std::vector<Case> cases = shared ? samplePrograms() : std::vector<Case>{};
  for (const auto& more : {generatedCases(), dearCases(), turnedCases(), wireCases(), fiveAxisCases()})
    cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

}  // namespace proveout::bench
