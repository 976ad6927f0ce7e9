// Feeds any words to the command line: lines of the input are its words. Options that are taken must be
// sound, the words that a report keeps of them must mean the same, and no text may crash a reader of one
// option.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/cli_options.h"
#include "app/job_setup.h"
#include "app/session/run/job_defaults.h"
#include "core/base/printable.h"
#include "core/tool/tool_solid.h"
#include "io/job/job.h"
#include "io/mesh_io.h"
#include "render/camera.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

std::vector<std::string> lines(std::string_view text) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t end = text.find('\n');
    out.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + 1);
  }
}

void checkTool(const std::string& text) {
  const Result<Tool> tool = parseToolOption(text);
  if (!tool) return require(!tool.error().message.empty(), "a refusal has a reason");
  require(validateTool(*tool).ok() && tool->number >= 0, "tools are valid");
  const ToolSolid solid = makeToolSolid(*tool);
  require(!solid.cutter.empty(), "a tool cuts");
  for (const ConvexProfile& part : solid.cutter) {
    require(std::isfinite(part.maxRadius()) && std::isfinite(part.zMax()) && part.maxRadius() > 0.0 &&
                part.zMin() < part.zMax(),
            "a cutter is a body");
    const ProfileSample middle = part.sample(0.0, 0.5 * (part.zMin() + part.zMax()));
    require(std::isfinite(middle.value) && middle.value < 0.0, "the middle of a cutter is in it");
    const ProfileSample above = part.sample(part.maxRadius(), part.zMax() + 1.0);
    require(above.value > 0.0, "what is above a cutter is not in it");
  }
}

void checkStock(const std::string& text) {
  const Result<StockSpec> stock = parseStockOption(text);
  if (!stock) return require(!stock.error().message.empty(), "a refusal has a reason");
  if (const auto* box = std::get_if<BoxShape>(&*stock)) {
    require(box->min.allFinite() && box->max.allFinite() && (box->min.array() < box->max.array()).all(),
            "a box has a volume");
    const Box3 bounds{box->min, box->max};
    require(defaultResolution(bounds) > 0.0 && std::isfinite(defaultResolution(bounds)), "a grid is found");
    require(defaultStart(bounds).z() > box->max.z(), "the start is above the blank");
  }
  if (const auto* round = std::get_if<CylinderShape>(&*stock)) {
    require(round->base.allFinite() && round->radius > round->inner_radius && round->inner_radius >= 0.0 &&
                round->length > 0.0 && std::isfinite(round->length) && std::isfinite(round->radius),
            "a cylinder has a volume");
  }
}

/// Every option's reader gets the text.
void readOne(const std::string& text) {
  checkTool(text);
  checkStock(text);
  if (const auto formats = parseOutputFormats(text)) {
    require(!formats->empty(), "a list of formats names one");
    std::string list;
    for (const OutputFormat format : *formats)
      list += (list.empty() ? "" : ",") + std::string(outputFormatName(format));
    require(list == text, "formats are called by their names");
  }
  if (const auto unit = parseMeshUnit(text)) require(meshUnitInMm(*unit) > 0.0, "a unit is a length");
  if (const auto size = parseImageSize(text)) require(validateImageSize(*size).ok(), "a size is in range");
  if (const auto view = findView(text))
    require(std::abs(view->back.norm() - 1.0) < 1e-12, "a view has a direction");
  require(fileName(text).find('/') == std::string::npos, "file names have no folder");
  require(printable(printable(text)) == printable(text), "what is printable stays");
}

/// What a report keeps of a command must mean the same when `explain` reads it.
void checkKept(const RunOptions& options) {
  const std::vector<std::string> kept = decidingArguments(options);
  const CommandLine again = parseCommandLine(kept);
  const auto* run = again.command ? std::get_if<RunOptions>(&*again.command) : nullptr;
  require(run != nullptr, "what a report keeps of a command is a command");
  require(decidingArguments(*run) == kept, "what a report keeps of a command means the same");
}

void checkRun(const RunOptions& options) {
  checkKept(options);
  Diagnostics diagnostics;
  ProgramOptions program = options.program;
  program.input = "/dev/null";  // no regular file: the job is made by hand below
  require(!setUpJob(program, diagnostics) && diagnostics.hasErrors(), "a device is no program");
  Job job;
  job.control = program.control.value_or("nct");
  job.program = "p.nc";
  Diagnostics said;
  const bool taken = applyRunOptions(options, job, said);
  require(taken != said.hasErrors(), "options are taken, or an error says why not");
  if (!taken) return;
  require(job.stock.has_value() && !job.tools.empty(), "a run has a blank and a tool");
  require(job.output.width >= kMinImageSide && job.output.height <= kMaxImageSide, "pictures have a size");
  require(job.simulation.threads >= 0, "threads are counted");
  require(!outputFolder(options, job).empty(), "the results have a place");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> words = lines({reinterpret_cast<const char*>(data), size});
  for (const std::string& word : words) readOne(word);
  const CommandLine line = parseCommandLine(words);
  require(line.command.has_value() || !line.output.empty() || !line.errors.empty(),
          "a command, or a text for people");
  require(line.command.has_value() || line.exit_code == 0 || line.exit_code == 2, "bad usage is exit 2");
  if (!line.command) return 0;
  if (const auto* run = std::get_if<RunOptions>(&*line.command)) checkRun(*run);
  return 0;
}
