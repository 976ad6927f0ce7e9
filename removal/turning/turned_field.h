// A turned part, with its threads, as a blank of the grid.
#pragma once

#include <memory>

#include "removal/grid/blank_field.h"
#include "removal/grid/stock_shape.h"
#include "removal/turning/section/section.h"

namespace proveout {

/// The section's polygons turned about Z less what the thread tools sweep through. Faces carry the motions of
/// their edges and sweeps. volume() is that of the section alone. `shape` is not needed any more afterwards.
/// Errors: no body, a loop or a sweep that is not sound (says which and why).
Result<std::unique_ptr<BlankField>> makeTurnedField(const std::shared_ptr<const TurnedShape>& shape);

/// The part as a blank; Z is the spindle axis. `place`: from there into the workpiece frame.
FieldShape turnedStock(std::shared_ptr<const TurnedShape> shape, const RigidTransform& place = {});

/// Bounds of the section turned about Z; empty for null or without bodies.
Box3 turnedBounds(const TurnedShape* shape);

}  // namespace proveout
