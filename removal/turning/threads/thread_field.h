// The spaces that thread tools sweep through: outlines on helices about Z.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "removal/turning/section/section.h"
#include "removal/turning/threads/thread_outline.h"

namespace proveout {

/// A point by its cylinder coordinates, mm and radians.
struct PolarPoint {
  double r, phi, z;

  static PolarPoint of(const Vec3& p);
  Vec2 inPlane() const { return {r, z}; }
};

/// `angle` less whole turns, in [-pi, pi].
double wrapAngle(double angle);

/// A sweep made ready. The tool is infinitely thin: at an angle it stands where it passes the half-plane
/// there.
class HelixSweep {
 public:
  HelixSweep(const ThreadSweep& sweep, const ThreadOutline& outline, int number);

  const ThreadOutline& outline() const { return *outline_; }
  MotionId motion() const { return motion_; }
  int number() const { return number_; }
  Vec2 min() const { return min_; }  ///< of all (r, z) that the outline reaches
  Vec2 max() const { return max_; }

  /// The control point when the part `t` of the turns is done; before 0 and after 1 it goes on straight.
  Vec2 at(double t) const { return from_ + wayAt(t) * way_; }
  /// How the control point moves with the angle there, mm / rad.
  Vec2 slopeAt(double t) const;
  double turn() const { return turn_; }          ///< angle of the whole way, signed, rad
  double steepest() const { return steepest_; }  ///< the largest norm of slopeAt

  /// Parts t of the turns in [first, last] where the tool may be between heights and radii. False: nowhere.
  struct Window {
    double first, last;
  };
  bool window(const Vec2& low, const Vec2& high, Window& window) const;
  /// Calls body(t) for every time that the tool passes the angle within the window.
  template <typename Body>
  void forEachPass(double phi, const Window& window, Body&& body) const;

  /// The distance in the half-plane to the outline at `t`, or the one to the half-plane in which the tool
  /// starts or ends (if larger): below 0 in the swept space.
  struct Side {
    double value;
    Vec3 normal;  ///< unit, out of the swept space
    int face;     ///< of the outline; kEndFace
  };
  static constexpr int kEndFace = 31;
  /// Tells a face of this turn from the same one of the turns beside: 0 or 1.
  int parityAt(double t) const { return static_cast<int>(std::floor(t * turn_ / (2.0 * kPi))) & 1; }
  double valueAt(const PolarPoint& p, double t) const;
  /// The helical surface of a face of the outline near a point: its signed distance in the half-plane and
  /// that value's gradient (longer than 1 where the surface leans).
  struct Lean {
    double value;
    Vec3 gradient;
  };
  Lean leanAt(int face, const PolarPoint& p, double t) const;
  Side sideAt(const PolarPoint& p, double t) const;
  /// The gradient of a value from its gradient in the half-plane.
  Vec3 turned(const Vec2& normal, const PolarPoint& p, double t) const;
  /// No more than the distance in the half-plane of a point (r, z) to the outline at `t`; below 0 inside of
  /// its box.
  double boxDistance(const Vec2& p, double t) const;
  /// How many times a value may be the distance at a radius.
  double stretch(double r) const;
  /// Never more than the distance of `p` from the swept space's surface; the same sign as valueAt.
  double boundAt(const PolarPoint& p, double t) const;

 private:
  double wayAt(double t) const;
  double partAt(double way) const;
  double endValue(double r, double t) const;

  const ThreadOutline* outline_;
  Vec2 from_, way_;
  double start_, turn_, bend_;
  MotionId motion_;
  int number_;
  Vec2 min_, max_;
  double steepest_;
};

template <typename Body>
void HelixSweep::forEachPass(double phi, const Window& window, Body&& body) const {
  const double turns = turn_ / (2.0 * kPi), offset = (phi - start_) / (2.0 * kPi);
  double low = window.first * turns, high = window.last * turns;
  if (low > high) std::swap(low, high);
  for (double k = std::ceil(low - offset); k + offset <= high; k += 1.0) body((offset + k) / turns);
}

/// All sweeps, by height.
class ThreadField {
 public:
  ThreadField(const std::vector<ThreadSweep>& threads, const Vec2& low, const Vec2& high);

  bool empty() const { return sweeps_.empty(); }
  const std::vector<HelixSweep>& sweeps() const { return sweeps_; }
  /// The sweeps that reach between these (r, z).
  template <typename Body>
  void forEachNear(const Vec2& low, const Vec2& high, Body&& body) const;

  /// A lower bound of the distance to the swept spaces' surface, negative inside, and the sweep that it is
  /// of. `most` and null where that is farther.
  struct Bound {
    double value;
    const HelixSweep* sweep;
    double t;
  };
  Bound bound(const PolarPoint& p, double most) const;

 private:
  std::size_t binOf(double z) const;

  std::vector<std::unique_ptr<ThreadOutline>> outlines_;
  std::vector<std::shared_ptr<const ConvexOutline>> mirrors_;
  std::vector<HelixSweep> sweeps_;
  std::vector<std::vector<std::uint32_t>> bins_;  ///< sweeps by the heights that they reach over
  double low_ = 0.0, bin_height_ = 1.0;
};

template <typename Body>
void ThreadField::forEachNear(const Vec2& low, const Vec2& high, Body&& body) const {
  if (sweeps_.empty()) return;
  const std::size_t first = binOf(low.y()), last = binOf(high.y());
  for (std::size_t bin = first; bin <= last; ++bin) {
    for (const std::uint32_t i : bins_[bin]) {
      const HelixSweep& s = sweeps_[i];
      if (bin > first && bin > binOf(s.min().y())) continue;  // seen in an earlier bin
      if ((s.min().array() <= high.array()).all() && (s.max().array() >= low.array()).all()) body(s);
    }
  }
}

}  // namespace proveout
