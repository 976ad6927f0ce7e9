// The volume that one convex part of a tool sweeps on its way along a motion, or a piece of it, and all that
// is asked of it. Which kinds of bodies there are (body_list.h) and which of them a motion has
// (motion_bodies.h) is known in this folder alone.
//
// A body covers one interval of each vertical line at most. What covers more is several bodies, pieces of one
// volume: turns of a helix, chords of a curve, what a column sees first and second of a way that bends.
// Pieces share the exact field of all of it.
#pragma once

#include <optional>
#include <variant>

#include "removal/sweep/body_answers.h"
#include "removal/sweep/body_list.h"

namespace proveout {

class SweptBody {
 public:
  /// None: only to be assigned to.
  SweptBody() = default;
  /// `whole`: the field of all that this is a piece of; null for lines, and for them alone: then it is no
  /// piece. What is handed over by place must outlive the body.
  SweptBody(const ConvexProfile& profile, const BodyKind& kind, const SweptField* whole = nullptr)
      : of_{&profile, whole}, kind_(kind) {}

  const ConvexProfile& profile() const { return *of_.profile; }
  /// Whether both are pieces of one volume; false for one that is no piece, also of itself.
  bool isPieceWith(const SweptBody& other) const { return isPiece() && of_.whole == other.of_.whole; }
  bool isPiece() const { return of_.whole != nullptr; }
  /// Direction of the tool's axis, upwards, where it is one on all of the way; else zero.
  Vec3 axis() const {
    return std::visit([](const auto& kind) { return kind.axis(); }, kind_);
  }

  // Many at once: each call finds out once what the body is.

  /// As ColumnKernel: of the columns x, y the interval that is covered.
  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    std::visit([&](const auto& kind) { kind.columns(x, y, count, lo, hi); }, kind_);
  }
  /// As LeafKernel.
  void leafColumns(LeafColumns& leaf, unsigned quarters) const {
    std::visit([&](const auto& kind) { kind.leafColumns(leaf, quarters); }, kind_);
  }
  /// Of `quarters` (bits) of a leaf, whose tops are not above `highest`, those from which the body may take
  /// something; the others have nothing for it, for sure. Where it does not know, all.
  unsigned hits(const LeafColumns& leaf, unsigned quarters, double highest) const {
    return std::visit([&](const auto& kind) { return kind.hits(leaf, quarters, highest); }, kind_);
  }
  /// As ReachKernel.
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    std::visit([&](const auto& kind) { kind.reach(blocks, low, high); }, kind_);
  }
  /// Whether edges of a leaf are to be cut together by cutEdges, not one by one by levelCut.
  bool cutsTogether() const {
    return std::visit([](const auto& kind) { return kind.cutsTogether(); }, kind_);
  }
  /// Finds `at` and `start` of edges. Requires cutsTogether.
  void cutEdges(EdgeCuts& cuts) const;

  // Bounds.

  /// Height that the body nowhere reaches above, mm.
  double highestReach() const;
  /// Height up to which the columns under the solid are covered all along its way, mm; -infinity where that
  /// is not known.
  double coveredTop() const;
  /// Whether the body covers its columns up to `height` at the least, wherever it covers them. False where
  /// that is not known.
  bool coversUpTo(double height) const {
    return std::visit([&](const auto& kind) { return kind.coversUpTo(height); }, kind_);
  }
  /// No point of a column is deeper in the solid at any place of its way, mm.
  double mostDepth(double x, double y) const;
  /// Whether the volume holds what is between any two of its points. False where that is not known.
  bool isConvex() const {
    return std::visit([](const auto& kind) { return kind.isConvex(); }, kind_);
  }
  /// Whether a grid edge of length `h` that is no farther than `reach` from `middle` lies in the volume if
  /// both its ends do. All are convex, or bulky enough for that, but arcs that turn around a pillar which is
  /// thinner than the grid, and turns of a helix where their angles begin.
  bool holdsEdges(double h, const Vec2& middle, double reach) const;

  // The surface.

  /// Where the edge from `a` along the level unit direction (dx, dy) enters the volume. Requires `a` outside
  /// (within rounding) and the point at `inside` mm in the volume. Error below 1e-8 mm.
  EdgeCut levelCut(const Vec3& a, double dx, double dy, double inside) const;
  /// The surface that the motion leaves at `p`, where the volume cuts a grid edge along `axis`; `below`: the
  /// material's end of a vertical edge is the lower one. `start`: see EdgeCut.
  SweptSurface surface(const Vec3& p, int axis, bool below, double start = -1.0) const;
  /// The same where it has a closed form; else nothing.
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
  /// As SweptField::distance; copies no curve.
  double distance(const Vec3& p, double cutoff) const;
  /// Whether points and edges are to be asked of all of it, with the questions below, not of its pieces. Of
  /// pieces of one volume all or none.
  bool isAskedWhole() const;
  bool covers(const Vec3& p) const { return distance(p, 0.0) < 0.0; }
  /// As SweptField::holds.
  bool holds(const Vec3& a, const Vec3& b) const;
  /// As levelCut, along any unit direction: distance from `a`, mm.
  double wholeCut(const Vec3& a, const Vec3& direction, double inside) const;

  // For who follows the tool on its way.

  /// The solid, where its axis is upright on all the way; else null.
  const ColumnSolid* uprightSolid() const;
  /// Length of the body's own way, mm; nothing where the way is followed along all of its motion.
  std::optional<double> ownLength() const;
  /// Requires ownLength. `t`: 0 to 1.
  ToolPlace placeAt(double t) const;

 private:
  BodyContext of_;
  BodyKind kind_;
};

}  // namespace proveout
