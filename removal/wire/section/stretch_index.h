// Which stretch of a wire is nearest to a point.
#pragma once

#include <vector>

#include "core/geometry/box_tree.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {

class StretchIndex {
 public:
  /// The stretches must outlive it.
  explicit StretchIndex(const std::vector<WireStretch>& stretches);

  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  struct Found {
    std::uint32_t stretch = kNone;  ///< of those equally near, the first
    StretchPart part = StretchPart::kMiddle;
    double off_mm = 0.0;  ///< from the edge of its kerf, below 0 inside
  };
  /// Among stretches before `end` whose kerf comes to within `reach` mm of p.
  Found nearest(const Vec2& p, double reach, std::uint32_t end = kNone) const;

  /// The numbers of stretches before `end` whose kerf may meet a box, in order.
  std::vector<std::uint32_t> near(const Box3& box, std::uint32_t end) const;

 private:
  const std::vector<WireStretch>& stretches_;
  std::vector<std::uint32_t> owner_;  ///< of the boxes: long arcs have several
  BoxTree tree_;                      ///< boxes of the kerf
};

}  // namespace proveout
