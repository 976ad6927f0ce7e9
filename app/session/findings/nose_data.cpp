#include "app/session/findings/nose_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "app/session/findings/blame.h"
#include "app/session/findings/control_datum.h"
#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "core/path/origin_query.h"
#include "core/tool/tool_table.h"
#include "io/report_text.h"

namespace proveout {
namespace {

using report_text::figure;

/// Edges of the section that turn away from the way of their motion by more are ends of it, radians; of arcs,
/// whose chords may be cut short.
constexpr double kAlong = 2e-3, kAlongArc = 0.03;
/// Data that differ by less are the same, mm.
constexpr double kSame = 1e-6;

/// An edge of the part's section that a side of a tool's sweep left, as its nose sees it.
struct LeftEdge {
  MotionId motion = kNoMotion;
  Vec2 at;         ///< its middle, (r, z)
  Vec2 inward;     ///< unit, into the material, from the side that the tool works on
  Vec2 direction;  ///< of the motion there, unit
};

/// Direction of a motion beside a point of the surface that it left, (x, z).
Vec2 directionBeside(const Toolpath& path, const Motion& motion, const Vec2& nose, const Vec2& at) {
  if (motion.arc < 0) {
    const Vec3 way = motion.to - motion.from;
    return Vec2(way.x(), way.z()).normalized();
  }
  PROVEOUT_ASSERT(static_cast<std::size_t>(motion.arc) < path.arcs.size());
  const Vec3& center = path.arcs[static_cast<std::size_t>(motion.arc)].center;
  return leftOf((at - Vec2(center.x(), center.z()) - nose).normalized());
}

/// Edges of the part along the ways of motions with inserts that have a nose to compensate.
std::vector<LeftEdge> leftEdges(const SetupRun& setup) {
  std::vector<LeftEdge> edges;
  const Toolpath& path = setup.interpreted.path;
  std::map<int, const Insert*> inserts;
  for (const Tool& tool : setup.job.tools) {
    if (tool.insert && tool.insert->shape != InsertShape::kThread) inserts[tool.number] = &*tool.insert;
  }
  for (const SectionLoop& loop : *setup.form->profile()) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const MotionId id = loop.motion[i];
      PROVEOUT_ASSERT(id == kNoMotion || id < path.motions.size());
      if (id == kNoMotion || path.motions[id].kind != MotionKind::kFeed) continue;
      const Motion& motion = path.motions[id];
      const auto insert = inserts.find(motion.tool);
      const Vec2 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
      if (insert == inserts.end() || a == b) continue;
      const double side = motion.from.x() + motion.to.x() < 0.0 ? -1.0 : 1.0;  // of the axis
      const auto seen = [&](const Vec2& v) { return Vec2(side * v.x(), v.y()); };
      LeftEdge edge{id, seen(0.5 * (a + b)), seen(leftOf((b - a).normalized())), Vec2::Zero()};
      edge.direction = directionBeside(path, motion, noseCenter(*insert->second), edge.at);
      const double most = motion.arc < 0 ? kAlong : kAlongArc;
      if (std::abs(edge.direction.dot(edge.inward)) < most) edges.push_back(edge);
    }
  }
  return edges;
}

const Insert& insertOf(const SetupRun& setup, MotionId motion) {
  PROVEOUT_ASSERT(motion < setup.interpreted.path.motions.size());
  return *ToolTable(setup.job.tools).find(setup.interpreted.path.motions[motion].tool)->insert;
}

/// How far an uncompensated nose cuts beyond the line that the programmed point draws, mm; below 0: how much
/// it leaves. 0 on sides that its point is not on.
double beyondLine(const Insert& insert, bool programs_center, const LeftEdge& edge) {
  if (programs_center) return insert.nose_radius;
  const Vec2 tip = tipDirection(insert.orientation);
  // The other sides of the nose are where its size puts them: walls of a straight plunge.
  if (tip.dot(edge.inward) < kAlongArc) return 0.0;
  return insert.nose_radius * (1.0 - tip.dot(edge.inward));
}

/// Whether the tool goes back along the line that it comes on, or came in along the one that it goes out on:
/// in one go or in several. Its walls are then meant to be a nose's width apart. A cut that ends at the axis
/// is a face.
bool isPlunge(const Toolpath& path, MotionId id, double nose_radius) {
  PROVEOUT_ASSERT(id < path.motions.size());
  const Motion& own = path.motions[id];
  const Vec3 way = (own.to - own.from).normalized();
  const auto reaches = [&](const Motion& m) {
    const bool faces =
        std::abs(way.x()) > kAlong && std::min(std::abs(m.from.x()), std::abs(m.to.x())) < nose_radius;
    return m.from.x() * m.to.x() < 0.0 || faces;
  };
  // 1: on along the line, -1: back, 0: elsewhere.
  const auto along = [&](const Motion& m) {
    const Vec3 step = m.to - m.from;
    if (m.arc >= 0 || m.tool != own.tool) return 0;
    if (step.norm() < kSame) return 1;
    const double same = step.normalized().dot(way);
    return std::abs(same) < 1.0 - kSame ? 0 : same > 0.0 ? 1 : -1;
  };
  if (own.arc >= 0 || reaches(own)) return false;
  for (std::size_t k = id + 1; k < path.motions.size(); ++k) {
    if (const int side = along(path.motions[k]); side != 1) {
      if (side == -1) return true;
      break;
    }
    if (reaches(path.motions[k])) return false;
  }
  for (std::size_t k = id; k-- > 0;) {
    if (const int side = along(path.motions[k]); side != 1) return side == -1;
  }
  return false;
}

