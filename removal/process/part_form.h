// What a process knows of a part that it made, besides the mesh: asked for it, nobody has to know which
// process that was.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/path/toolpath.h"
#include "removal/compare/exact_part.h"
#include "removal/grid/stock_shape.h"
#include "removal/turning/section/section.h"

namespace proveout {

/// This one is of a part that is known as its grid or its mesh alone.
class PartForm {
 public:
  virtual ~PartForm() = default;
  /// Half section of the part about Z: radius and z, mm, each edge with its motion; null: it has none, or
  /// nothing is left of the part.
  virtual const std::vector<SectionLoop>* profile() const { return nullptr; }
  /// Whether the profile holds everywhere about Z: no thread was cut.
  virtual bool revolved() const { return false; }
  /// The axis that pictures turn about, a point in the plane Z0.
  virtual std::optional<Vec2> pictureAxis() const { return std::nullopt; }
  /// The part as exact as it is known without a grid; none: its bodies are to be taken from paths or mesh.
  virtual std::optional<Result<std::unique_ptr<ExactPart>>> exactPart() const { return std::nullopt; }
  /// The part as the blank of what was cut behind it, moved; none: it has no closed form.
  virtual std::optional<StockShape> asBlank(const RigidTransform& /*moved*/) const { return std::nullopt; }
  /// Whether the part is known in closed form: then no grid stands for it, and moves cost nothing.
  virtual bool closedForm() const { return false; }
  /// How far chords of a grid's mesh may lie off the part, mm; none where it has no closed form: that is a
  /// matter of the tools used.
  virtual std::optional<double> gridChords(double /*resolution_mm*/) const { return std::nullopt; }
  /// A body that a motion cut off the rest: its number among the bodies of the clamping.
  struct Parted {
    std::size_t body;
    MotionId by;
  };
  virtual std::vector<Parted> parted() const { return {}; }

  /// The one of no special form.
  static const std::shared_ptr<const PartForm>& plain();
};

}  // namespace proveout
