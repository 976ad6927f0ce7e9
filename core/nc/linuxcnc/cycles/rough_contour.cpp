#include "core/nc/linuxcnc/cycles/rough_contour.h"

#include <fmt/core.h>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_parallel.h"

namespace proveout::nc {
namespace {

constexpr double kLcnBackSlack = 1e-3;  ///< mm; what goes back by less goes one way

/// Does the element go on along u all the way?
bool lcnElementGoesOn(const ContourElement& e) {
  if (e.to.x() < e.from.x() - kLcnBackSlack) return false;
  if (!e.arc) return true;
  // An arc that goes on lies above its centre or below it.
  const double above = e.sweep < 0.0 ? 1.0 : -1.0;
  return above * (e.from.y() - e.center.y()) >= -kLcnBackSlack &&
         above * (e.to.y() - e.center.y()) >= -kLcnBackSlack;
}

/// Above 0: the tool is on the left of the contour in (Z, X), below 0 on its right; 0: it cannot be told.
double lcnLeftOf(const LinuxCncProfile& profile) {
  const Vec2 begin = profile.begin(), to_tool = profile.start() - begin;
  Vec2 chord = profile.elements.back().from - begin;
  if (chord.norm() < kLcnBackSlack) chord = profile.end() - begin;
  const double left = cross2(chord, to_tool);
  return std::abs(left) < kLcnBackSlack * chord.norm() ? 0.0 : left;
}

LcnRoughFrame lcnFrameOf(const LinuxCncProfile& profile, int depth) {
  const int cut = 1 - depth;
  const double way = profile.end()[cut] > profile.begin()[cut] ? 1.0 : -1.0;
  const double left = lcnLeftOf(profile) * (depth == 1 ? way : -way);
  const double to_end = profile.end()[depth] - profile.begin()[depth];
  const double up = left != 0.0 ? left : to_end != 0.0 ? to_end : depth == 1 ? 1.0 : -1.0;
  return {depth, way, up > 0.0 ? 1.0 : -1.0};
}

}  // namespace

bool lcnGoesOneWay(const LinuxCncProfile& profile, int axis) {
  const LcnRoughFrame frame = lcnFrameOf(profile, 1 - axis);
  for (std::size_t k = 1; k < profile.elements.size(); ++k)
    if (!lcnElementGoesOn(frame.in(profile.elements[k]))) return false;
  return true;
}

bool lcnRoughContour(IsoContext& c, LinuxCncProfile profile, int depth, std::optional<LcnRoughContour>& out) {
  out.emplace(LcnRoughContour{lcnFrameOf(profile, depth), {}});
  if (!cutLinuxCncCorners(c, profile)) return false;
  for (const ContourElement& e : profile.elements) out->elements.push_back(out->frame.in(e));
  ContourElement& first = out->elements.front();
  if (first.to.x() < first.from.x()) first.from.x() = first.to.x();
  for (const ContourElement& e : out->elements) {
    if (!lcnElementGoesOn(e)) return lcnFail(c, "profile", "G7X error: Not monotonic");
  }
  return true;
}

bool lcnKeepOff(IsoContext& c, double distance, PlaneContour& elements) {
  if (distance == 0.0) return true;
  const PlaneContour contour(elements.begin() + 1, elements.end());
  const PlaneContour kept = parallelContour(contour, distance);
  if (kept.empty())
    return lcnFail(c, "profile",
                   fmt::format("G7X error: the contour has no parallel at a distance of {:g} mm", distance));
  elements.resize(1);
  elements.front().to = kept.front().from;
  elements.insert(elements.end(), kept.begin(), kept.end());
  return true;
}

}  // namespace proveout::nc
