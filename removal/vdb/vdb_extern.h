// Grids and trees that OpenVDB's library holds: sources that include this do not make them again, which takes
// some twenty seconds of compilation each. Only for what is linked with that library. Clang would leave small
// members to it that Debian's, which GCC made, has inlined and does not hold.
#pragma once

#include <openvdb/openvdb.h>

#ifndef __clang__

#define PROVEOUT_IN_OPENVDB(TREE)            \
  extern template class openvdb::Grid<TREE>; \
  extern template class openvdb::tree::Tree<TREE::RootNodeType>;

PROVEOUT_IN_OPENVDB(openvdb::BoolTree)
PROVEOUT_IN_OPENVDB(openvdb::FloatTree)
PROVEOUT_IN_OPENVDB(openvdb::Int32Tree)
PROVEOUT_IN_OPENVDB(openvdb::MaskTree)
PROVEOUT_IN_OPENVDB(openvdb::Vec3STree)

#undef PROVEOUT_IN_OPENVDB

#endif
