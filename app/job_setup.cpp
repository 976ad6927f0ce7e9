#include "app/job_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "app/console.h"
#include "app/input_files.h"
#include "app/offset_options.h"
#include "app/session/run/control_choice.h"
#include "app/session/run/job_defaults.h"
#include "app/session/run/process.h"
#include "app/session/run/recording_source.h"
#include "core/nc/registry/interpreter.h"
#include "io/atomic_file.h"
#include "io/job/template_files.h"
#include "io/step/step_file.h"
#include "render/camera.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

std::optional<UntilBlock> parseUntil(const std::string& text) {
  const bool by_number = !text.empty() && (text[0] == 'N' || text[0] == 'n');
  const char* first = text.data() + (by_number ? 1 : 0);
  const char* last = text.data() + text.size();
  UntilBlock until;
  if (by_number) {
    std::int64_t block = 0;
    const auto [end, error] = std::from_chars(first, last, block);
    if (error != std::errc() || end != last || first == last || block < 0) return std::nullopt;
    until.block = block;
  } else {
    int line = 0;
    const auto [end, error] = std::from_chars(first, last, line);
    if (error != std::errc() || end != last || line < 1) return std::nullopt;
    until.line = line;
  }
  return until;
}

std::optional<Job> jobFromProgram(const ProgramOptions& options, Diagnostics& diagnostics) {
  Job job;
  job.control = options.control.value_or(std::string(kAutoControl));
  job.program = options.input;
  job.name = fs::path(options.input).stem().string();
  job.subprograms = options.subprograms;
  if (const Status readable = checkRegularFile(job.program); !readable) {
    diagnostics.add(usageError(readable.error().message));
  }
  for (const std::string& path : job.subprograms) {
    std::error_code error;
    if (!fs::exists(path, error))
      diagnostics.add(usageError(fmt::format("{}: no such file or folder", path)));
  }
  if (options.machine) {
    if (const Status readable = checkRegularFile(*options.machine); readable)
      loadMachine(*options.machine, job, diagnostics);
    else
      diagnostics.add(usageError("--machine: " + readable.error().message));
  }
  if (nc::isTemplateName(job.program) && !diagnostics.hasErrors())
    fillWithDefaults(job.program, job, diagnostics);
  if (diagnostics.hasErrors()) return std::nullopt;
  return job;
}

/// Takes away the setups behind the named one.
bool keepSetups(const std::string& name, Job& job, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const SetupSpec& setup : job.setups) names.push_back(setup.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    diagnostics.add(usageError(names.empty() ? "--setup: the job has no setups"
                                             : fmt::format("--setup: there is no setup '{}'{}; there are {}",
                                                           name, didYouMean(nearestName(name, names)),
                                                           fmt::join(names, ", "))));
    return false;
  }
  const auto kept = static_cast<std::size_t>(found - names.begin()) + 1;
  job.stops_early = kept < job.setups.size();
  job.setups.erase(job.setups.begin() + static_cast<std::ptrdiff_t>(kept), job.setups.end());
  if (job.stops_early) job.nominal.reset();  // it is the part after the last setup, in that setup's frame
  return true;
}

/// Sets the block at which the (last) program stops.
bool stopAt(const ProgramOptions& options, Job& job, Diagnostics& diagnostics) {
  const auto until = parseUntil(*options.until);
  if (!until) {
    diagnostics.add(usageError(fmt::format(
        "--until: '{}' is neither a line number (120) nor a block number (N70)", *options.until)));
    return false;
  }
  if (job.setups.size() > 1 && !options.setup) {
    diagnostics.add(usageError("--until with a job of several setups needs --setup NAME"));
    return false;
  }
  (job.setups.empty() ? job.settings : job.setups.back().settings).until = until;
  return true;
}

/// Switches and the power-on unit, in every clamping and channel.
void applyPanel(const ProgramOptions& options, Job& job) {
  const auto apply = [&](ControlSettings& settings) {
    if (options.skip) settings.skip_switches[0] = true;
    if (options.program_unit)
      settings.units = *options.program_unit == "inch" ? LengthUnit::kInch : LengthUnit::kMillimetre;
  };
  apply(job.settings);
  for (SetupSpec& setup : job.setups) apply(setup.settings);
  for (ChannelSpec& channel : job.channels) apply(channel.settings);
}

void refuseWithJob(bool given, const char* option, Diagnostics& diagnostics) {
  if (given) {
    diagnostics.add(usageError(fmt::format("{} goes with a program; a job file says this itself", option)));
  }
}

