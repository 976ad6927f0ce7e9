// Samples of one leaf while its passes go through it, in program order.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "removal/cut/leaf_stacks.h"
#include "removal/cut/near_samples.h"
#include "removal/cut/pass.h"
#include "removal/grid/leaf_changes.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// Volumes per motion are summed as whole numbers of this part of a voxel, so that the sum does not depend on
/// threads.
inline constexpr double kVolumeUnit = 1.0 / 65536.0;

struct ContactSample {
  std::uint32_t pass;
  double depth;  ///< mm, of a sample of the stock below the surface of the solid
  Vec3 where;
  std::int64_t volume;  ///< kVolumeUnit
};

/// Edges of a leaf, between two samples that are gone, that no pass is known to have covered whole: material
/// may have stood in between.
struct OpenEdges {
  std::array<LeafBits, 2> level{};  ///< along x and y, within the leaf
  LeafBits upright{};               ///< vertical, also those that end in the next leaf
  bool undercut = false;            ///< these must be looked at, too
};

/// Cuts leaves; one object a thread, used again and again.
class LeafCutter {
 public:
  LeafCutter(const Stock::Impl& impl, const PassTable& table)
      : impl_(impl),
        table_(table),
        reader_(impl),
        lower_(columnKernels().lower),
        cover_(columnKernels().cover) {}

  /// Takes those of `list` (what reaches into the leaf's stack, in program order) that count for the leaf's
  /// block of 9x9x9 samples through the samples of change.material.
  void cut(LeafChange& change, std::span<const StackReach> list);

  // What the last cut found.
  const std::vector<std::pair<MotionId, std::int64_t>>& removed() const { return removed_; }  ///< kVolumeUnit
  const std::vector<ContactSample>& contacts() const { return contacts_; }
  const std::vector<NearSample>& near() const { return near_; }
  std::uint64_t evaluations() const { return evaluations_; }
  /// Null where nothing is open.
  std::unique_ptr<OpenEdges> openEdges() const;
  /// Height above which no crossing of the leaf's vertical edges lies but those of older surface, mm;
  /// +infinity where that is not known.
  double highest() const;

 private:
  /// Columns in the order of LeafColumns, eight a word.
  using ColumnWords = std::array<std::uint64_t, 8>;
  void start(const LeafChange& change);
  bool onlyTook() const;
  void startTops(const LeafChange& change);
  std::size_t applyPieces(std::span<const StackReach> list);
  bool counts(const StackReach& reach) const;
  void apply(std::uint32_t number);
  double applyQuarter(std::uint32_t number, int quarter);
  void look(const Pass& pass, unsigned quarters);
  void cover(int quarter);
  void setQuarterTop(int quarter);
  bool holdsEdges(const Pass& pass) const;
  void join(unsigned quarters, bool level);
  void joinUpright(const ColumnWords& covered);
  void lookAround(std::uint32_t number);
  void contact(std::uint32_t number, int quarter, const double* top);
  double countMet(int column, double from, unsigned touched);

  const Stock::Impl& impl_;
  const PassTable& table_;
  LeafReader reader_;
  LowerKernel lower_;
  CoverKernel cover_;
  Coord origin_;
  double highest_ = 0.0;                   ///< highest top, mm
  unsigned open_ = 0;                      ///< quarters (bits) with a top above the lowest samples
  double end_ = 0.0;                       ///< height of the block's last samples, mm
  bool level_tops_ = true;                 ///< what took something reaches up beyond the block
  FourBlocks quarters_{};                  ///< up to the highest top of each quarter
  std::array<std::uint32_t, 2> takers_{};  ///< as in LeafChange
  double most_sunk_ = 0.0;                 ///< of one pass, mm of column height
  LeafColumns columns_{};
  unsigned covered_ = 0;  ///< quarters (bits) whose columns_.covered is that of the last pass
  static void pairUp(const ColumnWords& columns, ColumnWords& x, ColumnWords& y);
  ColumnWords initial_{};                             ///< material before the first pass
  ColumnWords joined_x_{}, joined_y_{}, joined_z_{};  ///< edges that one pass covered whole
  std::vector<std::pair<MotionId, std::int64_t>> removed_;
  ReachList lowest_first_;  ///< pieces of one volume
  std::vector<ContactSample> contacts_;
  std::vector<NearSample> near_;
  const Pass* met_ = nullptr;                 ///< the last that touched something
  std::array<double, 64> met_low_{};          ///< of each column: what its curve was counted down to, mm
  std::array<unsigned char, 64> met_bits_{};  ///< and the samples
  std::uint64_t evaluations_ = 0;
};

}  // namespace proveout
