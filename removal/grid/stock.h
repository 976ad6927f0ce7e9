// The stock: what is left of the blank. Samples on a regular grid, inside or outside, together with the exact
// crossings of the grid's edges with the surface, their normals and the motion that made each.
//
// Its own inside is stock_impl.h; remove() is in process/, surface() and volume() are in surface/.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

struct RemovalOptions {
  double resolution_mm = 0.2;  ///< grid spacing, > 0
  int threads = 0;             ///< 0: all cores
  double max_memory_gb = 0.0;  ///< refuse above it (exit 3); 0: what the machine has free
  bool watch_all = false;  ///< every touch of the stock is a contact, in feed too (the stock is a fixture)
  /// Of boxes and cylinders only what lies in here is built, mm: for a stock that is only asked about
  /// touches, by what stays a few cells off the borders. Its surface and volumes are not to be asked for.
  std::optional<Box3> window = {};
};

/// kInsertBack: a side of a lathe insert that has to stay clear; kAxis: a lathe tool cuts beyond the axis.
/// kWire: a wire; kByHand: a rapid of one that the operator may have cut before it.
enum class ContactKind {
  kRapid,
  kShank,
  kHolder,
  kSpindleOff,
  kFixture,
  kInsertBack,
  kAxis,
  kPartedOff,
  kWire,
  kByHand
};
inline constexpr std::size_t kContactKinds = 10;

/// The tool touched stock where it must not. One per unbroken run of motions with the same kind, tool and
/// program block.
struct Contact {
  ContactKind kind = ContactKind::kRapid;
  MotionId motion = kNoMotion;  ///< first motion of the contact
  MotionId last = kNoMotion;    ///< last one
  Vec3 where = Vec3::Zero();    ///< the deepest point of the part, mm
  /// How far that point lies below the surface of the stock as it was when the motion began: the distance to
  /// the nearest surface, so that a wall which the tool goes right through counts with half its thickness; of
  /// turned parts also how far the old surface was from what is left (contactDepth), if that is more. To a
  /// micrometre, but where an earlier clamping or a mesh made a curved surface: there to the chords of the
  /// grid.
  double depth_mm = 0.0;
  /// Stock that was in the way: counted in grid cells, or for less than one by what a cutter moves the
  /// surface by; 0 for what does not cut and meets less than a cell.
  double volume_mm3 = 0.0;
};

/// Cuts of one tool that are narrower than the grid and not in the mesh.
struct NarrowCut {
  MotionId motion = kNoMotion;  ///< first motion with such a cut
  Vec3 where = Vec3::Zero();    ///< in it, mm
  double width_mm = 0.0;        ///< of the narrowest: across the path, or the height of a disc
  double length_mm = 0.0;       ///< of path
  double area_mm2 = 0.0;        ///< length times width
};

/// A place where a wire is to be threaded and touches material.
struct ThreadingFault {
  MotionId next = kNoMotion;      ///< motion behind it
  Vec3 where = Vec3::Zero();      ///< mm
  double wire_mm = 0.0;           ///< diameter of the wire
  double needs_mm = 0.0;          ///< a hole about its place must be wider than this
  std::optional<double> hole_mm;  ///< diameter of the start hole in which it is; none: it is in none
};

/// A piece that a wire cut free and that fell.
struct FallenPiece {
  MotionId motion = kNoMotion;   ///< that closed the cut
  MotionId through = kNoMotion;  ///< first cut before the next stop that goes where the piece may still lie
  Vec3 where = Vec3::Zero();     ///< in it, mm
  double volume_mm3 = 0.0;
  bool lifts = true;  ///< of those that cannot fall: upwards it could leave
};

/// Material between the end of a wire's cut and what it has cut before, on which a piece hangs.
struct UncutBridge {
  MotionId motion = kNoMotion;  ///< whose cut ends there, or begins
  Vec3 where = Vec3::Zero();    ///< its middle, mm
  double width_mm = 0.0;        ///< of what is left, where it is narrowest
  double open_mm = 0.0;         ///< way of the wire that would close the contour
  double volume_mm3 = 0.0;      ///< of the piece; 0: several bridges hold it
};

struct RemovalSummary {
  std::vector<float> removed_mm3;  ///< per motion, counted in parts of grid cells; see fitRemovedVolume
  /// In program order. Of a path that never starts the spindle the first cut stands for all of them
  /// (kSpindleOff).
  std::vector<Contact> contacts;
  /// Stock left thinner than a grid cell, which the grid cannot hold: about its area (0: none) and one place.
  double lost_film_mm2 = 0.0;
  Vec3 lost_film_at = Vec3::Zero();
  /// About its volume: so much more may be counted as removed than was. In no StockVolume::error_mm3.
  double lost_mm3 = 0.0;
  std::vector<NarrowCut> narrow_cuts;     ///< by number of the tool
  std::vector<ThreadingFault> threading;  ///< in program order
  std::vector<FallenPiece> fallen;        ///< in the order of their fall
  std::vector<FallenPiece> stuck;         ///< those that came free and whose walls keep them from falling
  std::vector<UncutBridge> bridges;
  std::uint64_t voxel_evaluations = 0;
};

/// Sum over the motions, mm3: before it is fitted what the grid's columns or points count.
double countedVolume(const RemovalSummary& removal);
/// Scales the volumes of the motions so that their sum is the exact removed volume (initial less final, mm3).
void fitRemovedVolume(RemovalSummary& summary, double exact_total_mm3);