/// Whether the command line can name the tools of the control at all. False: said what it takes.
bool namesTools(const RunOptions& options, const Job& job, Diagnostics& diagnostics) {
  const Process& process = processOf(job.control);
  if (process.words.needs_job == nullptr || (process.names_tools && !options.tools.empty())) return true;
  diagnostics.add(usageError(fmt::format(fmt::runtime(process.words.needs_job), job.control)));
  return false;
}

void applyWorkpiece(const RunOptions& options, Job& job, Diagnostics& diagnostics) {
  if (!options.stock) {
    diagnostics.add(usageError("a program needs --stock SHAPE, for example --stock box:0,0,-20:80,80,0"));
  } else if (Result<StockSpec> stock = parseStockOption(*options.stock); stock) {
    job.stock = std::move(*stock);
  } else {
    diagnostics.add(usageError("--stock: " + stock.error().message));
  }
  if (!namesTools(options, job, diagnostics)) return;
  if (options.tools.empty())
    diagnostics.add(usageError("a program needs a tool, for example --tool 1=ball:6"));
  for (const std::string& text : options.tools) {
    const Result<Tool> tool = parseToolOption(text);
    if (!tool) {
      diagnostics.add(usageError("--tool: " + tool.error().message));
      continue;
    }
    if (tool->number < 1) {
      diagnostics.add(
          usageError("--tool: numbers start at 1, T0 empties the spindle; motions without a T word use the "
                     "lowest number"));
      continue;
    }
    const auto same = [&](const Tool& other) { return other.number == tool->number; };
    if (std::any_of(job.tools.begin(), job.tools.end(), same)) {
      diagnostics.add(usageError(fmt::format("--tool: tool {} is given twice", tool->number)));
    }
    job.tools.push_back(*tool);
  }
  if (options.nominal) {
    job.nominal.emplace();
    job.nominal->mesh.path = *options.nominal;
    if (const Status readable = checkRegularFile(*options.nominal); !readable) {
      diagnostics.add(usageError("--nominal: " + readable.error().message));
    }
  }
}

/// `--unit`: of the meshes that the command line names.
void applyUnit(const std::string& name, Job& job, Diagnostics& diagnostics) {
  const Result<MeshUnit> unit = parseMeshUnit(name);
  auto* stock = job.stock ? std::get_if<MeshFile>(&*job.stock) : nullptr;
  if (!unit) {
    diagnostics.add(usageError("--unit: " + unit.error().message));
  } else if (stock == nullptr && !job.nominal) {
    diagnostics.add(usageError("--unit needs a mesh: --nominal FILE or --stock mesh:FILE"));
  } else {
    bool taken = false;
    for (MeshFile* file : {stock, job.nominal ? &job.nominal->mesh : nullptr}) {
      if (file == nullptr || statesUnit(file->path)) continue;
      file->unit = *unit;
      taken = true;
    }
    if (!taken) diagnostics.add(usageError("--unit: STEP, 3MF and GLB files state their unit themselves"));
  }
}

void applyPlace(const NominalOptions& place, Job& job, Diagnostics& diagnostics) {
  if (!job.nominal) {
    if (!diagnostics.hasErrors())
      diagnostics.add(
          usageError("--nominal-at, --nominal-rotate and --nominal-body need a nominal to compare with"));
    return;
  }
  if (const Status done = applyNominal(place, *job.nominal); !done)
    diagnostics.add(usageError(done.error().message));
}

/// `--deviation`.
void applyDeviation(const std::string& list, Job& job, Diagnostics& diagnostics) {
  Result<std::vector<DeviationOutput>> outputs = parseDeviationOutputs(list);
  if (!outputs) {
    diagnostics.add(usageError("--deviation: " + outputs.error().message));
  } else if (!job.nominal) {
    if (!diagnostics.hasErrors())
      diagnostics.add(usageError(job.stops_early
                                     ? "--deviation needs a nominal, and that is of the last setup"
                                     : "--deviation needs a nominal to compare with"));
  } else {
    job.output.deviation = std::move(*outputs);
  }
}

void applyOutput(const RunOptions& options, Job& job, Diagnostics& diagnostics) {
  if (options.formats) {
    Result<std::vector<OutputFormat>> formats = parseOutputFormats(*options.formats);
    if (formats) job.output.formats = std::move(*formats);
    if (!formats) diagnostics.add(usageError("--format: " + formats.error().message));
  }
  if (options.csv) job.output.csv = true;
  if (options.deviation) applyDeviation(*options.deviation, job, diagnostics);
  if (options.bodies) job.output.bodies = true;
  if (options.no_view3d || options.no_render) job.output.view3d = false;
  const bool pictures = !options.views.empty() || options.size;
  if (options.no_render && pictures) diagnostics.add(usageError("--no-render contradicts --view and --size"));
  if (!options.views.empty() || options.no_render) job.output.views.clear();  // no view, no picture
  for (const std::string& name : options.views) {
    const Result<View> view = findView(name);
    if (!view) diagnostics.add(usageError("--view: " + view.error().message));
    if (std::find(job.output.views.begin(), job.output.views.end(), name) == job.output.views.end()) {
      job.output.views.push_back(name);
    }
  }
  if (options.size) {
    const Result<ImageSize> size = parseImageSize(*options.size);
    if (!size) {
      diagnostics.add(usageError("--size: " + size.error().message));
      return;
    }
    job.output.width = size->width;
    job.output.height = size->height;
  }
}

