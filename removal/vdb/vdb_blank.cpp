// Level sets and masks as blanks, see vdb_grids.h.
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetMeasure.h>
#include <openvdb/tools/TopologyToLevelSet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "removal/grid/blank_field.h"
#include "removal/vdb/vdb_grids.h"

namespace proveout {

namespace {

constexpr double kLeastBand = 2.0;  ///< voxels

Vec3 fromVdb(const openvdb::Vec3d& v) { return {v.x(), v.y(), v.z()}; }

class LevelSetField final : public BlankField {
 public:
  LevelSetField(openvdb::FloatGrid::ConstPtr grid, const Box3& bounds)
      : grid_(std::move(grid)), bounds_(bounds), h_(grid_->voxelSize().x()) {}

  BlankSample sample(const Vec3& p) const override {
    const openvdb::Vec3d at = grid_->worldToIndex(openvdb::Vec3d(p.x(), p.y(), p.z()));
    return {valueAt(at), normalAt(at), 0};
  }
  double value(const Vec3& p) const override {
    return valueAt(grid_->worldToIndex(openvdb::Vec3d(p.x(), p.y(), p.z())));
  }
  Box3 bounds() const override { return bounds_; }
  double volume() const override { return openvdb::tools::levelSetVolume(*grid_); }

 private:
  double interpolated(const openvdb::Vec3d& at) const {
    return openvdb::tools::BoxSampler::sample(grid_->getConstUnsafeAccessor(), at);
  }

  /// In tiles, and beyond all, the border of the tile is no farther than the surface.
  double valueAt(const openvdb::Vec3d& at) const {
    const double band = interpolated(at);
    const openvdb::Coord voxel = openvdb::Coord::floor(at);
    const int depth = grid_->tree().getValueDepth(voxel);
    if (depth >= 3) return band;
    if (depth < 0) {
      const Vec3 p = fromVdb(grid_->indexToWorld(at));
      const Vec3 out = (bounds_.min - p).cwiseMax(p - bounds_.max).cwiseMax(Vec3::Zero());
      return std::max(band, out.norm());
    }
    const int dim = std::array{4096, 128, 8}[static_cast<std::size_t>(depth)];
    double border = dim;
    for (int axis = 0; axis < 3; ++axis) {
      const double within = at[axis] - (voxel[axis] & ~(dim - 1));
      border = std::min({border, within, dim - within});
    }
    return std::copysign(std::max(std::abs(band), border * h_), band);
  }

  /// Along each axis the interpolation is straight within a cell.
  Vec3 normalAt(const openvdb::Vec3d& at) const {
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      openvdb::Vec3d low = at, high = at;
      low[axis] = std::floor(at[axis]);
      high[axis] = low[axis] + 1.0;
      slope[axis] = interpolated(high) - interpolated(low);
    }
    const openvdb::Vec3d turned =
        grid_->transform().baseMap()->applyIJT(openvdb::Vec3d(slope.x(), slope.y(), slope.z()));
    const Vec3 normal = fromVdb(turned);
    return normal.norm() > 0.0 ? normal.normalized() : Vec3(0, 0, 1);
  }

  openvdb::FloatGrid::ConstPtr grid_;
  Box3 bounds_;
  double h_;  ///< mm
};

class LevelSetBody final : public FieldBody {
 public:
  explicit LevelSetBody(openvdb::FloatGrid::ConstPtr grid) : grid_(std::move(grid)) {
    const openvdb::CoordBBox box = grid_->evalActiveVoxelBoundingBox();
    const openvdb::BBoxd world =
        grid_->transform().indexToWorld(openvdb::BBoxd(box.min().asVec3d(), box.max().asVec3d()));
    bounds_ = {fromVdb(world.min()), fromVdb(world.max())};
  }

  Result<std::unique_ptr<BlankField>> field() const override {
    return std::unique_ptr<BlankField>(std::make_unique<LevelSetField>(grid_, bounds_));
  }
  Box3 bounds() const override { return bounds_; }
  double aboutArea() const override { return openvdb::tools::levelSetArea(*grid_); }
  bool volumeIsExact() const override { return false; }

 private:
  openvdb::FloatGrid::ConstPtr grid_;
  Box3 bounds_;
};

}  // namespace

Result<StockShape> blankOf(openvdb::FloatGrid::ConstPtr level_set) {
  if (level_set == nullptr || level_set->getGridClass() != openvdb::GRID_LEVEL_SET)
    return inputError("blank: the grid is no level set");
  if (!level_set->transform().isLinear() || !level_set->hasUniformVoxels())
    return inputError("blank: the transform of the level set is not linear with voxels of one size");
  if (level_set->background() < kLeastBand * level_set->voxelSize().x())
    return inputError("blank: the band of the level set is less than two voxels wide on either side");
  bool inside = false;
  for (auto it = level_set->cbeginValueOn(); it; ++it) {
    if (!std::isfinite(it.getValue()))
      return inputError("blank: the level set has a value that is not a number");
    inside = inside || it.getValue() < 0.0f;
  }
  if (!inside) return inputError("blank: nothing is inside of the level set");
  return StockShape(FieldShape{std::make_shared<const LevelSetBody>(std::move(level_set))});
}

Result<StockShape> blankOf(const openvdb::MaskGrid& mask) {
  if (mask.empty()) return inputError("blank: the mask has no active voxel");
  constexpr int kBand = 3;
  return blankOf(openvdb::FloatGrid::ConstPtr(openvdb::tools::topologyToLevelSet(
      mask, kBand, /*closingSteps=*/0, /*dilation=*/0, /*smoothingSteps=*/0)));
}

}  // namespace proveout
