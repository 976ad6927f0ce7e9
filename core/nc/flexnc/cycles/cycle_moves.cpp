#include "core/nc/flexnc/cycles/cycle_moves.h"

namespace proveout::nc {

namespace {

constexpr double kNoWay = 1e-9;  ///< mm

}  // namespace

void CycleMoves::lineTo(const Vec2& to, CycleMove::Kind kind, Role role) {
  if (!((to - at_).norm() > kNoWay)) return;
  CycleMove move;
  move.kind = kind;
  move.element = lineElement(at_, to);
  move.role = role;
  move.pass = in_pass_;
  moves_.push_back(move);
  at_ = to;
}

void CycleMoves::threadTo(const Vec2& to, double lead, double turn, Role role) {
  const std::size_t before = moves_.size();
  lineTo(to, CycleMove::Kind::kThread, role);
  if (moves_.size() == before) return;
  moves_.back().lead = lead;
  moves_.back().turn = turn;
}

void CycleMoves::along(const ContourElement& element) {
  if (!((element.to - element.from).norm() > kNoWay)) return;
  CycleMove move;
  move.element = element;
  const Vec2 shift = at_ - element.from;
  move.element.from += shift;
  move.element.to += shift;
  move.element.center += shift;
  move.role = Role::kContour;
  move.pass = in_pass_;
  moves_.push_back(move);
  at_ = move.element.to;
}

}  // namespace proveout::nc
