// Regions of a level plane, bounded by straight lines and arcs of circles: the sections of a workpiece that a
// wire cuts. Workpiece frame, mm.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"
#include "core/path/toolpath.h"

namespace proveout {

/// Ends where the next edge of its loop begins.
struct PlaneEdge {
  Vec2 from = Vec2::Zero();
  Vec2 center = Vec2::Zero();   ///< of arcs; both ends are on the circle, but for 0.0001 mm
  double sweep_rad = 0.0;       ///< signed, counter-clockwise seen from +z; 0: a straight line
  MotionId motion = kNoMotion;  ///< that made it; kNoMotion: it is the blank's own
};

/// Closed; the region is on its left, so outer borders go counter-clockwise and hollows clockwise.
struct PlaneLoop {
  std::vector<PlaneEdge> edges;
};

/// A connected region.
struct PlaneBody {
  std::vector<PlaneLoop> loops;  ///< the outer border first
  double area_mm2 = 0.0;
};

/// A loop with its arcs cut into chords.
struct ChordLoop {
  std::vector<Vec2> points;
  std::vector<std::uint32_t> edge;  ///< of the loop: that on which the chord from points[i] to the next lies
};

/// A full circle, counter-clockwise, or clockwise as a hollow.
PlaneLoop circleLoop(const Vec2& center, double radius_mm, bool hollow);
PlaneLoop rectangleLoop(const Vec2& min, const Vec2& max);

/// Closed form, mm2; negative for hollows.
double areaOf(const PlaneLoop& loop);
double areaOf(const std::vector<PlaneLoop>& loops);
/// Chords leave the arcs, whose ends they keep, by no more than `tolerance` mm (> 0).
ChordLoop chordsOf(const PlaneLoop& loop, double tolerance);
/// Whether the polygon winds round a point.
bool surrounds(const std::vector<Vec2>& polygon, const Vec2& p);
/// Exact for arcs, z = 0.
Box3 boundsOf(const PlaneLoop& loop);

/// As meshes hold it: rounded to floats.
Vec2 asFloat(const Vec2& p);
/// Points nearer to each other are one in a mesh, mm: some steps of its floats at p, and of the nanometres
/// that sections are made on. Edges as short may go to and fro, and fold the triangles beside them.
double meshStep(const Vec2& p);
/// Of a polygon what a mesh can hold: without corners that are one there, and without those where it goes
/// back on its way, but for less than a mesh can tell. Longer edges stay.
struct KeptCorner {
  std::uint32_t point = 0, edge = 0;  ///< by number; the edge to the next corner has what was said of `edge`
};
std::vector<KeptCorner> meshCorners(const std::vector<Vec2>& polygon);
/// By an angle, counter-clockwise.
Vec2 turnedBy(const Vec2& v, double angle);

/// How many chords an arc is cut into.
int chordCount(double radius_mm, double sweep_rad, double tolerance_mm);

/// Polygons seen from +z, mm.
using PlanePolygons = std::vector<std::vector<Vec2>>;

}  // namespace proveout
