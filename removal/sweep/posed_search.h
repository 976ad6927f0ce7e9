// The pose at which a solid of revolution is nearest to a point, or holds it deepest, while its axis turns:
// branch and bound on the stretches of a PosedTrack.
//
// In the tool's own frame the solid stands still and the point goes. Its signed distance is convex in the
// place of the point, so that the tangent plane at one pose bounds it from below at all others: by the
// point's first two derivatives there and a bound of the third. Where the solid is round more is known: the
// distance from an axis, from a centre or from a corner's circle bends up by what the point goes across.
// Poses are found by Newton's method; what their bounds leave open is divided.
#pragma once

#include <array>
#include <limits>

#include "core/tool/profile.h"
#include "removal/sweep/posed_track.h"

namespace proveout {

/// A pose and the signed distance of the solid there.
struct PosedPlace {
  std::size_t stretch = 0;
  double t = 0.0;                                          ///< on the stretch, -1 to 1
  double value = std::numeric_limits<double>::infinity();  ///< mm
};

class PosedSearch {
 public:
  struct Goal {
    double cutoff = std::numeric_limits<double>::infinity();  ///< what is above need not be found, mm
    double tolerance = 1e-9;                                  ///< of the least value, mm
    /// A value below this ends the search, mm.
    double enough = -std::numeric_limits<double>::infinity();
  };
  PosedSearch(const ConvexProfile& profile, const Vec3& p, const Goal& goal)
      : profile_(profile), p_(p), goal_(goal) {}

  /// Looks at a stretch from `start` on; all of it is settled then.
  void look(const PosedStretch& stretch, std::size_t number, double start);
  /// No value of the part on this stretch is lower; cheap.
  double roughBound(const PosedStretch& stretch) const;
  bool isOver() const { return best_.value < goal_.enough; }
  /// Below it nothing is looked for.
  double wanted() const { return std::min(goal_.cutoff, best_.value - goal_.tolerance); }

  const PosedPlace& best() const { return best_; }
  int evaluations() const { return evaluations_; }

 private:
  /// A lower bound of the value at t + w as seen from t, for |w| <= widest: value + slope w +
  /// k w^2 / 2 - third |w|^3 / 6, where both k and third have shares that fall with the radii of what is
  /// round.
  struct Bound {
    double k, third, widest;
    double speed;  ///< by which the radii may grow
    struct Round {
      double bend, third, radius;
    };
    std::array<Round, 2> round;
  };
  struct Pose {
    double t, value, slope, bend;
    std::array<Bound, 2> bounds;
    int count;  ///< of bounds
  };
  struct Piece {
    double low, high;
  };
  static constexpr int kMostNewton = 24, kMostPieces = 96, kMostPoses = 20000;

  Pose pose(double t);
  const std::array<double, 3>& centreBounds(double up);
  void addRound(const ProfileSample& s, double rho, double z, double rho_rate, double z_rate,
                const PosedStretch::Moving& m, Pose& to);
  double reach(const Pose& from, double direction, double most) const;
  double reachBy(const Pose& from, const Bound& bound, double slope, double most) const;
  void settle(double low, double high, double start);
  int newton(double low, double high, double start, std::array<Pose, kMostNewton>& seen);
  void push(double low, double high);
  void divide();

  const ConvexProfile& profile_;
  const Vec3 p_;
  Goal goal_;
  PosedPlace best_;
  int evaluations_ = 0;

  // Of the stretch that is looked at; bounds of how the point goes in the tool's frame, by t.
  const PosedStretch* stretch_ = nullptr;
  std::size_t number_ = 0;
  double speed_ = 0.0, bend_ = 0.0, third_ = 0.0;
  std::array<double, 3> centre_{};  ///< the same of a ball's centre; see centreBounds
  double centre_up_ = 0.0;          ///< of which height above the tip; infinite: of none yet
  std::array<Piece, kMostPieces> open_;
  int open_count_ = 0;
};

}  // namespace proveout
