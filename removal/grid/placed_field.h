// A blank with a closed form at another place.
#pragma once

#include <memory>

#include "core/geometry/rigid_transform.h"
#include "removal/grid/blank_field.h"

namespace proveout {

/// True for the move that moves nothing.
bool staysInPlace(const RigidTransform& move);

/// `field` moved by `place`; itself where that moves nothing.
std::unique_ptr<BlankField> placeField(std::unique_ptr<BlankField> field, const RigidTransform& place);

/// The field of a body at its place. Errors: as FieldBody::field.
Result<std::unique_ptr<BlankField>> placedField(const FieldShape& shape);

}  // namespace proveout
