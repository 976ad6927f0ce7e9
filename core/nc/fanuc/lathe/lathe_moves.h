// The moves of the cycles of lathes: points of the plane (z, x), work coordinates, X a radius, mm.
#pragma once

#include <optional>

#include "core/nc/iso/context/context.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

/// Sends one move after the other while a block is carried out. Every call: false, an error was reported.
class LatheMoves {
 public:
  /// `plan`: its feed and its nose compensation are taken where `compensated`; must outlive this.
  LatheMoves(IsoContext& c, BlockPlan& plan, bool compensated = false);

  const Vec2& at() const { return at_; }
  bool rapid(const Vec2& to);
  bool feed(const Vec2& to) { return feed(lineElement(at_, to)); }
  /// A line or an arc that begins at at().
  bool feed(const ContourElement& e, const SourceRef* source = nullptr);
  /// Along a thread whose lead (mm a turn) counts along the axis with the longer way; turns of the spindle go
  /// on from the thread before. `change`: of the lead a turn, mm.
  bool thread(const Vec2& to, double lead, double change = 0.0);
  /// The spindle stands so where the next thread begins, degrees.
  void startThread(double angle_deg) { angle_deg_ = angle_deg; }
  /// The block ends where the last move has ended: the programmed position follows.
  void finish();
  /// Point of the plane of a programmed one.
  Vec2 pointOf(const AxisPoint& programmed) const;

 private:
  bool send(PathItem& item, const Vec2& to);
  bool takeFeed(const Vec2& to, FeedStyle& feed);

  IsoContext& c_;
  BlockPlan& plan_;
  bool compensated_;
  AxisPoint work_;  ///< where the tool is
  Vec2 at_;
  double angle_deg_ = 0.0;
};

/// Turns of the spindle in which a thread of this lead goes `way` mm; the lead grows by `change` a turn.
/// None: it falls to zero before.
std::optional<double> threadTurnsOf(double way, double lead, double change);

}  // namespace proveout::nc
