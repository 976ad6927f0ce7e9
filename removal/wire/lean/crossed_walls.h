// Where walls of a leaning wire's cut run through each other, so that they are made of more heights there.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/wire/lean/level_match.h"

namespace proveout {

/// A triangle that ran through another one.
struct CrossedTriangle {
  Box3 box;                     ///< mm, as its mesh holds it
  MotionId motion = kNoMotion;  ///< whose wall it is
  bool isLevel() const { return box.min.z() == box.max.z(); }
};

/// Of meshes that are one part or lie beside each other: those that run through others.
std::vector<CrossedTriangle> crossedTriangles(const TriMesh& mesh);

/// What sections have to be finer for.
class CrossedWalls {
 public:
  void add(const std::vector<CrossedTriangle>& more);
  /// Whether some are at a height, or near it: each time that more are added from farther off.
  bool at(double z) const;
  /// Whether walls between these loops, or these parts of them, are to be halved.
  bool within(double low, double high, const LevelLoop& lower, const LevelLoop& upper) const;
  bool within(double low, double high, const LevelLoop& lower, const LoopSpan& lower_span,
              const LevelLoop& upper, const LoopSpan& upper_span) const;

 private:
  std::vector<CrossedTriangle> triangles_;
  double beside_ = 0.0;  ///< heights that are near, mm
};

}  // namespace proveout
