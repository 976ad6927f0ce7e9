#include "app/session/program_checks/limits.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "io/report_text.h"

namespace proveout {
namespace {

constexpr double kAboveByMore = 1.0 + 1e-6;

/// Values above one limit.
struct Excess {
  MotionId first = kNoMotion, worst = kNoMotion;
  double most = 0.0;
  std::size_t count = 0;

  void look(MotionId id, double value, double limit) {
    if (!(limit > 0.0) || value <= limit * kAboveByMore) return;
    if (count++ == 0) first = id;
    if (value <= most) return;
    most = value;
    worst = id;
  }
};

struct ToolExcess {
  ToolLimits limits;
  double max_rpm = 0.0;
  Excess feed, feed_per_tooth, speed;
};

/// What was passed, by how much: "the feed of 2400 mm/min is more than the 1000 mm/min that ...".
void tell(FindingKind kind, const Excess& excess, const std::string& text, const CheckedProgram& program,
          std::vector<Finding>& findings) {
  if (excess.count == 0) return;
  Finding finding = findingAt(kind, excess.first, program);
  finding.spots = excess.count;
  finding.message = text;
  if (excess.count > 1) {
    const Motion& worst = program.path.motions[excess.worst];
    finding.message += fmt::format(" ({} such motions, the worst in {})", excess.count,
                                   report_text::place(blockRef(program.path, worst.source, program.texts)));
  }
  findings.push_back(std::move(finding));
}

void tellTool(int number, const ToolExcess& tool, const CheckedProgram& program,
              std::vector<Finding>& findings) {
  using report_text::figure;
  const CuttingLimits& machine = program.job.limits;
  tell(FindingKind::kFeedRate, tool.feed,
       fmt::format("the feed of {} mm/min is more than the machine's max_feed of {:g} mm/min",
                   figure(tool.feed.most), machine.max_feed),
       program, findings);
  tell(FindingKind::kFeedRate, tool.feed_per_tooth,
       fmt::format(
           "the feed of {} mm per tooth is more than max_feed_per_tooth of tool {}, {:g} mm with {} teeth",
           figure(tool.feed_per_tooth.most), number, tool.limits.max_feed_per_tooth, tool.limits.teeth),
       program, findings);
  const bool machines = tool.max_rpm == machine.max_rpm;
  tell(
      FindingKind::kSpindleSpeed, tool.speed,
      fmt::format("the spindle turns with {} rpm, more than max_rpm of {}, {:g} rpm", figure(tool.speed.most),
                  machines ? std::string("the machine") : fmt::format("tool {}", number), tool.max_rpm),
      program, findings);
}

ToolExcess excessOf(int number, const CuttingLimits& limits) {
  ToolExcess tool;
  if (const auto own = limits.tools.find(number); own != limits.tools.end()) tool.limits = own->second;
  const bool both = tool.limits.max_rpm > 0.0 && limits.max_rpm > 0.0;
  tool.max_rpm =
      both ? std::min(tool.limits.max_rpm, limits.max_rpm) : std::max(tool.limits.max_rpm, limits.max_rpm);
  return tool;
}

}  // namespace

void addOverLimits(const CheckedProgram& program, std::vector<Finding>& findings) {
  const CuttingLimits& limits = program.job.limits;
  if (!(limits.max_feed > 0.0) && !(limits.max_rpm > 0.0) && limits.tools.empty()) return;
  std::map<int, ToolExcess> tools;
  const auto& motions = program.path.motions;
  for (MotionId id = 0; id < motions.size(); ++id) {
    const Motion& m = motions[id];
    auto found = tools.find(m.tool);
    if (found == tools.end()) found = tools.emplace(m.tool, excessOf(m.tool, limits)).first;
    ToolExcess& tool = found->second;
    const double rpm = std::abs(m.spindle);
    tool.speed.look(id, rpm, tool.max_rpm);
    if (m.kind != MotionKind::kFeed) continue;
    tool.feed.look(id, m.feed, limits.max_feed);
    if (rpm > 0.0 && tool.limits.teeth > 0)
      tool.feed_per_tooth.look(id, m.feed / (rpm * tool.limits.teeth), tool.limits.max_feed_per_tooth);
  }
  for (const auto& [number, tool] : tools) tellTool(number, tool, program, findings);
}

}  // namespace proveout
