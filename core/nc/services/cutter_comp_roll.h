// The cutter as a disk that rolls along the programmed elements: which of them it touches, and how far it
// stays off those that it cannot reach. Internal to cutter compensation.
//
// Offsets of single elements say little where a contour consists of short, rounded ones: their directions
// jitter, and the corners between their offsets lie before or behind each other by more than an element is
// long. The disk knows no directions. It leaves out what it cannot reach, and how much that is tells rounding
// from interference.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/nc/services/cutter_comp_corner.h"

namespace proveout::comp_detail {

/// A place of the disk: on element `index`, or on that element's start point only (`pivot`), about which it
/// turns until it touches something else.
struct RollPlace {
  Vec2 center = Vec2::Zero();
  std::size_t index = 0;
  bool pivot = false;
};

/// The elements [first, last] of `elements` are plain and have the offset `rho`; of the element before
/// `first` only the end counts.
class Roll {
 public:
  Roll(const std::deque<Element>& elements, std::size_t last, double rho)
      : elements_(elements), last_(last), rho_(rho) {}

  /// Where the disk is stopped next: by an element ahead, or at the end of its own one, where it begins to
  /// turn about the end point. Index last + 1 with `pivot`: it stands on the end of the last element.
  RollPlace next(const RollPlace& at) const;

  /// How far the farthest point that was passed over between two stops lies outside the disk, mm; a disk
  /// pushed in until it touches that point would cut in by about as much.
  double unreached(const RollPlace& from, const RollPlace& to) const;

  /// How deep a disk about `center` cuts into the elements from `first` on, mm, 0 or more.
  double depth(const Vec2& center, std::size_t first) const;

  /// The points of the way between two stops but the first, as chords.
  void way(const RollPlace& from, const RollPlace& to, std::vector<Vec2>& points) const;

  std::size_t last() const { return last_; }

 private:
  struct Mover;
  Mover mover(const RollPlace& at) const;
  RollPlace touching(const RollPlace& at) const;
  void consider(const Mover& mover, std::size_t index, double& least, RollPlace& found) const;
  Vec2 nearest(const Element& element, const Vec2& p) const;
  bool solid(const Element& element) const;

  const std::deque<Element>& elements_;
  std::size_t last_;
  double rho_;
};

}  // namespace proveout::comp_detail
