#include "app/session/program_checks/retracts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "app/session/program_checks/local_top.h"
#include "app/session/run/process.h"
#include "core/mesh/mesh_placement.h"
#include "core/tool/tool_table.h"
#include "io/report_text.h"
#include "removal/grid/stock_shape.h"

namespace proveout {
namespace {

/// A tool that is so near beside something is not clear of it, mm.
constexpr double kBesideMm = 5.0;
constexpr double kLeastMm = 1e-3;

class RetractCheck {
 public:
  explicit RetractCheck(const CheckedProgram& program)
      : program_(program), tools_(program.job.tools), turns_(processOf(program.job.control).part_turns) {
    for (const FixtureSpec& fixture : program.job.fixtures) {
      Result<StockShape> shape = loadStockShape(fixture.shape);
      if (shape) fixtures_.emplace_back(fixture.name, std::move(*shape));
    }
  }

  /// The change before motion `before`, called by the event.
  void look(MotionId before, const PathEvent& event, int to, std::vector<Finding>& findings) {
    const MotionId last = lastOfProgram(before, event);
    if (last == kNoMotion) return;
    const Motion& motion = program_.path.motions[last];
    if (motion.tool == to) return;  // it is in the spindle
    const std::string text = turns_ ? whereTurning(motion.to) : whereMilling(motion);
    if (text.empty()) return;
    Finding finding(FindingKind::kToolChange);
    finding.source = blockRef(program_.path, event.source, program_.texts);
    finding.motion = last;
    finding.tool = motion.tool;
    finding.where = motion.to;
    finding.message = text;
    findings.push_back(std::move(finding));
  }

 private:
  /// The last motion of the channel that the program itself asked for; kNoMotion: there was none.
  MotionId lastOfProgram(MotionId before, const PathEvent& event) const {
    const auto& motions = program_.path.motions;
    for (MotionId id = before; id-- > 0;) {
      if (motions[id].channel == event.channel && !isMachines(id, event)) return id;
    }
    return kNoMotion;
  }

  /// Whether the machine made the motion on its way to the tool change: no word of the program gives what
  /// moves.
  bool isMachines(MotionId id, const PathEvent& event) const {
    const Motion& m = program_.path.motions[id];
    const SourceRef &own = m.source, &called = event.source;
    if (m.kind != MotionKind::kRapid || own.line != called.line || own.file != called.file ||
        own.depth != called.depth)
      return false;
    const bool up = m.to.z() > m.from.z() && (m.to - m.from).head<2>().norm() < kLeastMm;
    if (!up || own.origins < 0) return up;
    return !originOf(program_.path, id, OriginKind::kZ, lineText(program_.path, program_.texts)).has_value();
  }

  /// Of what is clamped, near a place.
  std::optional<double> partTop(const Vec2& place, double reach) {
    if (program_.left_before) return topNear(leftBefore(), place, reach);
    const bool saved = program_.shape != nullptr && std::holds_alternative<SavedStock>(*program_.shape);
    if (program_.shape != nullptr && !saved) return topNear(*program_.shape, place, reach);
    if (!program_.blank) return std::nullopt;
    return topNear(StockShape(BoxShape{program_.blank->min, program_.blank->max}), place, reach);
  }

  /// What the clamping before left, in this one; moved when it is first asked for.
  const TriMesh& leftBefore() {
    if (!left_before_)
      moveMesh(program_.left_before->moved, left_before_.emplace(program_.left_before->mesh));
    return *left_before_;
  }

  std::string whereMilling(const Motion& motion) {
    const Tool* const tool = tools_.find(motion.tool);
    const double reach = kBesideMm + (tool != nullptr ? 0.5 * tool->diameter : 0.0);
    const Vec2 place = motion.to.head<2>();
    std::string text = below(motion.to.z(), partTop(place, reach), "the part");
    for (auto fixture = fixtures_.begin(); text.empty() && fixture != fixtures_.end(); ++fixture)
      text = below(motion.to.z(), topNear(fixture->second, place, reach),
                   fmt::format("fixture '{}'", fixture->first));
    return text;
  }

  static std::string below(double tip, std::optional<double> top, const std::string& what) {
    if (!top || tip >= *top - kLeastMm) return {};
    return fmt::format(
        "tool change called {} mm below the top of {}, without a retract: the tip stands at Z{:g}, the top "
        "beside it "
        "is at Z{:g}",
        report_text::figure(*top - tip), what, tip + 0.0, *top + 0.0);
  }

  std::string whereTurning(const Vec3& tip) const {
    if (!program_.blank) return {};
    const double radius = program_.blank->max.x(), face = program_.blank->max.z();
    const double in = std::min(radius - std::abs(tip.x()), face - tip.z());
    if (in < kLeastMm) return {};
    return fmt::format(
        "tool change called {} mm inside of what the blank sweeps, without a retract: the tip stands "
        "at diameter {:g}, Z{:g}, the blank reaches to diameter {:g} and Z{:g}",
        report_text::figure(in), 2.0 * std::abs(tip.x()), tip.z() + 0.0, 2.0 * radius, face + 0.0);
  }

  const CheckedProgram& program_;
  ToolTable tools_;
  bool turns_;
  std::vector<std::pair<std::string, StockShape>> fixtures_;  ///< by name
  std::optional<TriMesh> left_before_;
};

}  // namespace

void addLowToolChanges(const CheckedProgram& program, std::vector<Finding>& findings) {
  const ToolChangePlace& place = program.job.settings.tool_change;
  if (place.z && !place.by_default) return;
  std::optional<RetractCheck> check;  // reads the fixtures
  for (const auto& [before, event] : program.path.events) {
    const auto* change = event.as<event::ToolChange>();
    if (change == nullptr || before == 0) continue;
    if (!check) check.emplace(program);
    check->look(before, event, change->tool, findings);
  }
}

}  // namespace proveout
