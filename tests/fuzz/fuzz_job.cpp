// Feeds any text to the reader of job files, and behind a zero byte another one to that of machine files.
// Paths may name a few files that are there. A job that is taken goes as far as a run's interpretation:
// places of the machine, tools as solids, and small programs under its settings.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "app/job_setup.h"
#include "app/session/programs/interpretation.h"
#include "core/tool/insert.h"
#include "core/tool/tool_solid.h"
#include "io/job/job.h"
#include "tests/fuzz/checking_sink.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

constexpr const char* kProgram =
    "G54 T1 M6\nG0 X1 Y2\nG43 H1 Z3 M3 S500\nG1 X9 F100\nG41 D1 Y9\nM98 P11\nG40 G28 Z0\nM30\n";

const ScratchFolder& folder() {
  static const ScratchFolder folder;
  static const bool filled = [] {
    folder.write("p.nc", kProgram);
    folder.write("q.nc", "G91 G1 Z-1 F50\nM30\n");
    folder.write("O0011.nc", "G1 X3\nM99\n");
    folder.write("m.stl", "solid\nendsolid\n");
    folder.write("s.vdb", "not a stock");
    return true;
  }();
  (void)filled;
  return folder;
}

bool finite(const Vec3& p) { return p.allFinite(); }

void checkTool(const Tool& tool) {
  require(validateTool(tool).ok() && tool.number >= 1, "tools are valid");
  if (tool.type == ToolType::kInsert) {
    require(tool.insert && noseCenter(*tool.insert).allFinite(), "an insert has a nose");
    insertOutline(*tool.insert);
    holderPieces(*tool.insert);
    return;
  }
  if (tool.type == ToolType::kWire) {
    require(tool.diameter > 0.0 && tool.spark_gap >= 0.0, "a wire cuts");
    return;
  }
  const ToolSolid solid = makeToolSolid(tool);
  require(!solid.cutter.empty(), "a tool cuts");
  for (const auto* parts : {&solid.cutter, &solid.shank, &solid.holder}) {
    for (const ConvexProfile& part : *parts) {
      require(std::isfinite(part.maxRadius()) && std::isfinite(part.zMin()) && std::isfinite(part.zMax()) &&
                  part.zMin() <= part.zMax() && part.maxRadius() > 0.0,
              "the parts of a tool are bodies");
    }
  }
}

void checkShape(const StockSpec& spec) {
  if (const auto* box = std::get_if<BoxShape>(&spec)) {
    require(finite(box->min) && finite(box->max) && (box->min.array() < box->max.array()).all(),
            "a box has a volume");
  }
  if (const auto* round = std::get_if<CylinderShape>(&spec)) {
    require(finite(round->base) && std::isfinite(round->radius) && std::isfinite(round->length) &&
                round->radius > round->inner_radius && round->inner_radius >= 0.0 && round->length > 0.0 &&
                round->axis >= 0 && round->axis <= 2,
            "a cylinder has a volume");
  }
}

void checkJob(const Job& job) {
  require(job.stock.has_value() && findControl(job.control).ok(), "a job has a stock and a control");
  checkShape(*job.stock);
  for (const Tool& tool : job.tools) checkTool(tool);
  require(job.channels.empty() || job.setups.empty(), "channels or setups");
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const Job setup = jobOfSetup(job, k);
    require(!programNames(setup).empty() && setup.setups.empty(), "every clamping has a program");
    for (const FixtureSpec& fixture : setup.fixtures) checkShape(fixture.shape);
    if (k > 0) {
      const RigidTransform& move = job.setups[k].from_previous;
      require(move.translation.allFinite() &&
                  (move.rotation * move.rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9,
              "clampings turn and shift");
    }
  }
}

/// The bounds of a blank that is no file.
Box3 boundsOf(const StockSpec& spec) {
  const auto* box = std::get_if<BoxShape>(&spec);
  return box != nullptr ? Box3{box->min, box->max} : Box3{Vec3::Constant(-5), Vec3::Constant(5)};
}

void runPrograms(Job job) {
  const Result<ControlId> control = findControl(job.control);
  job.settings.block_limit = 300;
  for (SetupSpec& setup : job.setups) setup.settings.block_limit = 300;
  for (ChannelSpec& channel : job.channels) channel.settings.block_limit = 300;
  const JobSources sources(job);
  Progress progress;
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const Job setup = jobOfSetup(job, k);
    const ControlSettings settings = controlSettings(setup, boundsOf(*job.stock));
    require(settings.start.allFinite(), "the start is a place");
    CheckingSink sink;
    ControlHost host;
    host.person = setup.person;
    interpretJob(setup, *control, *sources.all()[k], settings, sink, progress, host);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const JobNames names = knownJobNames();
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = bytes.find('\0');
  if (cut != std::string::npos) folder().write("machine.toml", std::string_view(bytes).substr(cut + 1));
  const std::string text = bytes.substr(0, cut), home = folder().path().string();
  Diagnostics diagnostics, second;
  const std::optional<Job> job = parseJob(text, "job.toml", home, names, diagnostics);
  require(job.has_value() != diagnostics.hasErrors(), "a job, or errors");
  const std::optional<Job> again = parseJob(text, "job.toml", home, names, second);
  require(job.has_value() == again.has_value() && said(diagnostics) == said(second),
          "a second reading says the same");
  if (!job) return 0;
  checkJob(*job);
  runPrograms(*job);
  return 0;
}
