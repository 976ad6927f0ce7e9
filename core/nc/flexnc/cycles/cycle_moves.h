// Moves of a cycle, one behind the other.
#pragma once

#include <utility>
#include <vector>

#include "core/nc/flexnc/cycles/cycle_call.h"

namespace proveout::nc {

/// Points are (z, r), mm. A move without a way is left out.
class CycleMoves {
 public:
  using Role = CycleMove::Role;

  explicit CycleMoves(const Vec2& at) : at_(at) {}

  const Vec2& at() const { return at_; }
  int pass() const { return pass_; }
  /// What follows belongs to the next pass.
  void beginPass() { in_pass_ = ++pass_; }
  /// What follows belongs to none.
  void endPass() { in_pass_ = 0; }

  void rapidTo(const Vec2& to, Role role) { lineTo(to, CycleMove::Kind::kRapid, role); }
  void feedTo(const Vec2& to, Role role) { lineTo(to, CycleMove::Kind::kFeed, role); }
  /// Along one axis; the other stays.
  void rapidToZ(double z, Role role) { rapidTo(Vec2(z, at_.y()), role); }
  void rapidToR(double r, Role role) { rapidTo(Vec2(at_.x(), r), role); }
  void feedToZ(double z, Role role) { feedTo(Vec2(z, at_.y()), role); }
  void feedToR(double r, Role role) { feedTo(Vec2(at_.x(), r), role); }
  /// `lead`: mm a turn; `turn`: where the spindle stands at the start, 0 to 1.
  void threadTo(const Vec2& to, double lead, double turn, Role role);
  /// At feed along an element of the contour, as its vectors say: it begins where the tool is.
  void along(const ContourElement& element);

  std::vector<CycleMove> take() { return std::move(moves_); }

 private:
  void lineTo(const Vec2& to, CycleMove::Kind kind, Role role);

  Vec2 at_;
  int pass_ = 0, in_pass_ = 0;
  std::vector<CycleMove> moves_;
};

}  // namespace proveout::nc
