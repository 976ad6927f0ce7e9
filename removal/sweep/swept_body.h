// One convex part of a tool on its way along a line, a chord of a curve or a level arc, and all that is asked
// of the volume that it sweeps there.
//
// A curve that has no parts of its own (column_curve.h, column_way.h) is cut into chords, each of them a
// body. The parts and chords of a curve share its exact sweep.
#pragma once

#include <optional>

#include "core/path/toolpath.h"
#include "removal/sweep/column_sweep.h"
#include "removal/sweep/sweep.h"

namespace proveout {

/// The surface of a swept volume at a point.
struct SweptSurface {
  Vec3 normal;  ///< unit, away from the swept volume
  int element;  ///< as SweepSample::element
};

/// Where an edge enters a volume.
struct EdgeCut {
  double at;     ///< distance from its end, mm
  double start;  ///< about the parameter of the curved motion whose tool is there; below 0: not known
};

class SweptBody {
 public:
  /// None: only to be assigned to.
  SweptBody() = default;
  /// A line; with `curve` a chord of the motion that `curve` is the exact sweep of. What is handed over must
  /// outlive the body, here and below; `solid`: columnSolid(profile).
  SweptBody(const ConvexProfile& profile, const ColumnSolid& solid, const Vec3& from, const Vec3& to,
            const Sweep* curve = nullptr);
  /// Requires a vertical axis, one radius and no rise; `curve`: the exact sweep of the arc.
  SweptBody(const ConvexProfile& profile, const ColumnSolid& solid, const Vec3& from, const Vec3& to,
            const ArcGeometry& arc, const Sweep& curve);

  /// A part of a curve (see column_sweep.h and column_way.h); `curve`: the exact sweep of all of it.
  SweptBody(const ConvexProfile& profile, const ColumnSweep& part, const Sweep& curve);

  const ConvexProfile& profile() const { return *profile_; }
  const ColumnSolid& solid() const { return *columns_.solid; }
  /// What the kernels of the columns take.
  const ColumnSweep& columns() const { return columns_; }

  bool isLine() const { return curve_ == nullptr; }
  bool isLevelArc() const { return columns_.kind == ColumnSweep::Kind::kArc; }
  /// Unit direction in which the solid passes beside `p`, of lines that are not upright and of level arcs;
  /// zero for other ways. What it leaves on its way is at right angles to that, what it leaves where it began
  /// or ended is not.
  Vec3 directionAt(const Vec3& p) const;
  /// A part of a curve that is no chord.
  bool isCurvePart() const { return isCurve(columns_); }
  /// Whether both are pieces of one curve.
  bool isOneCurveWith(const SweptBody& other) const { return curve_ != nullptr && curve_ == other.curve_; }
  /// The exact sweep of a helix about z that is asked in place of its many chords; else null. Flat and ball
  /// ends have closed forms on chords, which are faster.
  const Sweep* helix() const {
    if (curve_ == nullptr || isLevelArc() || isCurvePart() || solid().flat || solid().ball) return nullptr;
    return curve_->isHelix() ? curve_ : nullptr;
  }

  /// Of the whole curved motion; null for lines.
  const Sweep* curve() const { return curve_; }
  /// Exact sweep of this line, chord or level arc; of the whole motion where this is a part of a curve.
  Sweep sweep() const;
  /// Exact sweep of the whole motion.
  Sweep wholeSweep() const { return curve_ != nullptr ? *curve_ : sweep(); }

  /// Height that the solid nowhere reaches above on its way, mm.
  double highestReach() const {
    return columns_.z + std::max(columns_.rise, 0.0) + solid().z_max + kCullSlackMm;
  }
  /// Height up to which the columns under the solid are covered all along its way, mm. Requires a level top.
  double lowestTop() const { return columns_.z + std::min(columns_.rise, 0.0) + solid().z_max; }
  /// No point of a column is deeper in the solid at any place of its way, mm; for lines, chords and level
  /// arcs.
  double levelDepth(double x, double y) const;
  /// Whether a grid edge of length `h` that is no farther than `reach` from `middle` lies in the volume if
  /// both its ends do. All are convex, or bulky enough for that, but arcs that turn around a pillar which is
  /// thinner than the grid, and turns of a helix where their angles begin.
  bool holdsEdges(double h, const Vec2& middle, double reach) const;

  /// Distance from `a` along the level unit direction (dx, dy) to where the edge enters the volume, mm.
  /// Requires `a` outside (within rounding) and the point at `inside` mm in the volume. Closed form for flat
  /// and ball ends along lines, otherwise the root of the exact distance; error below 1e-8 mm.
  double levelCut(const Vec3& a, double dx, double dy, double inside) const;
  /// The same for parts of curves, which know where the tool is then.
  EdgeCut curveCut(const Vec3& a, double dx, double dy, double inside) const;
  /// Parameter of the whole curve at a place of this part, see CurveSide.
  double startOf(double place) const;

  /// The surface that the motion leaves at `p`, where the volume cuts a grid edge along `axis`; `below`: the
  /// material's end of a vertical edge is the lower one. `start`: see EdgeCut.
  SweptSurface surface(const Vec3& p, int axis, bool below, double start = -1.0) const;
  /// The same where it has a closed form: empty for curves and for tools other than flat and ball ends.
  std::optional<SweptSurface> closedSurface(const Vec3& p, int axis, bool below) const;
  /// Largest curvature (1/mm) of the face that an element of the profile (as SweepSample::element) leaves, if
  /// it is part of a plane, a sphere or a round cylinder, which several points and their normals show
  /// exactly; else nothing.
  std::optional<double> simpleBend(int element) const;

 private:
  double levelGap(double x, double y) const;
  double startAt(const Vec3& p) const;

  ColumnSweep columns_;
  const ConvexProfile* profile_ = nullptr;
  const Sweep* curve_ = nullptr;  ///< of the whole curved motion; null for lines
};

/// A place where the edge from `a` along a unit direction goes into the volume, by the root of the exact
/// distance; as SweptBody::levelCut.
double searchCut(const Sweep& sweep, const Vec3& a, const Vec3& direction, double inside);

}  // namespace proveout
