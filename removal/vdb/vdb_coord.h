// Grid coordinates from and to OpenVDB. Only for the sources of the module that uses it.
#pragma once

#include <openvdb/openvdb.h>

#include "removal/grid/coord.h"

namespace proveout {

inline Coord fromVdb(const openvdb::Coord& c) { return {c.x(), c.y(), c.z()}; }
inline openvdb::Coord toVdb(const Coord& c) { return {c.x(), c.y(), c.z()}; }

}  // namespace proveout
