#include "core/nc/wl4/wl4_setup.h"

#include "core/tool/tip.h"

namespace proveout::nc {

bool Wl4Setup::flipped(const Wl4State& s) const {
  const PlaneFrame f = s.frame();
  bool flip = s.plane == 18 && !parameters.g18_zx;
  for (const int axis : {f.u(), f.v()}) flip = flip != s.mirrored[static_cast<std::size_t>(axis)];
  return flip;
}

double Wl4Setup::compRadius(const Wl4State& s) const {
  double radius = lathe ? parameters.tool(s.selected_tool).nose_radius : 0.0;
  const auto row = settings.radius_offsets.find(s.d);
  if (row != settings.radius_offsets.end()) radius += row->second.geometry + row->second.wear;
  return radius;
}

Vec2 Wl4Setup::tipOf(const Wl4State& s) const {
  const Wl4Parameters::Tool& tool = parameters.tool(s.selected_tool);
  if (!lathe || tool.at_center) return Vec2::Zero();
  const Vec2 tip = tipDirection(tool.tip);
  return tool.nose_radius * Vec2(tip.y(), tip.x());
}

}  // namespace proveout::nc
