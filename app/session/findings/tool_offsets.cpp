#include "app/session/findings/tool_offsets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "app/session/findings/blame.h"
#include "app/session/run/process.h"
#include "core/path/origin_query.h"
#include "core/tool/tool_table.h"
#include "io/report_text.h"

namespace proveout {
namespace {

using report_text::figure;

const Tool* toolOf(const SetupRun& setup, MotionId motion) {
  return ToolTable(setup.job.tools).find(setup.interpreted.path.motions[motion].tool);
}

bool cuts(const SetupRun& setup, MotionId id) {
  const Motion& motion = setup.interpreted.path.motions[id];
  return motion.kind != MotionKind::kRapid && motion.kind != MotionKind::kProbe &&
         id < setup.removal.removed_mm3.size() && setup.removal.removed_mm3[id] > 0.0F;
}

/// How far off a tool stands by its offset, the first time that it cuts with it.
struct LengthError {
  MotionId motion = kNoMotion;
  Vec3 off = Vec3::Zero();  ///< offset less gauge, mm
  bool by_offset = false;   ///< a length offset is in force
  std::string what;
};

bool isGauged(const Tool& tool) {
  return tool.insert ? tool.insert->gauge.has_value() : tool.gauge_length != 0.0;
}

/// From the control point to the gauge point, mm: so much less the offset of a tool has to make up for.
Vec3 machineGauge(const SetupRun& setup) {
  const std::optional<MachineModel>& machine = setup.job.settings.machine;
  return machine ? machine->spindle.gauge : Vec3(Vec3::Zero());
}

std::string shiftText(const DataInForce& data, const Tool& tool, const Vec3& machine) {
  if (data.nose_tool > 0) {
    const Vec3 gauge = gaugeOf(tool);
    return fmt::format("DXW.{0} and DZW.{0} are {1:g} and {2:g}, its gauge [{3:g}, {4:g}]", data.nose_tool,
                       data.tool_offset.x(), data.tool_offset.z(), gauge.x(), gauge.z());
  }
  if (data.length.row == 0)
    return fmt::format("it cuts without a length offset, its gauge length is {:g}", tool.gauge_length);
  return fmt::format(
      "H{} is {:g}, its gauge length {:g}{}", data.length.row, data.length_offset.z(), tool.gauge_length,
      machine.z() != 0.0 ? fmt::format(" less the machine's {:g}", machine.z()) : std::string());
}

/// What moves the tool by what the operator has measured: a wear is meant.
Vec3 measuredOffset(const DataInForce& data) {
  Vec3 offset = data.length_offset + data.tool_offset;
  const double sign = data.length_offset.z() * data.length.value() < 0.0 ? -1.0 : 1.0;  // G44
  if (data.length.row > 0) offset.z() -= sign * data.length.wear;
  return offset;
}

std::vector<LengthError> lengthErrors(const SetupRun& setup) {
  std::vector<LengthError> errors;
  std::set<std::pair<int, const DataInForce*>> seen;
  for (MotionId id = 0; id < setup.interpreted.path.motions.size(); ++id) {
    const DataInForce* data = dataOf(setup.interpreted.path, id);
    const Tool* tool = data == nullptr ? nullptr : toolOf(setup, id);
    if (tool == nullptr || !isGauged(*tool) || !cuts(setup, id)) continue;
    if (!seen.emplace(tool->number, data).second) continue;
    errors.push_back({id, measuredOffset(*data) - (gaugeOf(*tool) - machineGauge(setup)),
                      data->length.row > 0, shiftText(*data, *tool, machineGauge(setup))});
  }
  return errors;
}

/// The difference that most of them have, two at least: the work offset may make up for it. Else none.
Vec3 commonOf(const std::vector<LengthError>& errors, double least_mm) {
  const auto count = [&](const Vec3& off) {
    return std::count_if(errors.begin(), errors.end(),
                         [&](const LengthError& e) { return (e.off - off).norm() <= least_mm; });
  };
  Vec3 best = Vec3::Zero();
  auto most = std::max<std::ptrdiff_t>(count(best), 1);
  for (const LengthError& error : errors) {
    const auto now = count(error.off);
    if (now <= most) continue;
    most = now;
    best = error.off;
  }
  return best;
}

std::string wayText(const Vec3& off) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(off[k]) > 1e-6)
      text += fmt::format(" {}{}{}", "XYZ"[k], off[k] < 0.0 ? "-" : "+", figure(std::abs(off[k])));
  }
  return text;
}

/// A single tool may be set up without its offset, by the work offset alone.
bool mayBeMeant(const std::vector<LengthError>& errors, const LengthError& error, bool turned) {
  return errors.size() == 1 && !turned && !error.by_offset;
}

