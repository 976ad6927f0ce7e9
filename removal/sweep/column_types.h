// What the column kernels work on: plain numbers. They are compiled for several SIMD levels, so nothing that
// has inline functions of its own may be included here (see column_kernel_body.h).
#pragma once

namespace proveout {

/// Lower or (mirrored at z = 0) upper boundary of a solid as a convex, non-decreasing function L(r).
struct ColumnBoundary {
  enum class Kind : unsigned char { kLevel, kCone, kArc };
  struct Piece {
    Kind kind;
    double ra, rb;          ///< range of r, mm
    double za, slope;       ///< kLevel, kCone: L = za + slope * (r - ra)
    double rc, zc, radius;  ///< kArc: L = zc - sqrt(radius^2 - (r - rc)^2)
  };
  static constexpr int kMaxPieces = 8;
  int count = 0;
  Piece piece[kMaxPieces];

  double height(double r) const;  ///< L(r), mm; requires 0 <= r <= the last rb
};

struct ColumnSolid {
  double radius = 0.0;  ///< largest, mm
  double z_min = 0.0, z_max = 0.0;
  bool flat = false;            ///< a cylinder
  bool ball = false;            ///< a lower half sphere of the full radius with a cylinder on it
  bool sphere = false;          ///< a whole ball
  bool round_top = false;       ///< the upper boundary is not one level disc of the full radius
  bool even = false;            ///< the upper boundary is the lower one in a mirror, but for its height
  ColumnBoundary lower, upper;  ///< upper: mirrored
};

struct CurveWay;  // column_way.h

/// A part of a way, for angles a from its middle: (x, y, z) + r(a) (u cos a + v sin a) - r(0) u + a k, where
/// r is radius + a growth. mm, rad.
struct WayPart {
  double x, y, z;
  double ux, uy, uz, vx, vy, vz;
  double kx, ky, kz;
  double radius, growth, half;   ///< half: of its angle
  double reach;                  ///< no place is farther from the middle, level, mm
  double curvature;              ///< of the way as seen from above, 1/mm: nowhere more
  double sag;                    ///< second derivative of the height by the level way, 1/mm: nowhere less
  double least_bend, most_bend;  ///< of the height, by the angle
  /// Its ends and its middle, level: places from the middle, and velocities.
  double end_x[3], end_y[3], end_vx[3], end_vy[3];
  double speed;  ///< level, mm a radian: nowhere more
};

// How a solid moves, as the kernels take it: one of these for each kind of way. mm, rad.

/// On a line; of length 0 where it is upright.
struct LineSweep {
  const ColumnSolid* solid = nullptr;
  double x = 0.0, y = 0.0, z = 0.0;                      ///< tip at the start
  double rise = 0.0;                                     ///< from start to end
  double ux = 1.0, uy = 0.0, length = 0.0, slope = 0.0;  ///< level direction, level length, rise a mm
  double lean = 0.0;                                     ///< -slope / sqrt(1 + slope^2)
};

/// On a level arc. Its frame turns with the motion, so that the sweep is positive.
struct ArcSweep {
  const ColumnSolid* solid = nullptr;
  double x = 0.0, y = 0.0, z = 0.0;  ///< center, at the height of the tip
  double start_x = 0.0, start_y = 0.0, end_x = 0.0, end_y = 0.0, arc_radius = 0.0;
  double turn = 1.0;  ///< +1 counter-clockwise, -1 clockwise
  double cos_sweep = 1.0, sin_sweep = 0.0;
  bool wide = false;  ///< sweep above half a turn
  bool full = false;  ///< a whole turn or more
};

/// On a turn of a helix about z, which meets every column in one interval (column_curve.h).
struct TurnSweep {
  const ColumnSolid* solid = nullptr;
  double x = 0.0, y = 0.0;     ///< axis
  double z = 0.0, rise = 0.0;  ///< height of the tip where the angle is least, and up to where it is largest
  double ux = 1.0, uy = 0.0;   ///< direction of the start from the axis
  double slope = 0.0;          ///< rise a radian
  double arc_radius = 0.0;
  double turn = 1.0;      ///< +1 counter-clockwise, -1 clockwise
  double start_z = 0.0;   ///< height of the tip at the start of the whole way
  double way_rad = 0.0;   ///< angle of the whole way
  double cut_rad = 0.0;   ///< angles of columns begin there
  double turn_rad = 0.0;  ///< angle of the turns before it, from cut_rad
};

/// On a part of an arc in an upright plane that does not turn back: it meets every column in one interval.
struct UprightSweep {
  const ColumnSolid* solid = nullptr;
  double x = 0.0, y = 0.0, start_z = 0.0;  ///< center
  double z = 0.0, rise = 0.0;  ///< height of the tip where it is lowest, and up to where it is highest
  double ux = 1.0, uy = 0.0;   ///< level direction in its plane
  double arc_radius = 0.0;
  double first_mm = 0.0, last_mm = 0.0;  ///< stretch of the way along (ux, uy) from the center
  double side = 1.0;                     ///< -1 on the lower half of the circle, +1 on the upper
};

/// On a part of any other curve.
struct WaySweep {
  const ColumnSolid* solid = nullptr;
  const CurveWay* way = nullptr;
  const WayPart* plain = nullptr;     ///< the same part of it
  int part = 0;                       ///< number of the part
  bool twice = false, again = false;  ///< columns may see the part twice; this is what they see second
  double z = 0.0, rise = 0.0;         ///< height of the tip where it is lowest, and up to where it is highest
};

/// A convex solid of revolution in zones along its axis: z from its tip, where a point at radius r lies in it
/// if r^2 <= alpha + beta z + gamma z^2. mm.
struct PoseSolid {
  static constexpr int kMost = 8;
  struct Zone {
    double low = 0.0, high = 0.0;
    double alpha = 0.0, beta = 0.0, gamma = 0.0;
    double widest = 0.0;  ///< largest radius
    bool widens = false;  ///< upwards; told of cones only
    /// Of a round corner: what is nearer than `corner` to a disc at this height; else 0.
    double corner = 0.0, disc = 0.0, height = 0.0;
  };
  struct Rim {
    double z, radius2;
  };
  int zones = 0, rims = 0;
  bool corners = false;  ///< some zones are round corners
  Zone zone[kMost];
  Rim rim[2 * kMost];
};

/// Tip and axis (unit) of a tool, mm. The axis rises or falls by kLeastAxisRise at the least (pose_solid.h).
struct PoseAt {
  double x, y, z, ax, ay, az;
};

/// A solid at poses that follow each other so closely that what lies between is held by them, but for what
/// its rims pass over. Leaves out no more than that, and covers nothing else. Solids with round corners have
/// no straight runs.
struct PoseRun {
  const PoseSolid* solid = nullptr;
  const PoseAt* poses = nullptr;
  int count = 0;
  bool straight = false;  ///< two poses of one direction, and the line between them: nothing is left out
};

/// A solid of one direction between two places, as seen along its axis: p falls as steeply as it can, q is
/// level, h goes along the axis, s along the way as seen so, n across it; all from the tip at the first
/// place.
struct AxialView {
  PoseAt at;              ///< first place
  double level;           ///< what p falls by, a mm of height: how far the axis leans
  double px, py, qx, qy;  ///< level parts of p and q
  double nx, ny;          ///< and of n
  double low_p, high_p, low_q, high_q, low_h, high_h;  ///< of the tip
  double up, uq, length;                               ///< direction of s in p and q, and the way along it
  double by_h, by_p, by_n;                             ///< height a mm of h, of p (falling), of n; finite
};

/// What bounds of a run look at: no point of the solid is ever farther from it in one of the views than
/// `between`, mm.
struct PoseSpan {
  const PoseSolid* solid;
  const AxialView* views;
  int count;
  double between;
  const double* min;  ///< bounds: x, y, z
  const double* max;
};

/// Columns that one call takes; arrays must have this size rounded up to a multiple of 8.
inline constexpr int kMaxColumns = 128;

/// lo and hi of the open interval that is covered, mm; lo = +infinity, hi = -infinity where there is none.
/// `count` <= kMaxColumns; reads and writes up to the next multiple of 8. Error below 1e-10 mm.
template <typename Way>
using ColumnKernel = void (*)(const Way& sweep, const double* x, const double* y, int count, double* lo,
                              double* hi);

/// The 64 columns of a leaf while it is cut, in quarters of 4x4: column x, y stands at leafColumn(x, y).
inline constexpr int leafColumn(int x, int y) {
  return (x >> 2) << 5 | (y >> 2) << 4 | (x & 3) << 2 | (y & 3);
}
inline constexpr int kQuarter = 16;

struct LeafColumns {
  double x[64], y[64];
  double top[64];  ///< height of the material, from the lowest sample to one step above the highest, mm
  double z[8];     ///< heights of the samples
  double h;        ///< mm
  unsigned char material[64];  ///< bit z
  unsigned char covered[64];   ///< samples that the last pass covers
  double lo[64], hi[64];       ///< of the last pass
  int layers;                  ///< layers up to the highest with material
  bool undercut;               ///< a pass covered a part of a column below its top
};

/// Finds lo and hi of the columns of `quarters` (bits). Those beside each other go together: a quarter alone
/// waits for every root.
template <typename Way>
using LeafKernel = void (*)(const Way& sweep, LeafColumns& leaf, unsigned quarters);
/// For one quarter: lowers the tops to lo where the pass covers them; returns the sum of what the tops sink
/// by and of the covered material below tops that stay, in mm of column height.
using LowerKernel = double (*)(LeafColumns& leaf, int quarter);
/// Of `quarters` (bits) those in which the sweep may cover something between a top and the lowest samples: of
/// ball ends and whole balls the others have none, for sure; of all else all. Finds no lo and hi. Requires of
/// ball ends that the columns are covered up to their tops, wherever the sweep covers them.
using HitKernel = unsigned (*)(const LineSweep& sweep, const LeafColumns& leaf, unsigned quarters);
/// Of `quarters` (bits) those in which the solid may cover something between a top and the lowest samples;
/// the others have none, for sure.
using PoseHitKernel = unsigned (*)(const PoseSpan& span, const LeafColumns& leaf, unsigned quarters);
/// For one quarter: finds `covered` from lo and hi.
using CoverKernel = void (*)(LeafColumns& leaf, int quarter);

/// Four blocks of the grid as culling sees them: squares of one size, with a range of z each.
struct FourBlocks {
  double x[4], y[4];  ///< of their middles, mm
  double half_width;  ///< mm
  double z_low[4], z_high[4];
};
/// Culling never decides within rounding, mm.
inline constexpr double kCullSlackMm = 1e-6;

/// For each block the heights below and above which the sweep does not reach inside its square, mm (bounds);
/// low = +infinity, high = -infinity where it misses the block.
template <typename Way>
using ReachKernel = void (*)(const Way& sweep, const FourBlocks& blocks, double* low, double* high);

/// Grid edges that a sweep cuts: where they enter its volume. Arrays as of a ColumnKernel.
struct EdgeCuts {
  int count = 0;
  double x[kMaxColumns], y[kMaxColumns], z[kMaxColumns];  ///< their ends in the material, mm
  double dx[kMaxColumns], dy[kMaxColumns];                ///< level direction, unit; vertical edges: 0, 0
  double inside[kMaxColumns];                             ///< a point in the volume so far on, mm
  /// 0: level; vertical: +1 where the edge is cut by the lower end of its column, -1 by the upper.
  double end[kMaxColumns];
  double at[kMaxColumns];     ///< found: distance from the end, mm; of level edges only
  double place[kMaxColumns];  ///< found: see CurveSide
  double found[kMaxColumns];  ///< 1: at and place are known
  double start[kMaxColumns];  ///< as EdgeCut::start; for who asks a body, no kernel knows it
};
/// Finds at and place, mostly. Error below 1e-8 mm.
using CutKernel = void (*)(const TurnSweep& sweep, EdgeCuts& cuts);

/// What the kernels know of every kind of way.
template <typename Way>
struct WayKernels {
  ColumnKernel<Way> columns;
  LeafKernel<Way> leaf;
  ReachKernel<Way> reach;
};

struct ColumnKernels {
  WayKernels<LineSweep> line;
  WayKernels<ArcSweep> arc;
  WayKernels<TurnSweep> turn;
  WayKernels<UprightSweep> upright;
  WayKernels<WaySweep> way;
  ColumnKernel<PoseRun> poses;
  LowerKernel lower;
  HitKernel hits;
  PoseHitKernel pose_hits;
  ReachKernel<PoseSpan> pose_reach;
  CoverKernel cover;
  CutKernel cuts;
  const char* name;
};

ColumnKernels baselineKernels();
ColumnKernels avx2Kernels();
ColumnKernels avx512Kernels();

}  // namespace proveout
