// Bodies of upright tools on level arcs.
#pragma once

#include "removal/sweep/kinds/body_defaults.h"

namespace proveout {

struct LevelArcBody : KernelBody<ArcSweep> {
  using KernelBody::KernelBody;

  double highestReach() const { return reachAbove(way.z); }
  double coveredTop() const { return topAbove(way.z); }
  bool coversUpTo(double height) const { return coveredTop() > height; }
  double mostDepth(double x, double y) const;
  bool holdsEdges(double h, const Vec2&, double) const {
    return !(way.wide || way.full) || turnsWithoutPillar(solid(), way.arc_radius, h);
  }

  double startAt(const BodyContext& of, const Vec3&) const {
    return of.whole->parameterAt({way.x, way.y, way.z});
  }
  std::optional<double> simpleBend(const ConvexProfile::Element& element) const;
  Vec3 directionAt(const Vec3& p) const { return directionAround(way.x, way.y, way.turn, p); }

  std::optional<double> ownLength() const { return turnRad() * way.arc_radius; }
  ToolPlace placeAt(double t) const;

 private:
  double turnRad() const;
};

}  // namespace proveout