/// Slopes and arcs of the part's surface that an insert left without compensation of its nose.
void addUncompensated(const SetupRun& setup, const std::vector<LeftEdge>& edges, double least_mm,
                      const RecordingSource& texts, std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  struct Worst {
    double beyond = 0.0;
    const LeftEdge* edge = nullptr;
    std::set<MotionId> motions;
  };
  std::map<int, Worst> tools;
  for (const LeftEdge& edge : edges) {
    const Motion& motion = path.motions[edge.motion];
    const Insert& insert = insertOf(setup, edge.motion);
    if (motion.compensated || insert.shape == InsertShape::kGroove) continue;
    const DataInForce* data = dataOf(path, edge.motion);
    const bool at_center = insert.at_center || (data != nullptr && data->at_center);
    if (at_center && isPlunge(path, edge.motion, insert.nose_radius)) continue;
    const double beyond = beyondLine(insert, at_center, edge);
    if (std::abs(beyond) <= least_mm) continue;
    Worst& worst = tools[motion.tool];
    worst.motions.insert(edge.motion);
    if (std::abs(beyond) <= std::abs(worst.beyond)) continue;
    worst.beyond = beyond;
    worst.edge = &edge;
  }
  for (const auto& [tool, worst] : tools) {
    Finding finding(FindingKind::kNoseDeviation);
    finding.where = Vec3(worst.edge->at.x(), 0.0, worst.edge->at.y());
    finding.depth_mm = std::abs(worst.beyond);
    finding.spots = worst.motions.size();
    finding.message = fmt::format(
        "the nose radius {:g} is not compensated: here it cuts {} mm {} the programmed line ({} such "
        "motions)",
        insertOf(setup, worst.edge->motion).nose_radius, figure(std::abs(worst.beyond)),
        worst.beyond > 0.0 ? "beyond" : "short of", worst.motions.size());
    blame(finding, worst.edge->motion, path, texts);
    findings.push_back(std::move(finding));
  }
}

/// The nose that the control had in mind.
struct ControlNose {
  int tool = 0, row = 0, tip = 0, corrector_row = 0;
  double radius = 0.0, corrector = 0.0;
  bool at_center = false;
  bool operator<(const ControlNose& o) const {
    return std::tie(tool, row, tip, corrector_row, radius, corrector, at_center) <
           std::tie(o.tool, o.row, o.tip, o.corrector_row, o.radius, o.corrector, o.at_center);
  }
};

ControlNose noseOf(const Motion& motion, const DataInForce& data) {
  return {motion.tool,      data.nose_tool,      data.tip,      data.radius.row,
          data.nose_radius, data.radius.value(), data.at_center};
}

/// From the nose centre to the control point, as tipDirection().
Vec2 ownTip(const Insert& insert) {
  return insert.at_center ? Vec2(Vec2::Zero()) : tipDirection(insert.orientation);
}

/// How far the insert cuts beyond where the control wants it, mm: circles on the centres that both know.
double beyondContour(const ControlNose& control, const Insert& insert, const Vec2& inward) {
  const Vec2 centers = control.radius * tipDirection(control.tip) - insert.nose_radius * ownTip(insert);
  const double between = control.at_center ? 0.0 : centers.dot(inward);
  return between + insert.nose_radius - control.radius;
}

int tipOf(const Insert& insert) { return insert.at_center ? 9 : insert.orientation; }

bool sameTip(const ControlNose& control, const Insert& insert) {
  return control.at_center || tipDirection(control.tip) == ownTip(insert);
}

/// Whether there is nothing but an allowance between them.
bool sameNose(const ControlNose& control, const Insert& insert) {
  return control.row == control.tool && std::abs(control.radius - insert.nose_radius) <= kSame &&
         sameTip(control, insert);
}

/// What of the data is not the insert's; empty: nothing.
std::string difference(const std::string& name, const ControlNose& control, const Insert& insert) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (control.row != control.tool)
    add(fmt::format("the data of tool {} count while tool {} cuts", control.row, control.tool));
  if (std::abs(control.radius - insert.nose_radius) > kSame)
    add(fmt::format("{}.{} is {:g}{}, the nose radius of the insert {:g}",
                    latheDatumName(name, LatheDatum::kNoseRadius), control.row, control.radius,
                    control.radius == 0.0 ? " (not given?)" : "", insert.nose_radius));
  if (!sameTip(control, insert))
    add(fmt::format("{}.{} is {}, the orientation of the insert {}", latheDatumName(name, LatheDatum::kTip),
                    control.row, control.tip, tipOf(insert)));
  if (std::abs(control.corrector) > kSame)
    add(fmt::format("the corrector D{} is {:g}", control.corrector_row, control.corrector));
  return text;
}

