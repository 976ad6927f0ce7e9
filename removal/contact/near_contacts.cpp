#include "removal/contact/near_contacts.h"

#include "removal/contact/contact_depth.h"

namespace proveout {
namespace {

/// The first step of a climb, grid steps: on a plane it leads to the point that lies deepest, as far as one
/// is likely to be in the surroundings of a sample.
constexpr double kFirstClimb = 8.0;
/// What follows a step that gains nothing, share of it; and the shortest one, grid steps.
constexpr double kStepShare = 0.25, kLastClimb = 1e-3;
constexpr int kMostClimbs = 80;
/// Places no farther from each other than this are one, mm.
constexpr double kSamePlaceMm = 1e-6;
/// Where a step no longer than this leads down, a ridge is between, grid steps. It goes on in the sum of what
/// both of its sides say, unless that has nearly no length.
constexpr double kOverRidge = 0.6, kAlongRidge = 0.1;
/// A climb that ends for want of gain, not on a summit, is at an edge of the stock, where its depth has a
/// kink. No summit is farther up than this, grid steps; nor is it worth more depths than these.
constexpr double kNearSummit = 0.1;
constexpr int kSummitDepths = 500;
/// Depths below this are none, mm: on walls that the tool's own cuts have left any of them says so.
constexpr double kShallow = 0.5 * kContactToleranceMm;

/// Climbs on the depth of the stock within what the part sweeps.
class Climb {
 public:
  Climb(const StockDepth& stock, const SweptField& sweep, MotionId before, double h)
      : stock_(stock), sweep_(sweep), before_(before), h_(h) {}

  void start(const Vec3& from) {
    const Vec3 p = nearest(from);
    settle(p, stock_.at(p, before_, hint_, kShallow));
  }
  /// False: there is no better place as far as `step` reaches, and `summit` says whether there is none at
  /// all.
  bool go(double step) {
    const Vec3 next = nearest(at_ + step * direction_.normalized());
    summit_ = straight_ && (next - at_).norm() < kSamePlaceMm;
    if (summit_) return false;
    const StockDepth::Sample there = stock_.at(next, before_, hint_, kShallow);
    if (there.value > depth_.value) {
      settle(next, there);
      return true;
    }
    if (step < kOverRidge * h_) followRidge(there.gradient);
    return false;
  }
  double depth() const { return depth_.value; }
  const Vec3& place() const { return at_; }
  bool summit() const { return summit_; }

 private:
  void followRidge(const Vec3& beyond) {
    const Vec3 both = direction_ + beyond;
    if (both.norm() < kAlongRidge * direction_.norm()) return;
    direction_ = both;
    straight_ = false;
  }
  void settle(const Vec3& p, const StockDepth::Sample& there) {
    at_ = p;
    depth_ = there;
    direction_ = there.gradient;
    straight_ = true;
  }
  Vec3 nearest(const Vec3& p) const {
    const SweepSample s = sweep_.sample(p);
    return s.value > 0.0 ? Vec3(p - s.value * s.gradient) : p;
  }

  const StockDepth& stock_;
  const SweptField& sweep_;
  MotionId before_;
  double h_;
  const SweptCutter* hint_ = nullptr;
  Vec3 at_ = Vec3::Zero();
  StockDepth::Sample depth_{};
  Vec3 direction_ = Vec3::Zero();  ///< of the next step; any length
  bool straight_ = true;           ///< it is that of the gradient
  bool summit_ = false;
};

}  // namespace

std::optional<ContactSample> NearContacts::at(const NearSample& near) const {
  const Pass& pass = table_.passes[near.pass];
  const MotionId before = metBefore(pass);
  const SweptField sweep = pass.body.field();
  Climb climb(stock_, sweep, before, h_);
  climb.start(near.where);
  double step = kFirstClimb * h_;
  for (int i = 0; i < kMostClimbs && step > kLastClimb * h_; ++i) {
    if (climb.depth() > kContactToleranceMm) return ContactSample{near.pass, climb.depth(), climb.place(), 0};
    if (climb.go(step)) continue;
    if (climb.summit()) return {};
    step *= kStepShare;
  }
  if (climb.depth() < -kNearSummit * h_) return {};
  int effort = kSummitDepths;
  const DeepPoint found =
      DeepestPoint(stock_, pass, before, h_).find({climb.place()}, kContactToleranceMm, effort);
  if (found.depth <= kContactToleranceMm) return {};
  return ContactSample{near.pass, found.depth, found.where, 0};
}

}  // namespace proveout
