#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/input_files.h"
#include "app/job_setup.h"
#include "app/placement_options.h"
#include "app/session/causes/diagnosis.h"
#include "app/session/comparison.h"
#include "app/session/findings/blame.h"
#include "app/session/findings/findings.h"
#include "app/session/findings/provenance.h"
#include "app/session/forecast/thread_supply.h"
#include "app/session/session.h"
#include "app/time_limit.h"
#include "core/base/printable.h"
#include "core/geometry/place_text.h"
#include "io/atomic_file.h"
#include "io/report_text.h"
#include "io/sha256.h"

namespace proveout {
namespace {

constexpr std::size_t kMaxReportBytes = std::size_t{1} << 30;

/// The command line behind a report, whose inputs must be what they were.
Result<RunOptions> commandOf(const std::string& name) {
  const std::string path =
      std::filesystem::is_directory(name) ? (std::filesystem::path(name) / "report.json").string() : name;
  if (const Status settled = settleInputs({{"report", path}}); !settled) return settled.error();
  const Result<std::string> text = readWholeFile(path, kMaxReportBytes);
  if (!text) return text.error();
  const nlohmann::json root = nlohmann::json::parse(*text, nullptr, false);
  const auto wrong = [&](const std::string& what) { return inputError(path + ": " + what); };
  if (root.is_discarded() || !root.is_object()) return wrong("not a report: it is no JSON document");
  std::vector<std::string> words;
  for (const nlohmann::json& word : root.value("command", nlohmann::json::array())) {
    if (!word.is_string()) return wrong("`command` is not a list of texts");
    words.push_back(word.get<std::string>());
  }
  if (words.empty()) return wrong("the report is not that of a run, or of an older version: run it again");
  for (const nlohmann::json& input :
       root.value("hashes", nlohmann::json::object()).value("inputs", nlohmann::json())) {
    if (!input.is_object() || !input.contains("path") || !input.contains("sha256")) continue;
    const std::string file = input["path"].get<std::string>();
    const Result<std::string> hash = sha256OfFile(file);
    if (!hash)
      return inputError(hash.error().message + "; call this in the folder in which the run was made");
    if (*hash != input["sha256"].get<std::string>())
      return inputError(file + " is not what it was when the report was made: run it again");
  }
  const CommandLine line = parseCommandLine(words);
  if (!line.command || !std::holds_alternative<RunOptions>(*line.command))
    return wrong("`command` is not that of a run: " + line.errors);
  return std::get<RunOptions>(*line.command);
}

void say(Console& console, const char* what, const std::string& text) {
  console.out << fmt::format("{:<12}{}\n", what, printable(text));
}

/// A finding about this point alone.
Finding findingAt(const Vec3& place, const SettledPoint& at, double deviation, const RunSources& sources,
                  const ExactPart& part, RunResult& run) {
  DeviationPatch patch;
  patch.kind = deviation > 0.0 ? DeviationKind::kExcess : DeviationKind::kGouge;
  patch.where = place;
  patch.depth_mm = std::abs(deviation);
  patch.bounds.extend(place);
  patch.maker = at.maker;
  patch.makers = {{at.maker, 1.0, patch.depth_mm, place, Vec3::UnitZ()}};
  run.findings.emplace_back(deviationFinding(patch));
  diagnoseDeviations(sources, &part, {{run.findings.size() - 1, &patch}}, run);
  return run.findings.back();
}

/// The finding of the run that a place belongs to; null: none.
const Finding* findingOf(const Vec3& place, DeviationKind kind, const RunResult& run) {
  for (const DeviationPatch& patch : run.comparison->patches) {
    if (patch.kind != kind || !patch.bounds.inflated(run.resolution_mm).overlaps({place, place})) continue;
    const auto same = std::find_if(run.findings.begin(), run.findings.end(), [&](const Finding& finding) {
      return finding.where == patch.where && finding.depth_mm == patch.depth_mm;
    });
    if (same != run.findings.end() && !same->causes.empty()) return &*same;
  }
  return nullptr;
}

void sayDeviation(Console& console, const Vec3& place, const SettledPoint& at, const RunSources& sources,
                  const ExactPart& part, RunResult& run) {
  const double deviation = static_cast<double>(run.comparison->field->at(at.p));
  if (std::isnan(deviation))
    return say(console, "deviation", "the point is in a region that is not compared");
  const double allowed =
      deviation > 0.0 ? run.comparison->excess_tolerance_mm : run.comparison->gouge_tolerance_mm;
  say(console, "deviation",
      fmt::format("{:.4f} mm {} nominal (allowed {:g} mm)", std::abs(deviation),
                  deviation < 0.0 ? "below" : "above", allowed));
  if (std::abs(deviation) <= allowed) return;
  if (const Finding* told =
          findingOf(at.p, deviation > 0.0 ? DeviationKind::kExcess : DeviationKind::kGouge, run)) {
    for (const Cause& cause : told->causes)
      say(console, cause.left_mm == 0.0 ? "cause" : "could be", report_text::causeLine(cause));
    return;
  }
  for (const Cause& cause : findingAt(place, at, deviation, sources, part, run).causes)
    say(console, "could be", report_text::causeLine(cause));
}

Status explain(const Job& job, const Vec3& place, Console& console, ConsoleProgress& progress) {
  OutputGuard guard;
  if (Status settled = settleInputs(namedInputs(job)); !settled) return settled;
  protectAll(namedInputs(job), guard);
  if (const Status streams = guard.checkStandardOutput(); !streams) return streams;
  const ThreadSupply threads(job.simulation.threads);
  const JobSources sources(job);
  Result<PreparedRun> prepared = prepareRun(job, sources.all(), progress);
  if (!prepared) return prepared.error();
  if (prepared->run.alarm) return inputError("the program ends in an alarm: nothing was cut");
  const StockShape blank = prepared->blank.shape;
  Result<RunResult> run = finishRun(job, sources.all(), std::move(*prepared), progress);
  if (!run) return run.error();
  Result<std::unique_ptr<ExactPart>> part = makeExactPart(blank, *run);
  if (!part) return part.error();
  progress.clear();
  if (*part == nullptr) return inputError("the blank is a stock from a file: its faces are not known");
  constexpr double kReach = 5.0;
  const SettledPoint at = settle(**part, place, kReach);
  say(console, "point", placeText(place));
  if (!at.found)
    return inputError(
        fmt::format("there is no surface of the part within {:g} mm of {}", kReach, placeText(place)));
  say(console, "surface", fmt::format("{}, {:.4f} mm away", placeText(at.p), (at.p - place).norm()));
  const std::size_t number = std::min<std::size_t>(at.maker.setup, run->setups.size() - 1);
  const SetupRun& setup = run->setups[number];
  const Toolpath& path = setup.interpreted.path;
  const bool made = at.maker.motion < path.motions.size();
  if (made) {
    const BlockRef block = writtenBlock(path, at.maker.motion, *sources.all()[number]).block;
    say(console, "made by",
        fmt::format("{}: {}, tool {}", report_text::place(setup.name, block), block.text,
                    path.motions[at.maker.motion].tool));
  } else {
    say(console, "made by", "nothing: it is the blank's own surface");
  }
  if (run->comparison) sayDeviation(console, place, at, sources.all(), **part, *run);
  if (made) {
    for (const Cause& cause : behindMotion(setup, *sources.all()[number], at.maker.motion))
      say(console, "in force", report_text::causeLine(cause));
  }
  return Done{};
}

}  // namespace

int explainCommand(const ExplainOptions& options, Console& console, ConsoleProgress& progress) {
  TimeLimit limit(progress);
  limit.set(options.max_time_s.value_or(0.0));
  const Result<Vec3> place = parseTriple("--at", options.at, 1e6, "a point: X,Y,Z in mm");
  if (!place) return printError(console, place.error());
  const Result<RunOptions> command = commandOf(options.report);
  if (!command) return printError(console, command.error());
  Diagnostics diagnostics;
  std::optional<Job> job = setUpJob(command->program, diagnostics);
  const bool good = job && applyRunOptions(*command, *job, diagnostics);
  if (!good) {
    printDiagnostics(console, diagnostics.all(), Severity::kError);
    return kExitInput;
  }
  limit.set(job->simulation.max_time_s);
  progress.show(options.progress || console.err_is_terminal);
  const Status done = explain(*job, *place, console, progress);
  progress.clear();
  return done ? kExitOk : printError(console, limit.told(done.error()));
}

}  // namespace proveout
