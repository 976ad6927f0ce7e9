// The cause that is told first of a part with one mistake, on parts that seeds make: in how many it is the
// mistake.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include "app/job_setup.h"
#include "app/session/session.h"
#include "io/job/job.h"
#include "io/mesh_io.h"
#include "tests/study/cause_parts.h"
#include "tests/support/temporary_folder.h"

namespace proveout::study {
namespace {

int numberOf(const char* variable, int usual) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

Result<RunResult> run(const test::TemporaryFolder& folder, const StudyJob& job, bool with_nominal) {
  for (const StudyFile& file : job.files) folder.write(file.name, file.text);
  if (!with_nominal) {  // it is what comes out
    std::string text = job.files.back().text;
    const std::size_t from = text.find("[nominal]"), to = text.find("\n[", from);
    folder.write(job.files.back().name, text.erase(from, to == std::string::npos ? to : to - from));
  }
  Diagnostics diagnostics;
  std::optional<Job> loaded = loadJob(folder.path("job.toml"), knownJobNames(), diagnostics);
  if (!loaded)
    return inputError(diagnostics.all().empty() ? "no job" : formatDiagnostic(diagnostics.all().front()));
  if (!with_nominal) {
    loaded->simulation.resolution_mm = 0.2;
    loaded->simulation.simplify_mm = 1e-3;
  }
  Progress progress;
  return runJob(*loaded, progress);
}

bool names(const Cause& cause, const Mistake& mistake, const StudyJob& job) {
  if (mistake.data.contains(cause.what)) return true;
  const auto is = [&](const BlockRef& ref) {
    return std::any_of(mistake.words.begin(), mistake.words.end(), [&](const std::string& word) {
      const auto at = job.lines.find(word);
      const std::string file = word.substr(0, word.find(':'));
      return at != job.lines.end() && static_cast<std::uint32_t>(at->second) == ref.line &&
             ref.file.size() >= file.size() &&
             ref.file.compare(ref.file.size() - file.size(), file.size(), file) == 0;
    });
  };
  return (cause.source && is(*cause.source)) || std::any_of(cause.from.begin(), cause.from.end(), is);
}

struct Row {
  int planted = 0, found = 0, first = 0, among_three = 0;
};

std::string causesText(const Finding& f) {
  std::string out;
  for (const Cause& c : f.causes)
    out += fmt::format("\n      {} {} line {}; with \"{}\" left {:.4f}; explains {:.2f}", c.what, c.value,
                       c.source ? c.source->line : 0, c.with, c.left_mm.value_or(-1), c.explains);
  return out;
}

/// What decides: an alarm, else the deepest deviation, else the first error.
const Finding* decisive(const RunResult& run) {
  const Finding* best = nullptr;
  for (const Finding& f : run.findings) {
    if (f.severity != Severity::kError) continue;
    if (f.kind == FindingKind::kAlarm) return &f;
    const bool deeper = isDeviation(f.kind) && (best == nullptr || !isDeviation(best->kind) ||
                                                f.depth_mm.value_or(0) > best->depth_mm.value_or(0));
    if (best == nullptr || deeper) best = &f;
  }
  return best;
}

/// Which cause of the finding that decides is the mistake; 0: the first; -1: none. An alarm, and a spindle
/// that stands, name their block.
int placeOf(const Finding& f, const RunResult& run, const Mistake& mistake, const StudyJob& job) {
  if (f.kind == FindingKind::kAlarm) return 0;
  const auto place = [&](const Finding& finding) {
    for (std::size_t i = 0; i < finding.causes.size(); ++i) {
      if (names(finding.causes[i], mistake, job)) return static_cast<int>(i);
    }
    return -1;
  };
  if (mistake.kind == "M5 for M3") {
    for (const Finding& other : run.findings) {
      if (other.kind == FindingKind::kSpindleOff) return place(other);
    }
  }
  return place(f);
}

struct Table {
  std::map<std::string, Row> rows;
  std::vector<std::string> complaints;
  double right_s = 0.0, wrong_s = 0.0;
};

using MakeJob = StudyJob (*)(std::uint32_t, const Plan&);
using MakeMistake = Mistake (*)(std::uint32_t);

void examine(std::uint32_t seed, MakeJob make, MakeMistake mistakeOf, bool tells, Table& table) {
  const test::TemporaryFolder folder;
  const Result<RunResult> right = run(folder, make(seed, {}), false);
  ASSERT_TRUE(right.ok()) << seed << ": " << right.error().message;
  ASSERT_FALSE(right->alarm) << seed << ": " << right->findings.front().message;
  ASSERT_TRUE(writeMesh(right->surface().mesh, folder.path("nominal.stl"), MeshFormat::kStlBinary).ok());
  const Mistake mistake = mistakeOf(seed);
  const StudyJob job = make(seed, mistake.plan);
  const Result<RunResult> wrong = run(folder, job, true);
  Row& row = table.rows[mistake.kind];
  ++row.planted;
  const std::string label = fmt::format("#{} {}: {}", seed, mistake.kind, mistake.what);
  if (!wrong.ok()) {
    table.complaints.push_back(label + ": refused: " + wrong.error().message);
    return;
  }
  const Finding* f = decisive(*wrong);
  if (f == nullptr) {
    table.complaints.push_back(label + ": not found");
    return;
  }
  ++row.found;
  const int place = placeOf(*f, *wrong, mistake, job);
  row.first += place == 0;
  row.among_three += place >= 0 && place < 3;
  if (place == 0 || !tells) return;
  table.complaints.push_back(fmt::format("{}: place {}: {} {}{}", label, place, findingKindName(f->kind),
                                         f->message, causesText(*f)));
}

Row print(const Table& table) {
  Row sum;
  fmt::print("{:<26}{:>9}{:>9}{:>9}{:>12}\n", "mistake", "planted", "found", "first", "among three");
  for (const auto& [kind, r] : table.rows) {
    fmt::print("{:<26}{:>9}{:>9}{:>9}{:>12}\n", kind, r.planted, r.found, r.first, r.among_three);
    sum.planted += r.planted, sum.found += r.found, sum.first += r.first, sum.among_three += r.among_three;
  }
  fmt::print("{:<26}{:>9}{:>9}{:>9}{:>12}\n", "all", sum.planted, sum.found, sum.first, sum.among_three);
  std::fflush(stdout);
  for (const std::string& c : table.complaints) std::cout << "  " << c << "\n";
  return sum;
}

/// Seeds from PROVEOUT_STUDY_FROM on; those from 100,000 on are counted alone and never looked at.
void study(MakeJob make, MakeMistake mistakeOf, int usual) {
  const auto from = static_cast<std::uint32_t>(numberOf("PROVEOUT_STUDY_FROM", 0));
  const auto count = static_cast<std::uint32_t>(numberOf("PROVEOUT_STUDY_COUNT", usual));
  constexpr std::uint32_t kSealed = 100'000;
  Table table;
  for (std::uint32_t seed = from; seed < from + count; ++seed)
    ASSERT_NO_FATAL_FAILURE(examine(seed, make, mistakeOf, seed < kSealed, table));
  const Row sum = print(table);
  EXPECT_EQ(sum.found, sum.planted);
  EXPECT_GE(sum.first, 0.9 * sum.found);
  EXPECT_GE(sum.among_three, 0.98 * sum.found - 0.999);
}

TEST(PlantedCauses, OfAPlateInTwoClampings) { study(platesJob, platesMistake, 8); }
TEST(PlantedCauses, OfADieUnderTheWire) { study(wireJob, wireMistake, 4); }

}  // namespace
}  // namespace proveout::study
