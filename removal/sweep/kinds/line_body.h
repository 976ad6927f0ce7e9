// Bodies of upright tools on straight ways: lines, and the chords of curves that have no parts of their own.
#pragma once

#include "removal/sweep/kinds/body_defaults.h"

namespace proveout {

/// A line, level, slanted or upright.
struct LineBody : KernelBody<LineSweep> {
  using KernelBody::KernelBody;

  unsigned hits(const LeafColumns& leaf, unsigned quarters, double highest) const {
    return solid().sphere || coversUpTo(highest) ? columnKernels().hits(way, leaf, quarters) : quarters;
  }
  double highestReach() const { return reachAbove(way.z + std::max(way.rise, 0.0)); }
  double coveredTop() const { return topAbove(way.z + std::min(way.rise, 0.0)); }
  bool coversUpTo(double height) const { return coveredTop() > height; }
  double mostDepth(double x, double y) const;
  bool isConvex() const { return true; }
  bool holdsEdges(double, const Vec2&, double) const { return true; }

  EdgeCut levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const;
  std::optional<SweptSurface> closedSurface(const BodyContext& of, const Vec3& p, int axis, bool below) const;
  std::optional<double> simpleBend(const ConvexProfile::Element& element) const;
  Vec3 directionAt(const Vec3& p) const;
  SweptField field(const BodyContext& of) const;

  std::optional<double> ownLength() const { return sweepWay(way).norm(); }
  ToolPlace placeAt(double t) const { return {sweepStart(way) + t * sweepWay(way), {way.ux, way.uy}}; }
};

/// A line that stands for a part of a curve. Its surface is that of the curve.
struct ChordBody : LineBody {
  using LineBody::LineBody;

  std::optional<SweptSurface> closedSurface(const BodyContext&, const Vec3&, int, bool) const {
    return std::nullopt;
  }
  double startAt(const BodyContext& of, const Vec3&) const {
    return of.whole->parameterAt(sweepStart(way) + 0.5 * sweepWay(way));
  }
  std::optional<double> simpleBend(const ConvexProfile::Element&) const { return std::nullopt; }
  Vec3 directionAt(const Vec3&) const { return Vec3::Zero(); }
  SweptField field(const BodyContext& of) const { return *of.whole; }
  /// Flat and ball ends have closed forms on chords, which are faster.
  bool isAskedWhole(const BodyContext& of) const {
    return !solid().flat && !solid().ball && of.whole->replacesChords();
  }
};

}  // namespace proveout