struct Effect {
  double deep = 0.0, proud = 0.0;  ///< largest, mm
  MotionId worst = kNoMotion;
  Vec2 at = Vec2::Zero();

  void take(double beyond, const LeftEdge& edge) {
    if (worst == kNoMotion || std::abs(beyond) > std::max(deep, proud)) {
      worst = edge.motion;
      at = edge.at;
    }
    deep = std::max(deep, beyond);
    proud = std::max(proud, -beyond);
  }
};

std::string effectText(const Effect& effect) {
  std::string text;
  if (effect.deep > kSame) text = fmt::format("up to {} mm too deep", figure(effect.deep));
  if (effect.proud > kSame)
    text += fmt::format("{}up to {} mm too high", text.empty() ? "" : " and ", figure(effect.proud));
  return text.empty() ? "no surface of the part is off because of it" : "surfaces of the part are " + text;
}

void addNoseData(const SetupRun& setup, const std::vector<LeftEdge>& edges, double least_mm,
                 const RecordingSource& texts, std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  std::map<ControlNose, Effect> noses;
  for (const LeftEdge& edge : edges) {
    const DataInForce* data = dataOf(path, edge.motion);
    const Motion& motion = path.motions[edge.motion];
    if (data == nullptr || !motion.compensated) continue;
    const ControlNose control = noseOf(motion, *data);
    const Insert& insert = insertOf(setup, edge.motion);
    if (difference(setup.job.control, control, insert).empty()) continue;
    noses[control].take(beyondContour(control, insert, edge.inward) - control.corrector, edge);
  }
  for (const auto& [control, effect] : noses) {
    const bool matters = std::max(effect.deep, effect.proud) > least_mm;
    const Insert& insert = insertOf(setup, effect.worst);
    Finding finding(FindingKind::kToolData);
    finding.severity = !matters                    ? Severity::kNote
                       : sameNose(control, insert) ? Severity::kWarning
                                                   : Severity::kError;
    finding.where = Vec3(effect.at.x(), 0.0, effect.at.y());
    finding.depth_mm = std::max(effect.deep, effect.proud);
    finding.message = fmt::format("tool {}: {}; {}", control.tool,
                                  difference(setup.job.control, control, insert), effectText(effect));
    blame(finding, effect.worst, path, texts);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

void addNoseFindings(const SetupRun& setup, double least_mm, const RecordingSource& texts,
                     std::vector<Finding>& findings) {
  if (setup.form->profile() == nullptr) return;
  const std::vector<LeftEdge> edges = leftEdges(setup);
  addUncompensated(setup, edges, least_mm, texts, findings);
  addNoseData(setup, edges, least_mm, texts, findings);
}

std::optional<Cause> noseCause(const SetupRun& setup, MotionId motion, const Vec3& where, const Vec3& outward,
                               double beyond_mm) {
  const Toolpath& path = setup.interpreted.path;
  const DataInForce* data = motion < path.motions.size() ? dataOf(path, motion) : nullptr;
  if (setup.form->profile() == nullptr || data == nullptr || !path.motions[motion].compensated)
    return std::nullopt;
  const ControlNose control = noseOf(path.motions[motion], *data);
  const Tool* tool = ToolTable(setup.job.tools).find(control.tool);
  if (tool == nullptr || !tool->insert || sameNose(control, *tool->insert)) return std::nullopt;
  const Vec2 radial = where.head<2>().normalized();
  const Vec2 inward(-outward.head<2>().dot(radial), -outward.z());
  const double expected = beyondContour(control, *tool->insert, inward) - control.corrector;
  Cause cause;
  const bool radius = std::abs(control.radius - tool->insert->nose_radius) > kSame;
  cause.what =
      latheDatumKey(setup.job.control, radius ? LatheDatum::kNoseRadius : LatheDatum::kTip, control.row);
  cause.value = radius ? fmt::format("{:g}, the insert has {:g}", control.radius, tool->insert->nose_radius)
                       : fmt::format("{}, the insert has {}", control.tip, tipOf(*tool->insert));
  cause.along = "radius";
  cause.off_mm = expected;
  cause.explains = std::clamp(1.0 - std::abs(expected - beyond_mm) / std::abs(beyond_mm), 0.0, 1.0);
  return cause;
}

void dropRefuted(const Comparison& comparison, std::vector<Finding>& findings) {
  if (!comparison.pass()) return;
  std::erase_if(findings, [](const Finding& finding) { return finding.kind == FindingKind::kNoseDeviation; });
  for (Finding& finding : findings) {
    if (finding.kind == FindingKind::kToolData && finding.severity == Severity::kError)
      finding.severity = Severity::kWarning;
  }
}

}  // namespace proveout
