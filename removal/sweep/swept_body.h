// The volume that one convex part of a tool sweeps on its way along a motion, or a piece of it, and all that
// is asked of it. Which kinds of ways there are, and which of them a body has, is known in this folder alone.
//
// A body covers one interval of each vertical line at most. What covers more is several bodies, pieces of one
// volume: turns of a helix, chords of a curve, what a column sees first and second of a way that bends
// (motion_bodies.h). Pieces share the exact field of all of it.
#pragma once

#include <optional>

#include "removal/sweep/column_sweep.h"
#include "removal/sweep/swept_field.h"

namespace proveout {

/// The surface of a swept volume at a point.
struct SweptSurface {
  Vec3 normal;  ///< unit, away from the swept volume
  int element;  ///< as SweepSample::element
};

/// Where an edge enters a volume.
struct EdgeCut {
  double at;            ///< distance from its end, mm
  double start = -1.0;  ///< about the parameter of the motion whose tool is there; below 0: not known
};

/// A place of an upright tool on its way.
struct ToolPlace {
  Vec3 at;       ///< tip, mm
  Vec2 forward;  ///< unit
};

class SweptBody {
 public:
  /// None: only to be assigned to.
  SweptBody() = default;
  /// `whole`: the field of all that this is a piece of; null: it is no piece. All must outlive the body.
  SweptBody(const ConvexProfile& profile, const ColumnSweep& columns, const SweptField* whole = nullptr)
      : columns_(columns), profile_(&profile), whole_(whole) {}

  const ConvexProfile& profile() const { return *profile_; }
  /// Whether both are pieces of one volume; false for one that is no piece, also of itself.
  bool isPieceWith(const SweptBody& other) const { return whole_ != nullptr && whole_ == other.whole_; }
  bool isPiece() const { return whole_ != nullptr; }
  /// Direction of the tool's axis, upwards, where it is one on all of the way; else zero.
  Vec3 axis() const { return Vec3::UnitZ(); }

  // Many at once: each call finds out once what the body is.

  /// As ColumnKernel: of the columns x, y the interval that is covered.
  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    columnKernels().columns(columns_, x, y, count, lo, hi);
  }
  /// As LeafKernel.
  void leafColumns(LeafColumns& leaf, unsigned quarters) const {
    columnKernels().leaf(columns_, leaf, quarters);
  }
  /// As HitKernel.
  unsigned hits(const LeafColumns& leaf, unsigned quarters) const {
    return columnKernels().hits(columns_, leaf, quarters);
  }
  /// As ReachKernel.
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    columnKernels().reach(columns_, blocks, low, high);
  }
  /// Whether edges of a leaf are to be cut together by cutEdges, not by levelCut.
  bool cutsTogether() const { return columns_.kind == ColumnSweep::Kind::kTurn; }
  /// Finds `at` and `start` of edges. Requires cutsTogether.
  void cutEdges(EdgeCuts& cuts) const;

  /// Height that the body nowhere reaches above, mm.
  double highestReach() const {
    return columns_.z + std::max(columns_.rise, 0.0) + columns_.solid->z_max + kCullSlackMm;
  }
  /// Height up to which the columns under the solid are covered all along its way, mm; -infinity where that
  /// is not known.
  double coveredTop() const;
  /// Whether the body covers its columns up to `height` at the least, wherever it covers them. False where
  /// that is not known.
  bool coversUpTo(double height) const { return !isCurvePart() && coveredTop() > height; }
  /// No point of a column is deeper in the solid at any place of its way, mm.
  double mostDepth(double x, double y) const;
  /// Whether the volume holds what is between any two of its points.
  bool isConvex() const { return whole_ == nullptr; }
  /// Whether a grid edge of length `h` that is no farther than `reach` from `middle` lies in the volume if
  /// both its ends do. All are convex, or bulky enough for that, but arcs that turn around a pillar which is
  /// thinner than the grid, and turns of a helix where their angles begin.
  bool holdsEdges(double h, const Vec2& middle, double reach) const;

  /// Distance from `a` along the level unit direction (dx, dy) to where the edge enters the volume. Requires
  /// `a` outside (within rounding) and the point at `inside` mm in the volume. Error below 1e-8 mm.
  EdgeCut levelCut(const Vec3& a, double dx, double dy, double inside) const;

  /// The surface that the motion leaves at `p`, where the volume cuts a grid edge along `axis`; `below`: the
  /// material's end of a vertical edge is the lower one. `start`: see EdgeCut.
  SweptSurface surface(const Vec3& p, int axis, bool below, double start = -1.0) const;
  /// The same where it has a closed form: empty for curves and for tools other than flat and ball ends.
  std::optional<SweptSurface> closedSurface(const Vec3& p, int axis, bool below) const;
  /// Largest curvature (1/mm) of the face that an element of the profile (as SweepSample::element) leaves, if
  /// it is part of a plane, a sphere or a round cylinder, which several points and their normals show
  /// exactly; else nothing.
  std::optional<double> simpleBend(int element) const;
  /// Unit direction in which the solid passes beside `p`, of lines that are not upright and of level arcs;
  /// zero where that is not known. What it leaves on its way is at right angles to that, what it leaves where
  /// it began or ended is not.
  Vec3 directionAt(const Vec3& p) const;

  // All of the volume that this is a piece of.

  SweptField field() const;
  /// As SweptField::distance; copies nothing.
  double distance(const Vec3& p, double cutoff) const;
  /// Whether points and edges are asked of it with the five questions below, in place of its pieces.
  bool isAskedWhole() const;
  bool covers(const Vec3& p) const { return distance(p, 0.0) < 0.0; }
  /// As SweptField::holds.
  bool holds(const Vec3& a, const Vec3& b) const { return field().holds(a, b); }
  /// As levelCut, along any unit direction.
  double wholeCut(const Vec3& a, const Vec3& direction, double inside) const;

  // For who follows the tool on its way.

  /// The solid, where its axis is upright on all the way; else null.
  const ColumnSolid* uprightSolid() const { return columns_.solid; }
  /// Length of the body's own way, mm; nothing where the way is followed along all of its motion.
  std::optional<double> ownLength() const;
  /// Requires ownLength. `t`: 0 to 1.
  ToolPlace placeAt(double t) const;

 private:
  bool isLine() const { return whole_ == nullptr; }
  bool isLevelArc() const { return columns_.kind == ColumnSweep::Kind::kArc; }
  bool isCurvePart() const { return isCurve(columns_); }
  const ColumnSolid& solid() const { return *columns_.solid; }
  SweptField ownField() const;
  EdgeCut curveCut(const Vec3& a, double dx, double dy, double inside) const;
  double startOf(double place) const;
  double levelGap(double x, double y) const;
  double startAt(const Vec3& p) const;

  ColumnSweep columns_;
  const ConvexProfile* profile_ = nullptr;
  const SweptField* whole_ = nullptr;
};

/// A place where the edge from `a` along a unit direction goes into the volume, by the root of the exact
/// distance; as SweptBody::levelCut.
double searchCut(const SweptField& field, const Vec3& a, const Vec3& direction, double inside);

}  // namespace proveout
