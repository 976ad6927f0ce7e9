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

class BlankField;

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
/// A body that tells its surface in closed form: what a process that keeps no grid has left of a blank.
class FieldBody {
 public:
  virtual ~FieldBody() = default;
  /// Does not need this object any more. Errors: a body that is not sound (says where and why).
  virtual Result<std::unique_ptr<BlankField>> field() const = 0;
  virtual Box3 bounds() const = 0;       ///< empty without a body
  virtual double aboutArea() const = 0;  ///< of its surface, mm2
  /// Whether the field's volume() is that of the whole body; else it is to be taken from the grid.
  virtual bool volumeIsExact() const = 0;
};
struct FieldShape {
  std::shared_ptr<const FieldBody> body;
  RigidTransform place = {};  ///< from the body's frame into the workpiece frame
};
using StockShape = std::variant<BoxShape, CylinderShape, MeshShape, SavedStock, FieldShape>;

/// Empty for a saved stock.
Box3 shapeBounds(const StockShape& shape);

/// Whether the mesh bounds a volume. Errors: no triangles, not closed (names the place), inside out.
Status checkSolid(const MeshShape& shape);

}  // namespace proveout
