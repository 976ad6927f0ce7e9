// Places the vertices of a leaf's cells and notes what is known of each.
#pragma once

#include "removal/surface/cell/crossing_table.h"
#include "removal/surface/cell/exact_faces.h"

namespace proveout {

/// How far vertices of cells with several sheets may leave them, in cells.
inline constexpr double kThinReach = 0.1;
/// Sheets of one cell keep their vertices this far apart (in cells), as seen from one to the other.
inline constexpr double kSheetGap = 0.01;

/// A crossed edge of a cell: what to add to the cell's index in a CrossingTable, its start and its axis.
struct CellEdge {
  std::int16_t offset;
  std::int8_t axis, cycle;
  std::array<float, 3> start;
};
struct CellPattern {
  int count = 0;
  std::array<CellEdge, 12> edges{};
};

/// Cells of one leaf, one after the other. What they share with others (steps, vertices outside, feature
/// edges) is kept in the leaf.
class LeafPlacer {
 public:
  LeafPlacer(const Stock::Impl& impl, SurfaceLeaf& leaf, const CrossingTable& crossings, LeafPatch* patch);

  struct Placed {
    Eigen::Vector3f p;
    std::uint16_t traits = 0;
  };

  Placed place(int bit, int z, int rank, CellShape shape);

 private:
  static constexpr double kNoLimit = 1e12;
  /// Chooses how the cell is read: where the path made none of its crossings, as before it.
  void chooseState(const Coord& voxel);

  CellVertex vertexOf(int count, bool may_bring, bool& brought);
  Placed placeOneSheet();
  Placed placeSheets(int sheets);

  /// The usual case: all crossings are of one face and their normals do not spread widely. The rule is that
  /// of placeVertex.
  bool placeOneFace(Eigen::Vector3f& p, Eigen::Vector3f& normal);

  /// Whether some crossings of a face are of the tool in passing, and others of the round where its motion
  /// began or ended.
  bool sweepEndsWithin(std::int64_t body, const std::array<Eigen::Vector3f, 12>& points,
                       const std::array<Eigen::Vector3f, 12>& normals, int count) const;

  static bool bends(const std::array<Eigen::Vector3f, 12>& normals, int count, const Eigen::Vector3f& mean);

  /// Where a sliver at the blank's face crosses no edge of the cell, the other faces may meet outside the
  /// blank.
  void keepInBlank(Vec3& p) const;

  int gather(int sheet);

  /// Whether a vertex is off the surface: on none of the faces of its crossings, or where another tool cut
  /// away what is there. Never near a crossing. Vertices of a blank whose faces are known are put onto them.
  bool isOffSurface(const Vec3& p, int count);

  /// Keeps how far a vertex is off the surface: no farther than the nearest crossing.
  void noteOff(double off, int count, const Vec3& p);

  /// Where cones seem to meet beyond the ends of all their bodies, below tips that are smaller than the cell,
  /// there is no vertex: it is put onto the surface, where the nearest body is as seen from the material. Of
  /// other faces the place where they seem to meet says more of the volume.
  bool bringToSurface(CellVertex& v, int count);

  /// Whether some other body comes to the faces that are trimmed before a vertex, on the way from it to their
  /// crossings, as the next motion does on one floor.
  bool goesOnBeside(const Vec3& p, int count);

  /// How far (in cells) before the vertex a face is trimmed that no other continues: there is surface beside
  /// the vertex that no crossing shows. 0 where there is none.
  double missedBy(const Vec3& p, int count);

  /// Whether a tool cut away what is at a vertex without making one of its crossings. Only asked where the
  /// vertex stands out from among them, as asking all tools is expensive.
  bool isCutAway(const Vec3& p, int count);

  /// Where a wall narrower than the cell ends, two sheets end at one place: their vertices are on the wrong
  /// sides of each other by no more than their uncertainty, and are put right.
  static void keepApart(std::span<Vec3> p, const std::array<Vec3, 4>& mean);

  bool bendsLittle(int count, Eigen::Vector3f& n) const;

  void keepGentle(const Eigen::Vector3f& p, const Eigen::Vector3f& n);

  /// The cell in hand.
  struct Cell {
    const CellPattern* pattern = nullptr;
    int edges = 0;            ///< index of its lowest corner's first edge in the table of crossings
    std::uint16_t place = 0;  ///< in its leaf, as in OutsideVertex
    std::uint16_t rank = 0;
    Vec3 origin = Vec3::Zero();  ///< leaf units
    std::uint8_t faces = 0;      ///< see oneSheetFaces
  };

  const Stock::Impl& impl_;
  SurfaceLeaf& leaf_;
  const CrossingTable& crossings_;
  LeafPatch* patch_;
  ExactFaces cut_, before_;
  bool has_before_;            ///< the blank's faces were known before the path
  ExactFaces* exact_ = &cut_;  ///< the one that answers for the cell
  Vec3 low_ = Vec3::Constant(-kNoLimit),
       high_ = Vec3::Constant(kNoLimit);  ///< the blank, in the leaf's cells
  Vec3 asked_ =
      Vec3::Constant(kNoLimit);  ///< the last place of this cell of which it was asked whether it is covered
  bool covered_ = false;
  Cell cell_;
  CellPattern joined_;  ///< of the cell, where it has joined faces
  std::array<SheetPoint, 12> points_;
};

}  // namespace proveout
