// What a tool sweeps whose axis leans but stands still: the Sweep of the tool's own frame, seen from the
// workpiece. Signs and accuracy are those of Sweep.
#pragma once

#include "removal/sweep/sweep.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {

/// Bounds of a solid with this axis, its tip at the origin, mm, workpiece frame; exact.
Box3 leaningBounds(const ConvexProfile& profile, const ToolFrame& frame);

/// No point of the solid is farther from its tip, mm, whatever its axis.
double farthestFromTip(const ConvexProfile& profile);

class LeaningSweep {
 public:
  /// `from`, `to` and `arc` (null for lines): of the tip, workpiece frame. `profile` must outlive the sweep.
  LeaningSweep(const ConvexProfile& profile, const ToolFrame& frame, const Vec3& from, const Vec3& to,
               const ArcGeometry* arc);

  // As those of Sweep; points and gradients in the workpiece frame.

  double distance(const Vec3& p, double cutoff, double tolerance = kLineToleranceMm) const {
    return inner_.distance(frame_.toTool(p), cutoff, tolerance);
  }
  SweepSample sample(const Vec3& p) const { return seen(inner_.sample(frame_.toTool(p))); }
  SweepSample sampleOnSurface(const Vec3& p, double start) const {
    return seen(inner_.sampleOnSurface(frame_.toTool(p), start));
  }
  SweepSample sampleOutside(const Vec3& p, double tolerance, double& start) const {
    return seen(inner_.sampleOutside(frame_.toTool(p), tolerance, start));
  }
  bool holds(const Vec3& a, const Vec3& b) const { return inner_.holds(frame_.toTool(a), frame_.toTool(b)); }
  double parameterAt(const Vec3& at) const { return inner_.parameterAt(frame_.toTool(at)); }
  bool isSlow() const { return inner_.isSlow(); }
  bool replacesChords() const { return inner_.replacesChords(); }
  /// Tight on lines and arcs.
  Box3 bounds() const;

 private:
  SweepSample seen(SweepSample sample) const {
    sample.gradient = frame_.toPart(sample.gradient);
    return sample;
  }

  ToolFrame frame_;
  Sweep inner_;
  const ConvexProfile* profile_;
  Box3 way_;  ///< of the tip; most fields are never asked for their bounds, which take longer than a distance
};

}  // namespace proveout
