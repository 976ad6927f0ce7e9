// The volume under the piece of surface around a crossing, where the face is known and bends too much for
// what the piece's corners show of it.
#pragma once

#include <array>
#include <optional>

#include "removal/surface/cell/exact_faces.h"
#include "removal/surface/measure/quad_volume.h"
#include "removal/surface/mesh/surface_quads.h"

namespace proveout {

/// Answers for the quads of one leaf.
class ExactQuad {
 public:
  explicit ExactQuad(const Stock::Impl& impl, const Coord& origin);

  /// As quadVolume: the cone from `apex` to the surface that the body of the crossing's face has between the
  /// corners, found at points between them: to the sixth power of their distances on smooth faces.
  /// `feature_edges`: as QuadReader::featureEdgesOf; between two corners on one feature edge the piece ends
  /// at that. Lengths in leaf units. None where no pass made the face, where the face is a plane, a sphere or
  /// a round cylinder, of which the corners say as much, and where the body does not come to all of the
  /// piece.
  std::optional<QuadVolume> volume(const Quad& quad, const Crossing& c, const Vec3& apex,
                                   const std::array<Vec3, 4>& feature_edges);

 private:
  /// Points along an edge, and triangles on each of its sides.
  static constexpr int kParts = 4;
  struct Point {
    Vec3 p;
    Vec3 n = Vec3::Zero();  ///< unit, out of the material
  };
  using Row = std::array<Point, kParts + 1>;

  bool snap(Point& point, double depth = ExactFaces::kProbeDepth);
  bool between(const Point& from, const Point& to, Row& row);
  bool side(const Quad& quad, int i, const std::array<Point, 4>& corners,
            const std::array<Vec3, 4>& feature_edges, Row& row);
  bool readPiece(const Quad& quad, const std::array<Vec3, 4>& feature_edges);
  double bulge(int step) const;

  ExactFaces exact_;
  std::int64_t body_ = ExactFaces::kNoBody;
  std::array<Row, 4> spokes_, sides_;  ///< from the crossing to corner i; from there to the next corner
  std::array<std::array<Point, 3>, 4> inner_;  ///< of triangle i: at (1, 1), (1, 2), (2, 1) of the two spokes
};

}  // namespace proveout
