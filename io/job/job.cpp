#include "io/job/job.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/base/assert.h"
#include "core/base/memory_limit.h"
#include "io/atomic_file.h"
#include "io/job/config_table.h"
#include "io/job/job_sections.h"
#include "io/job/template_files.h"

namespace proveout {

namespace fs = std::filesystem;

const std::vector<std::string>& encodingNames() {
  static const std::vector<std::string> kNames = {"auto", "utf-8", "koi8-r", "cp1251", "gb18030"};
  return kNames;
}

std::optional<TextEncoding> encodingNamed(std::string_view name) {
  constexpr std::array kEncodings{TextEncoding::kAuto, TextEncoding::kUtf8, TextEncoding::kKoi8R,
                                  TextEncoding::kCp1251, TextEncoding::kGb18030};
  const auto& names = encodingNames();
  PROVEOUT_ASSERT(names.size() == kEncodings.size());
  const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  return at < names.size() ? std::optional(kEncodings[at]) : std::nullopt;
}

namespace {

constexpr std::size_t kMaxJobBytes = 8u << 20;

void readHead(ConfigTable& root, Job& job) {
  root.must("schema").choice("schema", {"proveout.job/1"});
  if (const auto name = root.text("name")) job.name = *name;
  if (const auto encoding = root.choice("encoding", encodingNames()))
    job.settings.encoding = *encodingNamed(*encoding);
  if (const auto units = root.choice("units", {"mm", "inch"})) {
    job.settings.units = *units == "inch" ? LengthUnit::kInch : LengthUnit::kMillimetre;
  }
}

/// `max_memory_gb` of [simulation]; 0: none. What is wrong with it is told where that is read.
double memoryGb(const ConfigValue& tree) {
  for (const ConfigEntry& section : tree.entries) {
    if (section.key != "simulation") continue;
    for (const ConfigEntry& entry : section.value.entries) {
      if (entry.key == "max_memory_gb") return entry.value.number;
    }
  }
  return 0.0;
}

}  // namespace

void readProgram(ConfigTable& table, Job& job) {
  const bool named = table.document().programs_in_memory;
  if (table.find("template") != nullptr)
    readTemplateUse(table, job);
  else if (const auto program =
               named ? table.must("program").text("program") : table.must("program").path("program"))
    job.program = *program;
  if (!job.filled && !named && nc::isTemplateName(job.program))
    fillWithDefaults(job.program, job, *table.document().diagnostics);
  const std::vector<ConfigValue>* subprograms = table.list("subprograms", kMostTables);
  if (subprograms == nullptr) return;
  for (const ConfigValue& item : *subprograms) {
    const auto path = readPath(table.document(), item, "an entry of subprograms", PathKind::kFileOrFolder);
    if (path) job.subprograms.push_back(*path);
  }
}

std::string programNames(const Job& job) {
  if (job.channels.empty()) return job.program;
  std::string names;
  for (const ChannelSpec& channel : job.channels) names += (names.empty() ? "" : ", ") + channel.program;
  return names;
}

bool savesStock(const Job& job) {
  const auto& formats = job.output.formats;
  return std::find(formats.begin(), formats.end(), OutputFormat::kVdb) != formats.end();
}

bool writesBodies(const Job& job) {
  return job.output.bodies.value_or(job.part_point.has_value() && !job.nominal.has_value());
}

bool wantsView(const Job& job) { return job.output.view3d.value_or(!job.output.views.empty()); }

std::size_t setupCount(const Job& job) { return job.setups.empty() ? 1 : job.setups.size(); }

std::vector<std::string> controlsOf(const Job& job) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const bool own = k < job.setups.size() && !job.setups[k].control.empty();
    const std::string& name = own ? job.setups[k].control : job.control;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

Job jobOfSetup(const Job& job, std::size_t index) {
  Job part = job;
  std::vector<SetupSpec>().swap(part.setups);  // their memory, too: a run holds such a job for each of them
  if (job.setups.empty()) return part;
  PROVEOUT_ASSERT(index < job.setups.size());
  const SetupSpec& setup = job.setups[index];
  if (!setup.control.empty()) part.control = setup.control;
  if (!setup.control_note.empty() || !setup.control.empty()) part.control_note = setup.control_note;
  if (!setup.tools.empty()) part.tools = setup.tools;
  part.program = setup.program;
  part.filled = setup.filled;
  part.subprograms = setup.subprograms;
  part.settings = setup.settings;
  part.limits = setup.limits;
  part.start = setup.start;
  part.fixtures = setup.fixtures;
  return part;
}

std::optional<Job> parseJob(std::string_view text, const std::string& text_name, const std::string& folder,
                            const JobNames& names, Diagnostics& diagnostics) {
  const int errors_before = diagnostics.errorCount();
  const ConfigDocument document{splitConfigText(text_name, text), folder, &diagnostics,
                                names.programs_in_memory};
  const std::optional<ConfigValue> tree = parseToml(text, document.text, diagnostics);
  if (!tree) return std::nullopt;

  const MemoryLimit memory(1e9 * memoryGb(*tree));  // templates are filled while the job is read
  Job job;
  ConfigTable root(document, *tree, "the job file");
  readHead(root, job);
  if (root.find("setup") == nullptr && root.find("channel") == nullptr) readProgram(root, job);
  readControl(root, names, job);
  readMachine(root, job);
  readStock(root, job);
  readNominal(root, job);
  readCharacteristics(root, job);
  readTools(root, job);
  readOffsets(root, job);
  readPlacement(root, job);
  readPanel(root, job);
  readSimulation(root, job);
  readSeverities(root, job);
  readOutput(root, names, job);
  readReport(root, job);
  readFixtures(root, job);
  readSetups(root, names, job);
  readChannels(root, names, job);
  root.refuseOthers();
  if (diagnostics.errorCount() != errors_before) return std::nullopt;
  return job;
}

std::optional<Job> loadJob(const std::string& path, const JobNames& names, Diagnostics& diagnostics) {
  const Result<std::string> text = readWholeFile(path, kMaxJobBytes);
  if (!text) {
    Diagnostic d;
    d.code = "job-file";
    d.message = text.error().message;
    diagnostics.add(std::move(d));
    return std::nullopt;
  }
  const fs::path file(path);
  std::optional<Job> job = parseJob(*text, path, file.parent_path().string(), names, diagnostics);
  if (!job) return std::nullopt;
  job->path = path;
  if (job->name.empty()) job->name = file.stem().string();
  return job;
}

}  // namespace proveout
