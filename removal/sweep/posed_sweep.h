// What one convex part of a tool sweeps while its axis turns. Signs are those of Sweep; the zero set is
// exact, as poses are never sampled. Error below kSweepToleranceMm.
#pragma once

#include <memory>

#include "removal/sweep/posed_search.h"
#include "removal/sweep/sweep.h"

namespace proveout {

class PosedSweep {
 public:
  /// `profile` must outlive the sweep.
  PosedSweep(const ConvexProfile& profile, const MotionWay& way);
  /// What another part of the tool sweeps on the way of `beside`.
  PosedSweep(const ConvexProfile& profile, const PosedSweep& beside)
      : profile_(&profile), track_(beside.track_) {}

  // As those of Sweep; all in the workpiece frame.

  double distance(const Vec3& p, double cutoff, double tolerance = kLineToleranceMm) const;
  SweepSample sample(const Vec3& p) const;
  SweepSample sampleOnSurface(const Vec3& p, double start) const;
  SweepSample sampleOutside(const Vec3& p, double tolerance, double& start) const;
  bool holds(const Vec3& a, const Vec3& b) const;
  /// Of the pose whose tip is nearest, about.
  double parameterAt(const Vec3& at) const;
  bool isSlow() const { return true; }
  bool replacesChords() const { return false; }
  Box3 bounds() const;

  // For its pieces.

  const ConvexProfile& profile() const { return *profile_; }
  const std::vector<PosedStretch>& stretches() const { return track_->stretches(); }
  /// The pose on stretches `first` to `last` - 1 that is nearest to `p` or holds it deepest. `start`: a
  /// pose to set out from, where its stretch is one of these.
  PosedPlace nearest(const Vec3& p, const PosedSearch::Goal& goal, std::size_t first, std::size_t last,
                     const PosedPlace* start = nullptr) const;
  /// Signed distance at one pose, with its gradient.
  ProfileSample profileAt(const Vec3& p, const PosedPlace& place) const;

 private:
  struct At {
    double value, slope;  ///< slope: by t
    int element;
    Vec3 gradient;
    double axial;  ///< of the gradient, along the tool's axis
  };
  At at(const Vec3& p, std::size_t stretch, double t) const;
  SweepSample withRim(const Vec3& p, const PosedPlace& place) const;
  PosedPlace placeAt(double share) const;
  double shareAt(const PosedPlace& place) const;

  const ConvexProfile* profile_;
  std::shared_ptr<const PosedTrack> track_;
};

/// Bounds of a part on a stretch of its way, mm.
Box3 stretchBounds(const ConvexProfile& profile, const PosedStretch& stretch);
/// The same between two places of it, `from` < `to`; tight where they are near to each other.
Box3 boundsBetween(const ConvexProfile& profile, const PosedStretch& stretch, double from, double to);

}  // namespace proveout