/// Lets the programs of the job tell their controls.
Status tellControls(Job& job) {
  if (Status settled = settleInputs(namedInputs(job)); !settled) return settled;
  const JobSources sources(job);
  return chooseControls(job, {sources.all().begin(), sources.all().end()});
}

}  // namespace

JobNames knownJobNames() {
  JobNames names = jobNames();
  names.views = viewNames();
  return names;
}

bool isJobFile(const std::string& path) { return fs::path(path).extension() == ".toml"; }

std::optional<Job> setUpJob(const ProgramOptions& options, Diagnostics& diagnostics) {
  std::optional<Job> job;
  if (isJobFile(options.input)) {
    refuseWithJob(options.control.has_value(), "--control", diagnostics);
    refuseWithJob(!options.subprograms.empty(), "--subprograms", diagnostics);
    refuseWithJob(options.machine.has_value(), "--machine", diagnostics);
    if (diagnostics.hasErrors()) return std::nullopt;
    job = loadJob(options.input, knownJobNames(), diagnostics);
  } else {
    job = jobFromProgram(options, diagnostics);
  }
  if (!job) return std::nullopt;
  if (leavesControl(*job)) {
    if (const Status told = tellControls(*job); !told) {
      diagnostics.add(usageError(told.error().message));
      return std::nullopt;
    }
  }
  for (const std::string& name : controlsOf(*job)) {
    if (const Result<ControlId> control = findControl(name); !control) {
      diagnostics.add(usageError(control.error().message));
      return std::nullopt;
    }
  }
  if (options.lenient) {
    job->settings.lenient = true;
    for (SetupSpec& setup : job->setups) setup.settings.lenient = true;
  }
  const int before = diagnostics.errorCount();
  applyOffsets(options.offsets, *job, diagnostics);
  applyPanel(options, *job);
  if (diagnostics.errorCount() != before) return std::nullopt;
  if (options.setup && !keepSetups(*options.setup, *job, diagnostics)) return std::nullopt;
  if (options.until && !stopAt(options, *job, diagnostics)) return std::nullopt;
  return job;
}

bool applyRunOptions(const RunOptions& options, Job& job, Diagnostics& diagnostics) {
  const int before = diagnostics.errorCount();
  if (!job.path.empty()) {
    refuseWithJob(options.stock.has_value(), "--stock", diagnostics);
    refuseWithJob(!options.tools.empty(), "--tool", diagnostics);
    refuseWithJob(options.nominal.has_value(), "--nominal", diagnostics);
    refuseWithJob(options.unit.has_value(), "--unit", diagnostics);
  } else {
    applyWorkpiece(options, job, diagnostics);
    if (options.unit) applyUnit(*options.unit, job, diagnostics);
  }
  if (options.place.given()) applyPlace(options.place, job, diagnostics);
  if (options.tolerance_mm) {
    if (job.nominal) {
      job.nominal->gouge_mm = job.nominal->excess_mm = *options.tolerance_mm;
    } else if (!diagnostics.hasErrors()) {
      diagnostics.add(usageError("--tolerance needs a nominal mesh to compare with"));
    }
  }
  if (options.resolution_mm) job.simulation.resolution_mm = *options.resolution_mm;
  if (const auto causes = causeSearchNamed(options.causes.value_or(""))) job.simulation.causes = *causes;
  if (options.simplify_mm) job.simulation.simplify_mm = *options.simplify_mm;
  if (options.threads) job.simulation.threads = *options.threads;
  if (options.max_memory_gb) job.simulation.max_memory_gb = *options.max_memory_gb;
  applyOutput(options, job, diagnostics);
  return diagnostics.errorCount() == before;
}

std::string outputFolder(const RunOptions& options, const Job& job) {
  if (options.out) return *options.out;
  const fs::path beside = job.path.empty() ? fs::path() : fs::path(job.path).parent_path();
  return (beside / (fileName(job.name) + "-out")).string();
}

std::string fileName(const std::string& name) {
  std::string file = name.empty() || name.front() == '.' ? "_" : "";
  for (const char c : name) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-' || (c & 0x80);
    file += plain ? c : '_';
  }
  return file;
}

}  // namespace proveout
