// A stock with upright walls that a wire cuts all through, without a grid: where the wire always stands
// upright one section of lines and arcs, exact but for rounding to nanometres; where it leans sections at
// many heights.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock.h"
#include "removal/wire/falls/body_exit.h"
#include "removal/wire/falls/wire_holding.h"
#include "removal/wire/lean/lean_solid.h"
#include "removal/wire/section/plane_region.h"
#include "removal/wire/section/prism_blank.h"

namespace proveout {

struct LeanWork;
struct LeanFall;

/// A connected piece of what a wire left.
struct WireBody {
  double volume_mm3 = 0.0;
  Box3 bounds;  ///< mm
};

class WireStock {
 public:
  explicit WireStock(PrismBlank blank);

  /// Before remove: where fixtures hold the blank, see PrismBlank.
  void holdAt(PlanePolygons polygons) { blank_.held_at = std::move(polygons); }

  /// Cuts the path; once. Feed motions with a threaded wire cut by its radius and its spark gap, wherever the
  /// blank is. Rapids that meet what is held then are contacts (kRapid, kByHand), and places where the wire
  /// is threaded into it are told: of leaning wires at the bottom, at the top or half way. A piece that
  /// nothing holds falls as soon as it is free, if its walls let it: nothing cuts it any more. What a motion
  /// removed is estimated at stations along it. Where a wire leans, triangles of mesh() leave the surface by
  /// no more than `tolerance` mm (> 0). Errors: a tool that is no wire or is missing, cancelled, see
  /// leanSolid().
  Result<RemovalSummary> remove(const Toolpath& path, const std::vector<Tool>& tools, double tolerance,
                                Progress& progress);
  /// In place of remove(): the bodies alone, without contacts and what each motion removed. `pieces`, if it
  /// is given, gets what came free and the bridges.
  Status cut(const Toolpath& path, const std::vector<Tool>& tools, double tolerance, Progress& progress,
             RemovalSummary* pieces = nullptr);

  /// What is left, the largest first.
  const std::vector<WireBody>& bodies() const { return bodies_; }
  /// By body what it covers at a height, seen from +z: upright walls with chords within 0.0001 mm, leaning
  /// ones at the nearest section that was made. Empty polygons: it does not reach there.
  std::vector<PlanePolygons> outlinesAt(double z) const;
  /// Of the bodies named, a shell each. Of upright walls chords leave arcs by no more than `tolerance` mm.
  TriMesh mesh(const std::vector<std::size_t>& bodies, double tolerance) const;
  /// Whether meshes are known not to run through themselves, or each other: they were searched.
  bool knownSound() const { return solids_.size() == 1 && !solids_.front().runs_through_itself; }
  /// Whether a body can leave past another.
  BodyExit exit(std::size_t body, std::size_t past) const;
  const PrismBlank& blank() const { return blank_; }
  double initialVolume() const;  ///< mm3, of the blank
  double volume() const;         ///< mm3, of what is left
  /// By how much that may be off, about: where leaning walls come together pieces come free at a moment that
  /// is known but for some way of the wire.
  double volumeError() const { return error_mm3_; }

 private:
  /// What is found: of the motions, and of pieces and bridges; null: nothing.
  struct Wanted {
    RemovalSummary* motions;
    RemovalSummary* pieces;
  };
  Status cutUpright(const Toolpath& path, const std::vector<Tool>& tools, const Wanted& wanted,
                    Progress& progress);
  Status cutLeaning(const Toolpath& path, const std::vector<Tool>& tools, double tolerance,
                    const Wanted& wanted, Progress& progress);
  void handleLeaning(const Toolpath& path, const std::vector<Tool>& tools, const LeanWork& work,
                     const std::vector<LeanFall>& falls, RemovalSummary& summary, Progress& progress) const;
  void tellPieces(const Toolpath& path, const LeanWork& work, const std::vector<LeanFall>& falls,
                  RemovalSummary& summary) const;
  struct InSolid {
    std::size_t solid, body;
  };
  bool anyHolds(const std::vector<InSolid>& pieces, const Vec2& at, double z) const;
  std::vector<Vec2> heldPlaces(const std::vector<LeanFall>& falls, double z) const;
  bool isOfPiece(std::size_t body, const std::vector<InSolid>& fallen) const;
  Status keepFallen(const std::vector<LeanStretch>& cuts, std::vector<LeanFall>& falls, double tolerance,
                    Progress& progress);
  void setSections(std::vector<PlaneBody> sections);
  void setBodies();

  PrismBlank blank_;
  std::vector<PlaneBody> sections_;  ///< by body, where no wire leaned
  /// Where one did: what all cuts leave, and what there was when pieces fell that others passed over.
  std::vector<LeanSolid> solids_;
  std::vector<InSolid> placed_;  ///< by body, of those
  std::vector<WireBody> bodies_;
  double error_mm3_ = 0.0;
};

}  // namespace proveout
