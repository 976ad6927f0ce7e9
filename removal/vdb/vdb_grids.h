// A stock for people who write against OpenVDB: its tree as it is, grids made of it, and grids as blanks.
// Library proveout::vdb_grids, which brings OpenVDB with it; call openvdb::initialize() before files are read
// or written.
//
// Grids are in the workpiece frame, mm.
#pragma once

#include <openvdb/openvdb.h>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/grid/stock.h"
#include "removal/grid/vdb_tree.h"

namespace proveout {

/// The samples of the stock, not a copy: valid as long as the stock lives and is not cut.
const VdbTree& vdbTree(const Stock& stock);
/// From the index space of vdbTree, whose axes are z, x, y, into the workpiece frame.
openvdb::math::Transform::Ptr vdbTreeTransform(const Stock& stock);

/// Signed distance, below 0 in the material, as a narrow band of `half_width` voxels (1 to 100) on either
/// side. In the band it is the distance to the stock's mesh with a vertex for each cell, whose vertices are
/// on the surface: off by the chord height of a cell, h^2 / (8 r), where the surface has the radius r; its
/// sign is that of the sample. Errors: half_width out of range, nothing left of the stock, cancelled, as
/// Stock::surface.
Result<openvdb::FloatGrid::Ptr> levelSet(const Stock& stock, double half_width, Progress& progress);

/// The motion that left the surface, on all samples beside it: that of the nearest crossing of an edge of the
/// grid. -1: the blank, or a path before the last.
openvdb::Int32Grid::Ptr provenance(const Stock& stock);

/// A level set as a blank, to be cut on any grid: its zero as the trilinear interpolation has it. Errors: no
/// level set, a band of less than two voxels, a transform that is not linear and the same along all axes,
/// nothing inside.
Result<StockShape> blankOf(openvdb::FloatGrid::ConstPtr level_set);
/// The active voxels of a mask as a blank: the surface runs midway between a voxel inside and one outside.
/// Errors: as above.
Result<StockShape> blankOf(const openvdb::MaskGrid& mask);

}  // namespace proveout
