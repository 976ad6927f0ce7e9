// Jobs of several setups: up to four clampings of one blank, each with a control of its own, tools and a
// program of that control's words, with the stock turned, shifted and handed over between them, whole or by
// way of a saved one. Such a job is refused with a reason, ends in an alarm, or leaves closed meshes whose
// volumes add up.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/session/run/job_defaults.h"
#include "app/session/session.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

/// What a control reads: `#` stands for a number of the input.
struct Words {
  const char* control;
  const char* head;
  const char* tail;
  const char* tools;
  std::vector<const char*> lines;
};

const std::vector<Words>& controls() {
  constexpr const char* kMillTools =
      "number = 1\ntype = \"flat\"\ndiameter = 4\n[[setup.tool]]\nnumber = 2\ntype = \"ball\"\ndiameter = "
      "3\n";
  constexpr const char* kInserts =
      "number = 1\ntype = \"insert\"\nnose_radius = 0.4\norientation = 3\ninsert_angle = 55\nlead_angle = "
      "93\n"
      "edge_length = 11\n[[setup.tool]]\nnumber = 2\ntype = \"insert\"\nshape = \"groove\"\nwidth = 3\n"
      "nose_radius = 0.2\norientation = 3\nedge_length = 8\n";
  static const std::vector<Words> all = {
      {"nct",
       "G21 G90 G17 G40\nT1 M6\nS1000 M3\nG0 Z30\n",
       "G80\nG0 Z30\nM30\n",
       kMillTools,
       {"G0 X# Y#", "G0 Z#", "G1 X# Y# Z# F200", "G1 X#", "G2 X# Y# R#", "G3 X# Y# Z# I# J#", "G81 Z# R# F90",
        "X#", "G80", "G91 G1 Z# F80", "G90", "T2 M6", "G52 X# Y#", "G1 Z# F90", "G68 X0 Y0 R#", "G69"}},
      {"wl4-mill",
       "G90 G17 G40\nT1 M6\nS1000 M3\nG0 Z30\n",
       "G0 Z30\nM2\n",
       kMillTools,
       {"G0 X# Y#", "G0 Z#", "G1 X# Y# Z# F200", "G2 X# Y# R#", "G3 X# Y# I# J#", "G91 G1 Z# F80", "G90",
        "T2 M6", "G1 Z# F90"}},
      {"wl4-lathe",
       "G54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X60 Z6\n",
       "G0 X60 Z6\nM2\n",
       kInserts,
       {"G0 X# Z#", "G1 X# Z# F0.2", "G1 Z# F0.2", "G1 X# F0.1", "G2 X# Z# R#", "G3 X# Z# R#", "T2 M6",
        "G0 X60", "G41 G1 X# Z#", "G40 G0 X60", "G33 Z# F1.5"}},
      {"flexnc",
       "T1M06D1\nS900M03\nG99F0.25\nG90G00X60Z6\n",
       "G00X60Z6\nM02\n",
       kInserts,
       {"G00X#Z#", "G01X#Z#F0.2", "G01Z#", "G01X#", "G02X#Z#R#", "G03X#Z#R#", "T2M06D2", "G00X60",
        "G77X#A#Y1.5Z0P2C2B2V0"}},
      {"wedm",
       "H001=150;\nN1 T84 T86;\nN2 G92 X30. Y30.;\n",
       "N9 T85 T87;\nM02;\n",
       "number = 1\ntype = \"wire\"\ndiameter = 0.2\nspark_gap = 0.01\n",
       {"G01 X# Y#;", "G00 X# Y#;", "G02 X# Y# I# J#;", "G03 X# Y# I# J#;", "G52 A0 G42 H001 G01 X#;",
        "G40 G50 A0 Y#;", "G51 A#;", "M00;", "C001;", "G01 X#;"}}};
  return all;
}

/// Numbers that meet each other: quarters of millimetres around the blank.
std::string number(Bytes& input) { return fmt::format("{:.2f}", input.take<std::int8_t>() * 0.25); }

std::string line(const char* form, Bytes& input) {
  std::string text;
  for (const char* at = form; *at != 0; ++at) text += *at == '#' ? number(input) : std::string(1, *at);
  return text + "\n";
}

std::string programOf(const Words& words, Bytes& input) {
  std::string text = words.head;
  const int lines = 1 + input.take<std::uint8_t>() % 12;
  for (int k = 0; k < lines && !input.empty(); ++k)
    text += line(words.lines[input.take<std::uint8_t>() % words.lines.size()], input);
  return text + words.tail;
}

