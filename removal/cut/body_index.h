// Finds the swept cutters near a point: a tree of boxes over them.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "removal/cut/pass.h"

namespace proveout {

/// A cutting part of a tool on the whole of one motion: the chords of a curve are one body.
struct SweptCutter {
  MotionId motion = kNoMotion;
  std::uint32_t pass = 0;  ///< its first one

  SweptField field(const PassTable& table) const;
  /// As SweptField::distance; copies no curve.
  double distance(const PassTable& table, const Vec3& p, double cutoff) const;
};

class CutterIndex {
 public:
  /// Cutters of motions below `end`. `table` must outlive the index.
  CutterIndex(const PassTable& table, MotionId end);

  /// The nearest cutter of a motion below `end` and its signed distance from `p`, mm; of those that hold `p`
  /// any. None, and `cutoff`, where none is nearer.
  struct Near {
    double distance;
    const SweptCutter* body = nullptr;  ///< null: none
  };
  /// `hint`: looked at first, null: none is; for many points near each other the one that was found last.
  /// `enough`, 0 or above: any that is nearer will do.
  Near nearest(const Vec3& p, MotionId end, double cutoff, const SweptCutter* hint = nullptr,
               double enough = 0.0) const;
  /// Whether a cutter other than that of pass `except` is nearer to `p` than `within`, mm; below 0: holds it
  /// deeper than that.
  bool comesTo(const Vec3& p, double within, std::uint32_t except = kNoPass) const;
  /// Adds the fields of all cutters nearer to `p` than `within`, mm.
  void collect(const Vec3& p, double within, std::vector<SweptField>& out) const;
  static constexpr std::uint32_t kNoPass = ~0u;

 private:
  /// Whether visit(cutter) is true for any in a box that reaches(box) is true for; goes no further then.
  template <typename Reaches, typename Visit>
  bool anyOf(const Reaches& reaches, const Visit& visit) const;

  /// Holds the bounds of a body; half of the memory of a Box3.
  struct SmallBox {
    std::array<float, 3> min, max;
    explicit SmallBox(const Box3& box);
    Box3 box() const;
  };
  struct Node {
    Box3 box;
    MotionId first_motion = kNoMotion;  ///< the lowest below it
    std::uint32_t begin = 0, end = 0;   ///< of a leaf: its bodies
    std::uint32_t right = 0;            ///< the other child; the left one follows. 0: a leaf
  };
  /// What the tree is made in: bounds of the bodies, and copies in a new order.
  struct Room {
    std::vector<Box3> boxes, sorted;
    std::vector<std::uint32_t> order;
    std::vector<SweptCutter> sorted_bodies;
  };
  void buildAll();
  void build(Room& room, std::uint32_t number, std::uint32_t begin, std::uint32_t end);
  void halve(Room& room, int axis, std::uint32_t begin, std::uint32_t end);

  const PassTable& table_;
  std::vector<SweptCutter> bodies_;
  std::vector<SmallBox> boxes_;  ///< of the bodies
  std::vector<Node> nodes_;
};

}  // namespace proveout