struct SurfaceOptions {
  /// How far the mesh may leave the surface so that triangles are saved, mm; 0: one vertex for each grid cell
  /// with surface, flat or not; below 0: a tenth of the grid spacing.
  double simplify_mm = -1.0;
  int threads = 0;  ///< 0: all cores
};

/// Integrated from the exact edge crossings.
struct StockVolume {
  double mm3 = 0.0;
  /// By how much it may be off, about: where the surface bends or breaks between crossings. Not in it is what
  /// no crossing shows.
  double error_mm3 = 0.0;
  /// And beside its edges, where nothing but crossings is known (a saved stock).
  double edges_mm3 = 0.0;
};

/// How far the facets of a mesh may be off the true surface, at most, before any are saved: measured where
/// they are, over what they reach.
struct FacetError {
  double mm = 0.0;
  Vec3 where = Vec3::Zero();  ///< the worst place, mm

  void see(const FacetError& other) {
    if (other.mm > mm) *this = other;
  }
};

/// Surface of the stock as a closed 2-manifold, and the volume from the exact edge crossings.
struct StockSurface {
  TriMesh mesh;                   ///< with `motion` per triangle
  double volume_mm3 = 0.0;        ///< see StockVolume; the same however the mesh is simplified
  double volume_error_mm3 = 0.0;  ///< see StockVolume
  /// Material in places that no crossing shows, beside `volume_mm3`; below 0 where there is less. Known of a
  /// box or cylinder and the first path in it; else 0.
  double unseen_mm3 = 0.0;
  FacetError facets;
  /// Grid cells in which more than one sheet of surface runs, or whose vertex is off the surface by more than
  /// a fifth of a cell: walls, gaps or ridges there are thinner than the grid resolves, and the mesh is less
  /// exact.
  std::size_t thin_cells = 0;
  /// Pairs of triangles that run through each other and could not be parted.
  std::size_t self_intersections = 0;
};

/// Whether saved stocks and blanks from meshes can be read and stocks be saved here. Error: the module for
/// them cannot be loaded, and where it belongs.
Status checkStockFiles();

/// True for turns that take the axes to axes exactly (multiples of 90 degrees), with any shift.
bool movesExactly(const RigidTransform& move);

class Stock {
 public:
  Stock();
  ~Stock();
  Stock(Stock&&) noexcept;
  Stock& operator=(Stock&&) noexcept;

  /// Builds the blank. Errors: empty or non-finite shape, open mesh (names the place), unreadable .vdb,
  /// grid too large for the memory allowed (names the resolution that fits).
  static Result<Stock> create(const StockShape& shape, const RemovalOptions& options, Progress& progress);

  /// Cuts the path into the stock. `tools` must hold every tool number that the path uses.
  /// The result does not depend on `threads`. A cancelled run leaves the stock unspecified.
  Result<RemovalSummary> remove(const Toolpath& path, const std::vector<Tool>& tools,
                                const RemovalOptions& options, Progress& progress);

  /// The order of vertices and triangles does not depend on `threads`. Errors: cancelled, out of memory.
  Result<StockSurface> surface(const SurfaceOptions& options, Progress& progress) const;
  /// With the default tolerance.
  Result<StockSurface> surface(int threads, Progress& progress) const;
  /// That of the surface alone. What a path took is this before it less this after it, with the same options:
  /// exactly 0 where it took nothing. Errors: as surface.
  Result<StockVolume> volume(const SurfaceOptions& options, Progress& progress) const;

  /// The stock at another place, as a blank on a grid of the same spacing; which motion made a surface is not
  /// known any more. From which nothing was taken is made anew from the moved shape, if that is of its kind.
  /// What was cut is exact where movesExactly; else it is built anew from the surface's mesh: a curved wall
  /// then is off by the mesh's chord height, h^2 / (8 r), on top of that of the new mesh. Errors: nothing is
  /// left of the stock, not enough memory.
  Result<Stock> moved(const RigidTransform& move, const RemovalOptions& options, Progress& progress) const;
  /// A copy that knows its crossings, and nothing of the faces between them.
  Stock crossingsAlone() const;

  /// Takes away what lies outside of a closed mesh, whose motions the new surface gets; walls and gaps of the
  /// mesh that are thinner than the grid are lost. Errors: as checkSolid; the stock is as before.
  Status keepWithin(const MeshShape& body);

  /// Takes away what has come loose: connected pieces of samples within these bounds of bodies, of which
  /// `kept` are those of the body that stays. What is left is as it was.
  void dropPieces(const std::vector<Box3>& loose, const Box3& kept);

  /// Writes grid, crossings and provenance; whole file or none. The swept volumes are not written: the
  /// surface of a loaded stock has its vertices from the crossings alone, off by up to some 30 micrometres on
  /// a grid of 0.2 mm on faces with radii below two cells.
  Status save(const std::string& path) const;

  /// Of the blank's own shape, mm3: by its closed form, or of its mesh; volume() differs by what the grid
  /// cannot hold. Of a saved stock that of its first blank.
  double initialVolume() const;
  double resolution() const;  ///< mm
  Box3 bounds() const;        ///< of the blank, within what keepWithin left of it, mm

  struct Impl;  ///< removal/grid/stock_impl.h
  const Impl& inside() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace proveout
