// The verdict on parts with one planted defect each, and on right ones: found or not, how deep, which block
// and which word. A seed makes all of them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/job_setup.h"
#include "app/session/session.h"
#include "io/job/job.h"
#include "io/mesh_io.h"
#include "tests/study/planted.h"

namespace proveout::study {
namespace {

constexpr double kTolerance = 0.05;
/// How many, or as the environment says.
int countOf(const char* variable, int usual) {
  const char* const text = getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

/// Other ones by PROVEOUT_STUDY_SEED; those from 100000 to 199999 are counted only, never looked at.
constexpr int kSeed = 20261122;

/// A folder with the nominal, in which jobs are run.
class Bench {
 public:
  Bench(const StudyPart& part, double chord) {
    std::string pattern = (std::filesystem::temp_directory_path() / "proveout-study-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    if (!writeMesh(part.nominal(chord), folder_ + "/nominal.stl", MeshFormat::kStlBinary).ok())
      throw std::runtime_error("nominal not written");
  }
  ~Bench() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Bench(const Bench&) = delete;

  Result<RunResult> run(const Planted& planted) const {
    std::ofstream(folder_ + "/p.nc", std::ios::binary) << planted.program;
    std::ofstream(folder_ + "/job.toml", std::ios::binary) << planted.job;
    Diagnostics diagnostics;
    const std::optional<Job> job = loadJob(folder_ + "/job.toml", knownJobNames(), diagnostics);
    if (!job) return inputError(diagnostics.all().empty() ? "no job" : diagnostics.all().front().message);
    const MemoryProgramSource memory("p.nc", planted.program);
    const RecordingSource source(memory, TextEncoding::kAuto);
    Progress progress;
    return runRecorded(*job, {&source}, progress);
  }

 private:
  std::string folder_;
};

/// What a run told of a defect.
struct Told {
  bool fails = false, undecided = false, found = false;
  double depth = 0.0, bound = 0.0;  ///< of the deepest deviation
  bool block = false, named = false, first = false, among_three = false;
};

/// Motions of the right program, to know which blocks a defect changed.
struct Path {
  std::vector<Motion> motions;
};

bool sameCut(const Motion& a, const Motion& b) {
  return (a.from - b.from).norm() < 1e-7 && (a.to - b.to).norm() < 1e-7 && a.tool == b.tool && a.arc == b.arc;
}

/// Lines whose motions are not where they should be: by line and its n-th motion. Wrong data of tools change
/// no motion, but all cuts of the tool.
std::set<std::uint32_t> changedLines(const Toolpath& right, const Toolpath& wrong, const Defect& defect) {
  const auto byLine = [](const Toolpath& path) {
    std::map<std::uint32_t, std::vector<const Motion*>> out;
    for (const Motion& m : path.motions) out[m.source.line].push_back(&m);
    return out;
  };
  const auto a = byLine(right), b = byLine(wrong);
  std::set<std::uint32_t> out;
  for (const auto& [line, motions] : b) {
    const auto at = a.find(line);
    bool same = at != a.end() && at->second.size() == motions.size();
    for (std::size_t i = 0; same && i < motions.size(); ++i) {
      same = sameCut(*at->second[i], *motions[i]);
      if (motions[i]->arc >= 0 && same)
        same = (right.arcs[static_cast<std::size_t>(at->second[i]->arc)].center -
                wrong.arcs[static_cast<std::size_t>(motions[i]->arc)].center)
                   .norm() < 1e-7;
    }
    for (const std::string& key : defect.data) {
      int tool = 0;
      if (std::sscanf(key.c_str(), "tools.%d.", &tool) == 1)
        same = same &&
               std::none_of(motions.begin(), motions.end(), [&](const Motion* m) { return m->tool == tool; });
    }
    if (!same) out.insert(line);
  }
  return out;
}

bool names(const Cause& cause, const Defect& defect, const Planted& planted) {
  if (defect.missing && cause.what == "no motion cuts here") return true;
  if (defect.data.contains(cause.what)) return true;
  const auto is = [&](const BlockRef& ref) {
    return std::any_of(defect.words.begin(), defect.words.end(), [&](const std::string& word) {
      const auto at = planted.lines.find(word);
      return at != planted.lines.end() && static_cast<std::uint32_t>(at->second) == ref.line;
    });
  };
  return (cause.source && is(*cause.source)) || std::any_of(cause.from.begin(), cause.from.end(), is);
}

Told judge(const RunResult& run, const Toolpath& right, const Defect& defect, const Planted& planted) {
  Told told;
  const std::set<std::uint32_t> changed = changedLines(right, run.setups[0].interpreted.path, defect);
  // Of a contour cycle the findings name the contour's block, and inside it the cycle that moved.
  const auto changesIn = [&](const std::optional<BlockRef>& block) {
    return block && changed.contains(block->line);
  };
  for (const Finding& f : run.findings) {
    told.undecided = told.undecided || f.kind == FindingKind::kUndecided;
    if (f.severity != Severity::kError) continue;
    told.fails = true;
    const bool deviation = f.kind == FindingKind::kGouge || f.kind == FindingKind::kExcess;
    if (deviation && f.depth_mm.value_or(0) > told.depth) {
      told.depth = *f.depth_mm;
      told.bound = f.bound_mm.value_or(0);
    }
    const bool uncut = std::any_of(f.causes.begin(), f.causes.end(),
                                   [](const Cause& c) { return c.what == "no motion cuts here"; });
    told.block = told.block || changesIn(f.source) || changesIn(f.inside) || (defect.missing && uncut) ||
                 f.kind == FindingKind::kAlarm;
    for (std::size_t i = 0; i < f.causes.size(); ++i) {
      if (!names(f.causes[i], defect, planted)) continue;
      told.named = true;
      told.first = told.first || i == 0;
      told.among_three = told.among_three || i < 3;
    }
    // The control stops at the block: that is the cause.
    if (f.kind == FindingKind::kAlarm) told.named = told.first = told.among_three = true;
  }
  told.found = told.fails;
  return told;
}

struct Row {
  int planted = 0, below = 0, found = 0, missed = 0, with_depth = 0, deep_right = 0, block = 0, named = 0,
      first = 0, among_three = 0;
  double worst = 0.0;
};

struct Study {
  std::map<std::string, Row> rows;
  int right = 0, right_failed = 0, right_undecided = 0, undecided = 0;
  std::vector<std::string> complaints;
};

std::string shortOf(const RunResult& run) {
  std::string out;
  for (const Finding& f : run.findings) {
    if (f.severity == Severity::kNote) continue;
    out += fmt::format(
        "\n      {} line {} X{:.3f} Y{:.3f} Z{:.3f} depth {:.4f} bound {:.4f} {}", findingKindName(f.kind),
        f.source ? f.source->line : 0, f.where.value_or(Vec3::Zero()).x(), f.where.value_or(Vec3::Zero()).y(),
        f.where.value_or(Vec3::Zero()).z(), f.depth_mm.value_or(0), f.bound_mm.value_or(0), f.message);
    for (const Cause& c : f.causes)
      out += fmt::format("\n        {} {} line {} {} {:.3f} explains {:.2f}", c.what, c.value,
                         c.source ? c.source->line : 0, c.along, c.off_mm.value_or(0), c.explains);
  }
  return out;
}

void plant(const StudyPart& part, const Bench& bench, const Toolpath& right_path, int count, double chord,
           Study& study) {
  std::mt19937 random(static_cast<std::uint32_t>(countOf("PROVEOUT_STUDY_SEED", kSeed)));
  for (int i = 0; i < count; ++i) {
    const Defect defect = part.defect(random);
    // One of them alone, for a closer look.
    if (const int only = countOf("PROVEOUT_STUDY_ONLY", -1); only >= 0 && only != i) continue;
    const Planted planted = part.write(defect.plan, 0);
    const Result<RunResult> run = bench.run(planted);
    const std::string label =
        fmt::format("{} {} #{}: {} {} by {:.4f}", part.name, chord, i, defect.kind,
                    defect.words.empty() ? *defect.data.begin() : *defect.words.begin(), defect.size);
    if (!run.ok()) {
      study.complaints.push_back(label + ": " + run.error().message);
      continue;
    }
    const Told told = judge(*run, right_path, defect, planted);
    Row& row = study.rows[defect.kind];
    ++row.planted;
    study.undecided += told.undecided;
    // What a closed form tells is above the tolerance; without one, what is found.
    const double size = defect.depth.value_or(told.depth);
    const bool must =
        defect.depth ? size > kTolerance + std::max(told.bound, 1e-3) + chord : told.fails || defect.missing;
    if (!told.fails) {
      ++(must ? row.missed : row.below);
      if (must) study.complaints.push_back(label + ": not found" + shortOf(*run));
      continue;
    }
    ++row.found;
    row.block += told.block;
    row.named += told.named;
    row.first += told.first;
    row.among_three += told.among_three;
    std::string wrong;
    if (!told.block) wrong += " block";
    if (!told.named) wrong += " word";
    if (defect.depth && told.depth > 0) {
      ++row.with_depth;
      const double off = std::abs(told.depth - *defect.depth);
      row.worst = std::max(row.worst, off);
      const bool good_depth = off <= told.bound + 2e-5;
      row.deep_right += good_depth;
      if (!good_depth) wrong += fmt::format(" depth (should be {:.4f})", *defect.depth);
    }
    if (!wrong.empty()) study.complaints.push_back(label + ":" + wrong + shortOf(*run));
  }
}

/// `path`: of the program that defects are planted in.
void runRight(const StudyPart& part, const Bench& bench, int count, double chord, Study& study,
              Toolpath& path) {
  for (int habit = 0; habit < count; ++habit) {
    Result<RunResult> run = bench.run(part.write({}, habit));
    ++study.right;
    bool failed = !run.ok() || run->alarm, undecided = false;
    for (const Finding& f : run.ok() ? run->findings : std::vector<Finding>()) {
      failed = failed || f.severity == Severity::kError;
      undecided = undecided || f.kind == FindingKind::kUndecided;
    }
    study.right_failed += failed;
    study.right_undecided += undecided;
    if (failed || undecided)
      study.complaints.push_back(fmt::format("{} {} right #{}: {}", part.name, chord, habit,
                                             run.ok() ? shortOf(*run) : run.error().message));
    if (habit > 0) continue;
    ASSERT_TRUE(run.ok()) << run.error().message;
    path = std::move(run->setups[0].interpreted.path);
  }
}

void print(const std::string& title, const Study& study) {
  std::cout << title << "\n";
  fmt::print("{:<26}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>12}{:>12}\n", "defect", "planted", "below",
             "found", "missed", "block", "named", "first", "of 3", "depth right", "worst mm");
  Row sum;
  for (const auto& [kind, r] : study.rows) {
    fmt::print("{:<26}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}/{:<3}{:>12.5f}\n", kind, r.planted,
               r.below, r.found, r.missed, r.block, r.named, r.first, r.among_three, r.deep_right,
               r.with_depth, r.worst);
    sum.planted += r.planted, sum.below += r.below, sum.found += r.found, sum.missed += r.missed,
        sum.block += r.block;
    sum.named += r.named, sum.first += r.first, sum.among_three += r.among_three,
        sum.deep_right += r.deep_right, sum.with_depth += r.with_depth;
    sum.worst = std::max(sum.worst, r.worst);
  }
  fmt::print("{:<26}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}/{:<3}{:>12.5f}\n", "all", sum.planted,
             sum.below, sum.found, sum.missed, sum.block, sum.named, sum.first, sum.among_three,
             sum.deep_right, sum.with_depth, sum.worst);
  fmt::print("right programs {}, failed {}, undecided {}\n", study.right, study.right_failed,
             study.right_undecided);
  std::fflush(stdout);
  for (const std::string& c : study.complaints) std::cout << "  " << c << "\n";
}

TEST(PlantedDefect, DepthOfAPocketIsThatOfItsFloor) {
  // Samples of the nominal's fillet are deeper by the errors of the machined mesh, until they are measured.
  const StudyPart part = milledPart();
  const Bench bench(part, 0.002);
  Plan plan;
  plan.values["round_z"] = -2.4624;
  const Result<RunResult> run = bench.run(part.write(plan, 0));
  ASSERT_TRUE(run.ok()) << run.error().message;
  double deepest = 0.0;
  for (const Finding& f : run->findings) {
    if (f.kind == FindingKind::kExcess) deepest = std::max(deepest, f.depth_mm.value_or(0));
  }
  EXPECT_NEAR(deepest, 0.5376, 2e-5);
  ASSERT_TRUE(run->comparison);
  EXPECT_NEAR(run->comparison->max_excess_mm, 0.5376, 2e-5);
}

/// Exports of CAD kernels, made by what stands beside them: each facet's chord is 0.02 mm.
class KernelExport : public testing::TestWithParam<const char*> {};

TEST_P(KernelExport, ARightPartHasNoErrorWithinTheChords) {
  const std::string name = std::string(PROVEOUT_STUDY_DIR) + "/kernels/" + GetParam();
  const Result<TriMesh> nominal = loadMesh(name);
  ASSERT_TRUE(nominal.ok()) << nominal.error().message;
  StudyPart part = milledPart();
  part.nominal = [&](double) { return *nominal; };
  const Bench bench(part, 0.02);
  for (const double tolerance : {0.05, 0.02, 0.01}) {
    Planted right = part.write({}, 0);
    for (const std::string key : {"gouge = ", "excess = "}) {
      const std::size_t at = right.job.find(key + "0.05");
      ASSERT_NE(at, std::string::npos);
      right.job.replace(at, key.size() + 4, key + Writer::number(tolerance));
    }
    const Result<RunResult> run = bench.run(right);
    ASSERT_TRUE(run.ok()) << run.error().message;
    for (const Finding& f : run->findings) {
      EXPECT_NE(f.severity, Severity::kError) << tolerance << ": " << f.message;
      if (tolerance >= 0.02) {
        EXPECT_NE(f.kind, FindingKind::kUndecided) << tolerance << ": " << f.message;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plates, KernelExport,
                         testing::Values("plate-occt-0.02.stl", "plate-openscad-0.02.stl"),
                         [](const auto& file) { return file.index == 0 ? "OpenCascade" : "OpenScad"; });

class PlantedDefects : public testing::TestWithParam<double> {};

TEST_P(PlantedDefects, AreFoundMeasuredAndNamed) {
  const double chord = GetParam();
  Study study;
  const auto examine = [&](const StudyPart& part, int defects, int right) {
    const Bench bench(part, chord);
    Toolpath path;
    ASSERT_NO_FATAL_FAILURE(runRight(part, bench, right, chord, study, path));
    ASSERT_NO_FATAL_FAILURE(plant(part, bench, path, defects, chord, study));
  };
  // The first of them, as many as `make test` has time for; all of them on a fine nominal with `make study`.
  const bool fine = chord < 0.003, whole = std::getenv("PROVEOUT_STUDY_WHOLE") != nullptr;
  struct Counts {
    int milled, turned, right_milled, right_turned;
  };
  const Counts counts = whole ? (fine ? Counts{200, 50, 35, 15} : Counts{20, 6, 2, 2})
                              : (fine ? Counts{8, 3, 1, 1} : Counts{4, 2, 1, 1});
  examine(milledPart(), countOf("PROVEOUT_STUDY_MILLED", counts.milled),
          countOf("PROVEOUT_STUDY_RIGHT", counts.right_milled));
  examine(turnedPart(), countOf("PROVEOUT_STUDY_TURNED", counts.turned),
          countOf("PROVEOUT_STUDY_RIGHT", counts.right_turned));
  print(fmt::format("planted defects, nominal with chords of {} mm", chord), study);
  Row sum;
  for (const auto& [kind, r] : study.rows) {
    sum.found += r.found, sum.missed += r.missed, sum.block += r.block, sum.named += r.named;
    sum.deep_right += r.deep_right, sum.with_depth += r.with_depth;
  }
  EXPECT_EQ(study.right_failed, 0);
  EXPECT_EQ(study.right_undecided, 0);
  EXPECT_EQ(sum.missed, 0);
  EXPECT_EQ(sum.deep_right, sum.with_depth);
  EXPECT_GE(sum.block, 0.99 * sum.found);
  EXPECT_GE(sum.named, 0.95 * sum.found);
}

INSTANTIATE_TEST_SUITE_P(Chords, PlantedDefects, testing::Values(0.002, 0.005, 0.02, 0.05),
                         [](const auto& chord) {
                           return fmt::format("Um{}", std::lround(1000 * chord.param));
                         });

}  // namespace
}  // namespace proveout::study
