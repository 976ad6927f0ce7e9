// What a leaning wire leaves at one height.
#pragma once

#include <cstdint>
#include <vector>

#include "removal/wire/lean/lean_stretch.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {

/// Says where an edge of a section comes from, the same at all heights: a side of a stretch, its end, or a
/// side of the blank.
using WallName = std::uint64_t;
/// Of a stretch or of the blank; else an end.
bool isSide(WallName name);

/// A closed polygon, the region on its left.
struct LevelLoop {
  std::vector<Vec2> points;
  std::vector<WallName> names;    ///< of the edge from points[i] to the next
  std::vector<MotionId> motions;  ///< that made it; kNoMotion: it is the blank's own
};

struct LevelRegion {
  std::vector<std::uint32_t> loops;  ///< the border first
};

struct LevelSection {
  double z = 0.0;  ///< mm
  std::vector<LevelLoop> loops;
  std::vector<LevelRegion> regions;
};

/// Area of a polygon, mm2; negative for hollows.
double areaOf(const LevelLoop& loop);

enum class ThinPlaces {
  kStay,
  kGo  ///< material and gaps of some steps of a mesh: what is left keeps as far apart
};
/// The blank less the kerfs, as polygons: corners to a nanometre, chords of the kerf's round ends and of the
/// blank within 0.0001 mm. No two neighbouring points are one in a mesh.
LevelSection levelSection(const std::vector<PlaneLoop>& blank, const std::vector<LevelStretch>& stretches,
                          double z, ThinPlaces thin = ThinPlaces::kStay);

}  // namespace proveout
