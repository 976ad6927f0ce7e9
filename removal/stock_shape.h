// What the blank is, before it becomes a grid. Workpiece frame, mm.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

struct TurnedShape;

struct BoxShape {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();  ///< min < max in every coordinate
};
/// Cylinder or, with inner_radius > 0, tube along a coordinate axis.
struct CylinderShape {
  int axis = 2;               ///< 0 X, 1 Y, 2 Z
  Vec3 base = Vec3::Zero();   ///< centre of the lower end
  double radius = 0.0;        ///< > 0
  double inner_radius = 0.0;  ///< 0: solid; < radius
  double length = 0.0;        ///< > 0, along +axis
};
struct MeshShape {
  TriMesh mesh;  ///< closed, outward, checked by the maker of the stock
  std::string name;
};
/// A stock saved by an earlier run; its own grid spacing is used.
struct SavedStock {
  std::string path;
};
/// What turning left of a bar: removal/turning/section.h.
struct TurnedStockShape {
  std::shared_ptr<const TurnedShape> shape;  ///< Z is the spindle axis
  RigidTransform place = {};                 ///< from there into the workpiece frame
};
using StockShape = std::variant<BoxShape, CylinderShape, MeshShape, SavedStock, TurnedStockShape>;

/// Empty for a saved stock.
Box3 shapeBounds(const StockShape& shape);

/// Whether the mesh bounds a volume. Errors: no triangles, not closed (names the place), inside out.
Status checkSolid(const MeshShape& shape);

}  // namespace proveout
