#include "app/turned_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/tool/tool_table.h"
#include "io/report/half_section.h"

namespace proveout {
namespace {

/// More texts than these hide the part; the report lists all findings.
constexpr std::size_t kMostMarks = 16;
/// Steps in which a motion is looked at for the place where its tool met something.
constexpr int kSteps = 128;

Vec2 inPlane(const Vec3& p) { return {p.head<2>().norm(), p.z()}; }

/// Border of the blank of the last clamping, in its frame.
std::vector<std::vector<Vec2>> blankOf(const Job& job, const RunResult& run) {
  std::vector<std::vector<Vec2>> loops;
  if (run.setups.size() == 1) {
    const auto* round = job.stock ? std::get_if<CylinderShape>(&*job.stock) : nullptr;
    if (round == nullptr) return loops;
    const double low = round->base.z(), high = low + round->length, bore = round->inner_radius;
    return {{{bore, low}, {round->radius, low}, {round->radius, high}, {bore, high}}};
  }
  const SetupRun& before = run.setups[run.setups.size() - 2];
  const std::vector<SectionLoop>* const profile = before.form->profile();
  if (profile == nullptr) return loops;
  for (const SectionLoop& loop : *profile) {
    std::vector<Vec2> moved;
    for (const Vec2& p : loop.points)
      moved.push_back(inPlane(run.setups.back().from_previous(Vec3(p.x(), 0, p.y()))));
    loops.push_back(std::move(moved));
  }
  return loops;
}

/// The insert of a motion and where it goes.
struct InsertWay {
  const Toolpath& path;
  const Motion& motion;
  ConvexOutline outline;

  Vec2 at(double t) const {
    const Vec3 p = path.pointAt(motion, t);
    return {p.x(), p.z()};
  }
  ProfileTool standing(const Vec2& at) const {
    ProfileTool tool;
    outline.chain(0.0, 2.0 * kPi, 10.0 * kSectionChordMm, tool.outline);
    for (Vec2& p : tool.outline) p += at;
    tool.label = fmt::format("T{}", motion.tool);
    return tool;
  }
};

std::optional<InsertWay> insertOn(const SetupRun& setup, std::size_t id) {
  const Toolpath& path = setup.interpreted.path;
  if (id >= path.motions.size()) return std::nullopt;
  const Tool* tool = ToolTable(setup.job.tools).find(path.motions[id].tool);
  if (tool == nullptr || !tool->insert) return std::nullopt;
  return InsertWay{path, path.motions[id], insertOutline(*tool->insert)};
}

/// The tool where it first has `place` on it or in it, else where it comes nearest.
ProfileTool toolAt(const InsertWay& way, const Vec2& place) {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const double off = std::max(0.0, way.outline.sample(place - way.at(t)).value);
    if (off >= least - 1e-9) continue;
    least = off;
    best = t;
  }
  return way.standing(way.at(best));
}

/// Findings that have a place: their blocks, and the inserts that were there.
void addFindings(const RunResult& run, ProfileChartOptions& options) {
  const SetupRun& setup = run.setups.back();
  for (const Finding& finding : run.findings) {
    if (!finding.where || !finding.source || finding.setup != setup.name) continue;
    if (options.marks.size() == kMostMarks) return;
    const Vec2 place = inPlane(*finding.where);
    const BlockRef& source = *finding.source;
    const std::string label =
        source.block < 0 ? fmt::format("line {}", source.line) : fmt::format("N{}", source.block);
    const auto same = [&](const ProfileMark& m) { return m.label == label && (m.at - place).norm() < 1e-3; };
    if (std::any_of(options.marks.begin(), options.marks.end(), same)) continue;
    options.marks.push_back({place, label});
    if (finding.severity != Severity::kError || !finding.motion) continue;
    if (const auto way = insertOn(setup, *finding.motion)) options.tools.push_back(toolAt(*way, place));
  }
}

/// Each insert at the end of the last motion that left some of the part's surface: of its contour.
void addContourEnds(const SetupRun& setup, ProfileChartOptions& options) {
  const Toolpath& path = setup.interpreted.path;
  std::map<int, MotionId> last;
  for (const SectionLoop& loop : *setup.form->profile()) {
    for (const MotionId id : loop.motion) {
      if (id >= path.motions.size() || path.motions[id].kind != MotionKind::kFeed) continue;
      MotionId& known = last.try_emplace(path.motions[id].tool, id).first->second;
      known = std::max(known, id);
    }
  }
  for (const auto& [tool, id] : last) {
    if (const auto way = insertOn(setup, id)) options.tools.push_back(way->standing(way->at(1.0)));
  }
}

}  // namespace

void writeTurnedProfile(const Job& job, const RunResult& run, StagingFolder& staging, Report& report,
                        OutputFailures& failures) {
  const SetupRun& setup = run.setups.back();
  const std::vector<SectionLoop>* const profile = setup.form->profile();
  if (profile == nullptr) return;
  std::vector<std::vector<Vec2>> machined;
  if (!setup.form->revolved()) {
    machined = halfSectionLoops(setup.surface.mesh);
  } else {
    for (const SectionLoop& loop : *profile) machined.push_back(loop.points);
  }
  ProfileChartOptions options;
  options.name = job.name;
  if (job.nominal) {
    options.gouge_mm = job.nominal->gouge_mm;
    options.excess_mm = job.nominal->excess_mm;
    options.ignored = job.nominal->ignored;
  }
  options.blank = blankOf(job, run);
  addFindings(run, options);
  addContourEnds(setup, options);
  writeProfileChart(machined, run.nominal ? &*run.nominal : nullptr, options, staging, report, failures);
}

}  // namespace proveout
