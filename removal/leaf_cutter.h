// One leaf of the stock while its motions pass through it, in program order.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "removal/stock_impl.h"
#include "removal/sweep.h"

namespace proveout {

enum class ToolPart : std::uint8_t { kCutter, kShank, kHolder };

/// One solid of one motion.
struct Pass {
  Sweep sweep;
  MotionId motion;
  ToolPart part;
  bool watched;  ///< contact with stock is a finding
};

/// Volumes per motion are summed as whole numbers of this part of a voxel, so that the sum does not depend on
/// threads.
inline constexpr double kVolumeUnit = 1.0 / 65536.0;

struct ContactSample {
  std::uint32_t pass;
  double depth;  ///< mm
  Vec3 where;
  std::int64_t volume;  ///< kVolumeUnit
};

/// Cuts leaves; one object a thread, used again and again.
class LeafCutter {
 public:
  LeafCutter(const Stock::Impl& impl, const std::deque<Pass>& passes) : impl_(impl), passes_(passes) {}

  /// Runs `list` (indices of passes, ascending) over the leaf at `origin`. False: there is no material to
  /// cut, nothing changes.
  bool cut(const openvdb::Coord& origin, const std::vector<std::uint32_t>& list, LeafResult& result);

  // What the last cut found.
  const std::vector<std::pair<MotionId, std::int64_t>>& removed() const { return removed_; }  ///< kVolumeUnit
  const std::vector<ContactSample>& contacts() const { return contacts_; }
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  struct EdgeHit {
    double s = 1.0;              ///< fraction of the edge from its material end
    const Pass* pass = nullptr;  ///< null: the surface that was there before
  };
  struct PassTotals {
    double removed = 0.0, contact_volume = 0.0;
    ContactSample contact{};
    bool near = false;
  };

  bool readBlock();
  void applyPass(std::uint32_t index);
  void applyColumn(const Pass& pass, int column, const double* values, PassTotals& totals);
  void addCrossings(LeafResult& result) const;
  Crossing crossing(const openvdb::Coord& at, int axis, int start, int end) const;
  EdgeHit findHit(const Vec3& a, const Vec3& step, int material, int empty, double first) const;
  void tryPass(const Pass& pass, double at_a, const Vec3& a, const Vec3& step, EdgeHit& hit) const;

  const Stock::Impl& impl_;
  const std::deque<Pass>& passes_;
  openvdb::Coord origin_;
  std::array<float, kBlockSize> distance_;
  std::array<std::uint32_t, kBlockSize> owner_;
  std::array<float, kBlock * kBlock> column_min_;
  int open_columns_ = 0;  ///< columns with a sample below the band
  /// The cutters that come near material, each with its distance (or a lower bound of it) at every sample.
  std::vector<const Pass*> near_;
  std::vector<float> near_distance_;
  std::vector<std::pair<MotionId, std::int64_t>> removed_;
  std::vector<ContactSample> contacts_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace proveout