void addLengths(const SetupRun& setup, double least_mm, const RecordingSource& texts,
                std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  const std::vector<LengthError> errors = lengthErrors(setup);
  const Vec3 common = commonOf(errors, least_mm);
  std::set<int> told;
  for (const LengthError& error : errors) {
    const Vec3 off = error.off - common;
    const int tool = path.motions[error.motion].tool;
    if (off.norm() <= least_mm || mayBeMeant(errors, error, partTurns(setup))) continue;
    if (!told.insert(tool).second) continue;
    Finding finding(FindingKind::kToolData);
    finding.where = path.motions[error.motion].to;
    finding.depth_mm = off.norm();
    finding.message =
        fmt::format("tool {}: {}: all that it cuts is off by{} mm", tool, error.what, wayText(off));
    blame(finding, error.motion, path, texts);
    findings.push_back(std::move(finding));
  }
}

/// Shifts that nothing in the job can be held against.
void addUngaugedShifts(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  std::set<int> told;
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    const DataInForce* data = dataOf(path, id);
    if (data == nullptr || data->tool_offset.isZero() || !cuts(setup, id)) continue;
    const Tool* tool = toolOf(setup, id);
    if (tool == nullptr || isGauged(*tool) || !told.insert(tool->number).second) continue;
    Finding finding(FindingKind::kToolData);
    finding.severity = Severity::kNote;
    finding.where = path.motions[id].to;
    finding.message = fmt::format(
        "tool {}: DXW.{} and DZW.{} shift it by{} mm; the job gives no gauge to hold that against",
        tool->number, data->nose_tool, data->nose_tool, wayText(data->tool_offset));
    blame(finding, id, path, texts);
    findings.push_back(std::move(finding));
  }
}

/// What is wrong with a corrector of a milling cutter; empty: nothing that could not be meant.
std::string correctorFault(double corrector, double radius) {
  const double wear = std::max(0.5, 0.1 * radius);
  if (std::abs(corrector - radius) <= wear || std::abs(corrector) <= wear) return {};
  if (std::abs(corrector - 2.0 * radius) <= 1e-3)
    return fmt::format("the diameter of the cutter: its radius is {:g}", radius);
  if (corrector > radius) return {};  // an allowance
  return fmt::format("neither the cutter's radius {:g} nor a wear: contours are cut {} mm too deep", radius,
                     figure(radius - corrector));
}

/// Whether somebody has said the value of the row: the job, `--offset`, or the program (G10, #13001).
bool isGiven(const OffsetInForce& row, const Job& job) {
  if (row.geometry_by != 0 || row.wear_by != 0) return true;
  const auto has = [&](const ControlSettings& settings) { return settings.radius_offsets.contains(row.row); };
  return has(job.settings) || std::any_of(job.channels.begin(), job.channels.end(),
                                          [&](const ChannelSpec& channel) { return has(channel.settings); });
}

/// What is said of compensation by a radius of 0 that nobody has entered.
std::string missingText(const OffsetInForce& row, double radius) {
  const std::string deep =
      fmt::format("contours are cut {} mm too deep, the radius of the tool", figure(radius));
  if (row.row == 0)
    return fmt::format(
        "G41 or G42 without a D, or with D0, compensates by 0: {}; name its row with D, or write G40 "
        "where the middle of the tool is meant to follow the contour",
        deep);
  return fmt::format(
      "D{0} has no value, 0 is taken: {1}; enter {0} = {2:g} in [offsets.radius] (--offset D{0}={2:g}), "
      "or 0 where the program moves the middle of the tool",
      row.row, deep, radius);
}

void addCorrectors(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  std::set<std::pair<int, int>> told;
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    if (!path.motions[id].compensated) continue;
    const DataInForce* data = dataOf(path, id);
    const Tool* tool = ToolTable(setup.job.tools).ofMotion(path.motions[id].tool);
    // Wires have offsets of another kind, which wire_findings.h looks at.
    if (data == nullptr || tool == nullptr || tool->insert || tool->type == ToolType::kWire) continue;
    if (!cuts(setup, id)) continue;
    if (!told.emplace(tool->number, data->radius.row).second) continue;
    const double radius = 0.5 * tool->diameter;
    const bool missing = data->radius.value() == 0.0 && !isGiven(data->radius, setup.job);
    const std::string fault =
        missing ? missingText(data->radius, radius) : correctorFault(data->radius.value(), radius);
    if (fault.empty()) continue;
    Finding finding(FindingKind::kToolData);
    finding.severity = missing ? Severity::kError : Severity::kWarning;
    finding.where = path.motions[id].to;
    if (missing) finding.depth_mm = radius;
    finding.message = missing ? fmt::format("tool {}: {}", tool->number, fault)
                              : fmt::format("tool {}: D{} is {:g}, {}", tool->number, data->radius.row,
                                            data->radius.value(), fault);
    blame(finding, id, path, texts);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

void addToolOffsets(const SetupRun& setup, double least_mm, const RecordingSource& texts,
                    std::vector<Finding>& findings) {
  addLengths(setup, least_mm, texts, findings);
  addUngaugedShifts(setup, texts, findings);
  if (!partTurns(setup)) addCorrectors(setup, texts, findings);
}

}  // namespace proveout
