#include "removal/turning/turning_tool.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/tool/tool_solid.h"

namespace proveout {

namespace {

/// The section of a solid of revolution about its own axis, both halves.
ConvexOutline bothHalves(const ConvexProfile& profile) {
  std::vector<OutlineSide> sides;
  const auto add = [&](const ConvexProfile::Element& e, double sign) {
    OutlineSide side;
    side.from = {sign * e.ar, e.az};
    side.to = {sign * e.br, e.bz};
    if (sign < 0.0) std::swap(side.from, side.to);
    side.arc = e.arc;
    side.center = {sign * e.cr, e.cz};
    side.radius = e.radius;
    sides.push_back(side);
  };
  for (int i = 0; i < profile.elementCount(); ++i) add(profile.element(i), 1.0);
  for (int i = profile.elementCount() - 1; i >= 0; --i) add(profile.element(i), -1.0);
  return ConvexOutline(sides);
}

ConvexOutline circle(const Vec2& center, double radius) {
  OutlineSide lower, upper;
  lower.arc = upper.arc = true;
  lower.center = upper.center = center;
  lower.radius = upper.radius = radius;
  lower.from = upper.to = center - Vec2(radius, 0.0);
  lower.to = upper.from = center + Vec2(radius, 0.0);
  return ConvexOutline({lower, upper});
}

void append(std::vector<SectionPath>& all, std::vector<SectionPath> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace

TurningTool::TurningTool(const Tool& tool) {
  if (!tool.insert) {
    const ToolSolid solid = makeToolSolid(tool);
    for (const ConvexProfile& p : solid.cutter) cutters.push_back(bothHalves(p));
    for (const ConvexProfile& p : solid.shank) shank.push_back(bothHalves(p));
    for (const ConvexProfile& p : solid.holder) holder.push_back(bothHalves(p));
    return;
  }
  insert = true;
  thread = std::make_shared<const ConvexOutline>(insertOutline(*tool.insert));
  cutters.push_back(*thread);
  holder = holderPieces(*tool.insert);
  end_of_edge = endOfEdge(*tool.insert);
  const int o = tool.insert->orientation;
  points_r = tipDirection(o).x();
  nose_mm = tool.insert->nose_radius;
  if (tool.insert->shape == InsertShape::kGroove) blade_mm = tool.insert->width;
  if (tool.insert->shape == InsertShape::kCorner && o >= 1 && o <= 4) lead_z = o == 1 || o == 4 ? 1.0 : -1.0;
  for (const OutlineSide& side : thread->sides()) {
    if (side.arc && side.use == SideUse::kCuts) noses.push_back(circle(side.center, side.radius));
  }
}

bool TurningTool::worksBehind(const PlaneWay& way) const {
  const double middle = 0.5 * (way.from.x() + way.to.x());
  if (!insert || middle >= 0.0) return false;
  if (points_r > 0.0) return true;
  if (points_r == 0.0) return middle + 0.5 * (thread->min().x() + thread->max().x()) < 0.0;
  double most = thread->max().x();
  for (const ConvexOutline& piece : holder) most = std::max(most, piece.max().x());
  return !holder.empty() && std::max(way.from.x(), way.to.x()) + most < 0.0;
}

TurningTool TurningTool::mirrored() const {
  TurningTool other = *this;
  for (auto* outlines : {&other.cutters, &other.shank, &other.holder, &other.noses}) {
    for (ConvexOutline& outline : *outlines) outline = proveout::mirrored(outline, 0);
  }
  if (thread) other.thread = std::make_shared<const ConvexOutline>(proveout::mirrored(*thread, 0));
  if (end_of_edge) other.end_of_edge = proveout::mirrored(*end_of_edge, 0);
  other.points_r = -points_r;
  return other;
}

std::vector<SectionPath> TurningTool::swept(const PlaneWay& way) const {
  std::vector<SectionPath> paths;
  for (const ConvexOutline& outline : cutters) append(paths, sweptPaths(outline, way));
  return paths;
}

std::vector<SectionPath> TurningTool::sweptEndOfEdge(const PlaneWay& way) const {
  return end_of_edge ? sweptPaths(*end_of_edge, way) : std::vector<SectionPath>{};
}

std::vector<SectionPath> TurningTool::sweptBacks(const PlaneWay& way) const {
  if (!insert) return {};
  return sweptSides(*thread, way, [this](const OutlineSide& side, const Vec2& direction) {
    if (side.use == SideUse::kBack) return true;
    return side.use == SideUse::kTrails && direction.y() * lead_z > 1e-9;
  });
}

std::vector<SectionPath> TurningTool::sweptEdges(const PlaneWay& way) const {
  PROVEOUT_ASSERT(thread != nullptr);
  std::vector<SectionPath> paths =
      sweptSides(*thread, way, [this](const OutlineSide& side, const Vec2& direction) {
        return side.use == SideUse::kCuts || (side.use == SideUse::kTrails && direction.y() * lead_z <= 1e-9);
      });
  for (const ConvexOutline& nose : noses) append(paths, sweptPaths(nose, way));
  return paths;
}

}  // namespace proveout
