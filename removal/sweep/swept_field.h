// The volume that one convex part of a tool sweeps on a whole motion, as a signed distance field: what is
// asked of it whatever the part's way is.
//
// Sign and accuracy are those of Sweep (sweep.h). What another kind of motion sweeps is another alternative
// here; nothing outside of this folder asks which it is.
#pragma once

#include <utility>
#include <variant>

#include "removal/sweep/leaning_sweep.h"
#include "removal/sweep/posed_sweep.h"
#include "removal/sweep/sweep.h"

namespace proveout {

class SweptField {
 public:
  /// Start of a search that may set out anywhere.
  static constexpr double kAnywhere = Sweep::kAnywhere;

  /// A part whose axis stays upright, on a line or, with `arc`, on a curve. `profile` must outlive the field.
  SweptField(const ConvexProfile& profile, const Vec3& from, const Vec3& to, const ArcGeometry* arc)
      : way_(std::in_place_type<Sweep>, profile, from, to, arc) {}
  /// The same of a part whose axis leans but stands still, as that of `frame`. Points of the way and all
  /// that is asked and answered are of the workpiece frame.
  SweptField(const ConvexProfile& profile, const ToolFrame& frame, const Vec3& from, const Vec3& to,
             const ArcGeometry* arc)
      : way_(std::in_place_type<LeaningSweep>, profile, frame, from, to, arc) {}
  /// A part whose axis turns; see MotionWay::turns.
  SweptField(const ConvexProfile& profile, const MotionWay& way)
      : way_(std::in_place_type<PosedSweep>, profile, way) {}
  explicit SweptField(PosedSweep way) : way_(std::move(way)) {}

  /// Distance at `p`, mm, on lines to within `tolerance`, mm. Values above `cutoff` may be returned as any
  /// lower bound above `cutoff`.
  double distance(const Vec3& p, double cutoff, double tolerance = kLineToleranceMm) const {
    return std::visit([&](const auto& way) { return way.distance(p, cutoff, tolerance); }, way_);
  }
  SweepSample sample(const Vec3& p) const {
    return std::visit([&](const auto& way) { return way.sample(p); }, way_);
  }
  /// The same of a point on the surface, where the part touches it at about the parameter `start` of its
  /// motion.
  SweepSample sampleOnSurface(const Vec3& p, double start) const {
    return std::visit([&](const auto& way) { return way.sampleOnSurface(p, start); }, way_);
  }
  /// The same of a point outside, to within `tolerance` > 0, mm; cheaper. An element from
  /// ConvexProfile::kEdgeIds on: an end of that straight element is nearest, not its face. `start`: where on
  /// the motion (0 to 1) a search sets out, or kAnywhere; becomes a good start for points nearby.
  SweepSample sampleOutside(const Vec3& p, double tolerance, double& start) const {
    return std::visit([&](const auto& way) { return way.sampleOutside(p, tolerance, start); }, way_);
  }
  /// Whether the part holds both points, and so all between them, at one place of its way; false also where
  /// no place is found.
  bool holds(const Vec3& a, const Vec3& b) const {
    return std::visit([&](const auto& way) { return way.holds(a, b); }, way_);
  }
  /// Parameter of the place of a curve that lies at the angle of `at` about its axis.
  double parameterAt(const Vec3& at) const {
    return std::visit([&](const auto& way) { return way.parameterAt(at); }, way_);
  }
  /// A distance takes a search, and so many times as long as on a line.
  bool isSlow() const {
    return std::visit([](const auto& way) { return way.isSlow(); }, way_);
  }
  /// It takes no longer than the distances of the chords that stand for the way.
  bool replacesChords() const {
    return std::visit([](const auto& way) { return way.replacesChords(); }, way_);
  }
  /// Bounds of the swept volume, mm.
  Box3 bounds() const {
    return std::visit([](const auto& way) { return way.bounds(); }, way_);
  }
  /// For who made it as such; else null.
  const PosedSweep* posed() const { return std::get_if<PosedSweep>(&way_); }

 private:
  std::variant<Sweep, LeaningSweep, PosedSweep> way_;
};

}  // namespace proveout