std::string moved(Bytes& input) {
  const auto how = input.take<std::uint8_t>();
  std::array<int, 3> turn{};
  for (int& axis : turn)
    axis = how % 16 == 15 ? input.take<std::int8_t>() : 90 * (input.take<std::uint8_t>() % 4);
  return fmt::format("[setup.transform]\nrotate = [{}, {}, {}]\ntranslate = [{}, {}, {}]\n", turn[0], turn[1],
                     turn[2], how % 4 == 0 ? number(input) : "0", how % 4 == 0 ? number(input) : "0",
                     how % 4 <= 1 ? number(input) : "0");
}

struct Made {
  std::string job;
  std::vector<std::string> programs;
};

Made make(Bytes& input) {
  Made made;
  const auto shape = input.take<std::uint8_t>();
  const int setups = 2 + input.take<std::uint8_t>() % 3;
  std::string text;
  for (int k = 0; k < setups; ++k) {
    const Words& words = controls()[input.take<std::uint8_t>() % controls().size()];
    if (k == 0) text += fmt::format("schema = \"proveout.job/1\"\ncontrol = \"{}\"\n", words.control);
    if (k == 0) {
      text += shape % 2 == 0
                  ? "[stock]\nshape = \"box\"\nmin = [-10, -8, -9]\nmax = [10, 8, 0]\n"
                  : "[stock]\nshape = \"cylinder\"\nbase = [0, 0, -22]\ndiameter = 18\nlength = 22\n";
      text += fmt::format(
          "[simulation]\nresolution = {}\nprofile_resolution = 0.1\nmax_memory_gb = 0.4\n"
          "max_time_s = 3\nthreads = 2\n",
          shape % 4 < 2 ? "1" : "0.7");
    }
    text += fmt::format("[[setup]]\nname = \"s{}\"\nprogram = \"p{}\"\n[setup.control]\nname = \"{}\"\n", k,
                        k, words.control);
    if (k > 0) text += moved(input);
    text += std::string("[[setup.tool]]\n") + words.tools;
    made.programs.push_back(programOf(words, input));
  }
  made.job = text;
  return made;
}

void checkSetup(const SetupRun& setup) {
  const double left = setup.surface.volume_mm3, removed = setup.initial_mm3 - left;
  require(std::isfinite(left) && left >= 0.0, "what is left has a volume");
  require(removed >= -1e-9 * setup.initial_mm3, "no clamping adds material");
  require(analyseTopology(setup.surface.mesh).closedManifold(), "every mesh is closed");
  for (const TriMesh& piece : setup.freed)
    require(analyseTopology(piece).closedManifold(), "the meshes of pieces are closed");
}

void checkRun(const RunResult& run) {
  require(!run.setups.empty(), "there are clampings");
  for (const Finding& finding : run.findings) require(!finding.message.empty(), "a finding says something");
  if (run.alarm) return;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    checkSetup(run.setups[k]);
    if (k == 0) continue;
    const double before = run.setups[k - 1].surface.volume_mm3, now = run.setups[k].initial_mm3;
    require(std::abs(now - before) <= 1e-6 * (1.0 + before), "a clamping begins with what was left");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const JobNames names = [] {
    JobNames known = jobNames();
    known.programs_in_memory = true;
    return known;
  }();
  Bytes input({reinterpret_cast<const char*>(data), size});
  const Made made = make(input);
  Diagnostics diagnostics;
  const std::optional<Job> job = parseJob(made.job, "job.toml", "", names, diagnostics);
  require(job.has_value() || diagnostics.hasErrors(), "a job, or errors");
  if (!job) return 0;
  std::vector<MemoryProgramSource> sources;
  sources.reserve(made.programs.size());
  for (std::size_t k = 0; k < made.programs.size(); ++k)
    sources.emplace_back(fmt::format("p{}", k), made.programs[k]);
  std::vector<const ProgramSource*> programs;
  for (const MemoryProgramSource& source : sources) programs.push_back(&source);
  Progress progress;
  const Result<RunResult> run = runJob(*job, programs, progress);
  if (!run) {
    require(!run.error().message.empty() && run.error().kind != ErrorKind::kInternal,
            "a refusal has a reason");
    return 0;
  }
  checkRun(*run);
  return 0;
}
