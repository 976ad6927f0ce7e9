// Bodies of upright tools on parts of curves that meet every column in one interval (column_curve.h): turns
// of helices about z, parts of arcs in upright planes, and parts of any other curve.
#pragma once

#include "removal/sweep/kinds/body_defaults.h"

namespace proveout {

struct TurnBody : KernelBody<TurnSweep> {
  using KernelBody::KernelBody;

  bool cutsTogether() const { return true; }
  void cutEdges(const BodyContext& of, EdgeCuts& cuts) const;
  double highestReach() const { return reachAbove(way.z + std::max(way.rise, 0.0)); }
  double coveredTop() const { return topAbove(way.z + std::min(way.rise, 0.0)); }
  double mostDepth(double x, double y) const;
  bool holdsEdges(double h, const Vec2& middle, double reach) const;
  EdgeCut levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const;
  double startAt(const BodyContext& of, const Vec3& p) const;
  /// Parameter of the whole curve at a place of this part, see CurveSide.
  double startOf(const BodyContext&, double place) const { return std::clamp(place / way.way_rad, 0.0, 1.0); }
  Vec3 directionAt(const Vec3& p) const;
};

struct UprightBody : KernelBody<UprightSweep> {
  using KernelBody::KernelBody;

  double highestReach() const { return reachAbove(way.z + std::max(way.rise, 0.0)); }
  double mostDepth(double x, double y) const;
  bool holdsEdges(double, const Vec2&, double) const { return true; }
  EdgeCut levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const;
  double startAt(const BodyContext& of, const Vec3& p) const;
  double startOf(const BodyContext& of, double place) const;
};

struct WayBody : KernelBody<WaySweep> {
  using KernelBody::KernelBody;

  double highestReach() const { return reachAbove(way.z + std::max(way.rise, 0.0)); }
  double mostDepth(double x, double y) const;
  bool holdsEdges(double, const Vec2&, double) const { return !way.twice; }
  EdgeCut levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const;
  double startAt(const BodyContext& of, const Vec3& p) const;
  double startOf(const BodyContext& of, double place) const;
};

}  // namespace proveout
