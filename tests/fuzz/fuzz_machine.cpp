// Feeds any text to the reader of machine files; behind a zero byte stands a program, else a small one runs.
// A machine that is taken has no faults, its chain agrees with the control's equations wherever its axes
// stand, and programs of five axes run on it as others do.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/machine/machine_chain.h"
#include "core/nc/kinematics/five_axis_model.h"
#include "io/job/job.h"
#include "tests/fuzz/checking_sink.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

constexpr const char* kProgram =
    "G54 G0 X1 Y2 Z3\nG43.1 H1 Z5\nG68.2 X1 Y2 Z3 I20 J30 K40\nG53.1\nG1 X4 F500\nG69.1 G49\nG10 L21 P1 X1 "
    "Y2 Z3\n"
    "G54.2 P1\nG0 X0 Y0\nG54 G28 Z0\nM30\n";

const ScratchFolder& folder() {
  static const ScratchFolder folder;
  static const bool filled = [] {
    folder.write("closed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
    return true;
  }();
  (void)filled;
  return folder;
}

/// Positions of all axes, within travel, from a seed.
AxisPoint placeOf(const MachineModel& model, std::size_t seed) {
  AxisPoint place;
  for (std::size_t k = 0; k < model.axes.size(); ++k) {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    const double part = static_cast<double>(seed >> 40U) / static_cast<double>(1U << 24U);
    const AxisLimit travel = model.axes[k].travel.value_or(AxisLimit{-200.0, 200.0});
    place[static_cast<int>(k)] = travel.min + part * (travel.max - travel.min);
  }
  return place;
}

double largest(const MachineModel& model) {
  double size = 1.0;
  for (const MachineAxis& axis : model.axes) {
    size = std::max(size, axis.point.norm());
    if (axis.travel) size = std::max({size, std::abs(axis.travel->min), std::abs(axis.travel->max)});
  }
  return std::max(size, model.spindle.gauge.norm());
}

/// The control's tool and tip are those of the chain, and it finds the angles of every direction that it has.
void checkEquations(const MachineModel& model, const MachineChain& chain, const AxisPoint& at) {
  const nc::FiveAxisModel five = nc::fiveAxisModelOf(model);
  if (five.kind == nc::FiveAxisKind::kNone) return;
  const nc::RotaryAngles angles = five.at(at);
  const Vec3 tool = five.toolVector(angles);
  require((tool - chain.toolAxis(at)).norm() < 1e-9, "the control's tool points as the machine's does");
  if (std::abs(five.first_direction.dot(five.second_direction)) < 0.99 || five.second < 0) {
    const nc::FiveAxisModel::Positions found = five.positionsFor(tool, angles);
    require(found.count > 0, "a direction that the tool has is reached");
    for (int k = 0; k < found.count; ++k)
      require((five.toolVector(found.at[static_cast<std::size_t>(k)]) - tool).norm() < 1e-6,
              "both positions give the direction");
  }
  if (!chain.isLevel() || model.spindle.gauge != Vec3::Zero()) return;
  AxisPoint level = at;  // axes beside X, Y and Z that shift the tool are not the control's
  for (std::size_t k = 3; k < model.axes.size(); ++k) {
    if (model.axes[k].kind == AxisKind::kLinear) level[static_cast<int>(k)] = 0.0;
  }
  const Vec3 machine_tip = level.xyz - five.lengthVector(angles, 100.0);
  const nc::FrameStep table = five.workpieceOnTable(angles, Vec3::Zero(), {});
  const Vec3 tip = table.linear * chain.pose(level, 100.0).tip + table.offset;
  require((tip - machine_tip).norm() < 1e-9 * largest(model) + 1e-9, "the control's tip is the machine's");
}

void checkMachine(const MachineModel& model, std::size_t seed) {
  require(machineFaults(model).empty(), "what is taken has no faults");
  const MachineChain chain(model, Vec3::Zero());
  for (std::size_t k = 0; k < 4; ++k) {
    const AxisPoint at = placeOf(model, seed + k);
    const ToolPose pose = chain.pose(at, 100.0);
    require(pose.tip.allFinite() && std::abs(pose.axis.norm() - 1.0) < 1e-9, "a pose is a pose");
    checkEquations(model, chain, at);
  }
}

void runOn(const Job& job, const std::string& program) {
  ControlSettings settings = job.settings;
  settings.block_limit = 300;
  settings.max_errors = 20;
  settings.start = Vec3::Zero();
  settings.work_offsets[0] = Vec3(10, 20, -30);
  settings.length_offsets[1] = {50.0, 0.0};
  settings.gauge_lengths[1] = 60.0;
  settings.tool = 1;
  CheckingSink sink;
  interpret(ControlId::kNct, MemoryProgramSource("main.nc", program), settings, sink);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = bytes.find('\0');
  const std::string file = folder().write("machine.toml", std::string_view(bytes).substr(0, cut));
  Job job, again;
  Diagnostics diagnostics, second;
  loadMachine(file, job, diagnostics);
  loadMachine(file, again, second);
  require(said(diagnostics) == said(second), "a second reading says the same");
  if (diagnostics.hasErrors()) return 0;
  if (job.settings.machine) checkMachine(*job.settings.machine, size);
  runOn(job, cut == std::string::npos ? kProgram : bytes.substr(cut + 1));
  return 0;
}
