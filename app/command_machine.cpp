#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <sstream>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/input_files.h"
#include "app/job_setup.h"
#include "core/base/printable.h"
#include "core/geometry/place_text.h"
#include "core/machine/machine_chain.h"
#include "core/machine/reach.h"
#include "core/nc/kinematics/five_axis_model.h"
#include "io/atomic_file.h"
#include "io/job/machine_file.h"
#include "io/png.h"
#include "render/machine_drawing.h"
#include "render/render.h"

namespace proveout {

namespace {

std::string vectorText(const Vec3& v) { return fmt::format("{:.4f}, {:.4f}, {:.4f}", v.x(), v.y(), v.z()); }

std::string travelText(const MachineAxis& axis) {
  return axis.travel ? fmt::format("{:g} to {:g}", axis.travel->min, axis.travel->max)
                     : std::string("endless");
}

void printAxis(Console& console, const MachineModel& model, const MachineAxis& axis) {
  const bool rotary = axis.kind == AxisKind::kRotary;
  const std::string on = axis.on == kOnBed ? "bed" : model.axes[static_cast<std::size_t>(axis.on)].name;
  const char* side = axis.side == AxisSide::kTool   ? "tool"
                     : axis.side == AxisSide::kPart ? "part"
                                                    : "nothing";
  console.out << fmt::format("  {:<3} {:<6} on {:<4} carries {:<7} travel {} {}\n", axis.name,
                             rotary ? "rotary" : "linear", on, side, travelText(axis), rotary ? "deg" : "mm");
  console.out << fmt::format("      direction {}", vectorText(axis.direction));
  if (rotary)
    console.out << fmt::format(", through {}, turns {}-handed{}", placeText(axis.point),
                               axis.left ? "left" : "right",
                               axis.clamped ? ", clamped while a tool cuts" : "");
  console.out << '\n';
}

const char* kindText(nc::FiveAxisKind kind) {
  switch (kind) {
    case nc::FiveAxisKind::kHeadHead:
      return "head-head";
    case nc::FiveAxisKind::kTableTable:
      return "table-table";
    case nc::FiveAxisKind::kHeadTable:
      return "head-table";
    case nc::FiveAxisKind::kNone:
      break;
  }
  return "no rotary axes, or more than two";
}

/// "t_y 0.0000 to 1.0000".
void printReach(Console& console, const MachineModel& model) {
  const ToolReach reach = toolReach(model);
  console.out << fmt::format("tool directions, seen from the part: tilted by up to {:.1f} degrees\n",
                             reach.most_tilt_deg);
  for (int k = 0; k < 3; ++k) {
    // Without the rounding of angles: -0.0000 is 0.
    const double low = std::abs(reach.least[k]) < 5e-5 ? 0.0 : reach.least[k],
                 high = std::abs(reach.largest[k]) < 5e-5 ? 0.0 : reach.largest[k];
    console.out << fmt::format(
        "  t_{} {:.4f} to {:.4f}{}\n", "xyz"[k], low, high,
        low >= 0.0 && high > 0.0   ? fmt::format(": none with a negative {} part", "XYZ"[k])
        : high <= 0.0 && low < 0.0 ? fmt::format(": none with a positive {} part", "XYZ"[k])
                                   : std::string());
  }
}

void printMachine(Console& console, const MachineModel& model) {
  console.out << fmt::format("{}\n", model.name.empty() ? "machine" : printable(model.name));
  for (const MachineAxis& axis : model.axes) printAxis(console, model, axis);
  const SpindleMount& spindle = model.spindle;
  console.out << fmt::format(
      "  spindle on {}, gauge point {} from the control point, tool along {}\n",
      spindle.on == kOnBed ? "bed" : model.axes[static_cast<std::size_t>(spindle.on)].name,
      placeText(spindle.gauge), vectorText(spindle.direction));
  for (const MachineBody& body : model.bodies)
    console.out << fmt::format(
        "  body {} on {}\n", body.name,
        body.on == kOnBed ? "bed" : model.axes[static_cast<std::size_t>(body.on)].name);
  const nc::FiveAxisModel five = nc::fiveAxisModelOf(model);
  console.out << fmt::format("structure: {}", kindText(five.kind));
  if (five.first >= 0)
    console.out << fmt::format(", first {}", model.axes[static_cast<std::size_t>(five.first)].name);
  if (five.second >= 0)
    console.out << fmt::format(", second {}", model.axes[static_cast<std::size_t>(five.second)].name);
  console.out << '\n';
  printReach(console, model);
}

/// "X0 Y0 Z100 A30 C60". Errors: no such axis, no number.
Result<AxisPoint> parsePosition(const MachineModel& model, const std::string& text) {
  AxisPoint at;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    int axis = -1;
    std::size_t length = 0;
    for (std::size_t k = 0; k < model.axes.size(); ++k) {
      const std::string& name = model.axes[k].name;
      if (!word.starts_with(name) || name.size() <= length) continue;
      axis = static_cast<int>(k);
      length = name.size();
    }
    double value = 0.0;
    const char* begin = word.data() + length;
    const char* end = word.data() + word.size();
    if (begin != end && *begin == '=') ++begin;
    const auto [last, failed] = std::from_chars(begin, end, value);
    if (axis < 0 || failed != std::errc() || last != end || !(std::abs(value) <= 1e7))
      return inputError(
          fmt::format("--at: '{}' is no axis of the machine with a number, as in \"X0 Z100 A30\"", word));
    at[axis] = value;
  }
  return at;
}

void printPose(Console& console, const MachineModel& model, const AxisPoint& at, double gauge_length,
               const Vec3& zero) {
  const MachineChain chain(model, zero);
  const ToolPose pose = chain.pose(at, gauge_length);
  std::string words;
  for (std::size_t k = 0; k < model.axes.size(); ++k)
    words += fmt::format("{}{}{:g}", k > 0 ? " " : "", model.axes[k].name, at[static_cast<int>(k)]);
  console.out << fmt::format("at {}, tool {:g} mm before the gauge point\n", words, gauge_length);
  console.out << fmt::format("  tip, seen from the part     {}\n", placeText(pose.tip));
  console.out << fmt::format("  tool, from tip to holder    {}\n", vectorText(pose.axis));
  console.out << fmt::format("  control point, machine      {}\n", placeText(at.xyz));
  for (std::size_t k = 0; k < model.axes.size(); ++k) {
    const MachineAxis& axis = model.axes[k];
    const double value = at[static_cast<int>(k)];
    if (axis.travel && (value < axis.travel->min || value > axis.travel->max))
      console.out << fmt::format("  {} is out of travel ({})\n", axis.name, travelText(axis));
  }
}

Status drawMachine(const MachineModel& model, const std::string& output, Progress& progress) {
  const TriMesh mesh = machineDrawing(model);
  const Result<View> view = findView("iso");
  if (!view) return view.error();
  RenderScene scene(mesh);
  RenderOptions settings;
  settings.ground = false;
  const Result<Image> image = renderMesh(scene, *view, {1200, 900}, settings, progress);
  if (!image) return image.error();
  return writePng(*image, output);
}

/// Length of a tool of the job and where its workpiece lies.
struct ToolOfJob {
  double gauge_length = 0.0;
  Vec3 zero = Vec3::Zero();
};
Result<ToolOfJob> toolOfJob(const MachineOptions& options, Console& console) {
  ToolOfJob out;
  if (!options.job) return out;
  Diagnostics diagnostics;
  const std::optional<Job> job = loadJob(*options.job, knownJobNames(), diagnostics);
  printDiagnostics(console, diagnostics.all());
  if (!job) return inputError(*options.job + " cannot be used");
  out.zero = workpieceZero(job->settings);
  if (!options.tool) return out;
  for (const Tool& tool : job->tools) {
    if (tool.number != *options.tool) continue;
    out.gauge_length = tool.gauge_length;
    return out;
  }
  return inputError(fmt::format("{} has no tool {}", *options.job, *options.tool));
}

}  // namespace

int machineCommand(const MachineOptions& options, Console& console, ConsoleProgress& progress) {
  Job job;
  Diagnostics diagnostics;
  loadMachine(options.file, job, diagnostics);
  printDiagnostics(console, diagnostics.all());
  if (diagnostics.hasErrors()) return kExitInput;
  if (!job.settings.machine) {
    return printError(console,
                      inputError(fmt::format("{}: no machine: a file with schema = \"{}\" names axes and "
                                             "spindle, see docs/reference/job-machine.md",
                                             options.file, kMachineSchema)));
  }
  const MachineModel& model = *job.settings.machine;
  if (options.at) {
    const Result<AxisPoint> at = parsePosition(model, *options.at);
    if (!at) return printError(console, at.error());
    const Result<ToolOfJob> tool = toolOfJob(options, console);
    if (!tool) return printError(console, tool.error());
    printPose(console, model, *at, tool->gauge_length, tool->zero);
  } else {
    printMachine(console, model);
  }
  if (options.picture) {
    if (const Status drawn = drawMachine(model, *options.picture, progress); !drawn)
      return printError(console, drawn.error());
  }
  return kExitOk;
}

}  // namespace proveout
