#include "core/nc/services/circular_pocket.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

constexpr double kSameCircleMm = 1e-9;

class CircleWriter {
 public:
  CircleWriter(double turn, std::vector<PocketMove>& moves) : turn_(turn), moves_(moves) {}

  /// On a half circle to the abscissa `u` on the first axis.
  void halfTo(double u) {
    const Vec2 to(u, 0.0);
    moves_.push_back({PocketMove::Kind::kArc, to, 0.5 * (at_ + to), turn_ * kPi});
    at_ = to;
  }
  void round() { moves_.push_back({PocketMove::Kind::kArc, at_, Vec2::Zero(), turn_ * 2.0 * kPi}); }
  double side() const { return at_.x() < 0.0 ? -1.0 : 1.0; }

 private:
  double turn_;
  std::vector<PocketMove>& moves_;
  Vec2 at_ = Vec2::Zero();
};

}  // namespace

CircularPocketError circularPocket(const CircularPocket& p, std::vector<PocketMove>& moves) {
  moves.clear();
  for (const double x : {p.first, p.last, p.step, p.tool_radius}) {
    if (!std::isfinite(x)) return CircularPocketError::kNotFinite;
  }
  if (!(p.tool_radius >= 0.0) || p.first <= p.tool_radius) return CircularPocketError::kTooSmall;
  const bool several = p.last != 0.0;
  if (several && p.last < p.first) return CircularPocketError::kBackwards;
  if (several && !(p.step > 0.0)) return CircularPocketError::kNoStep;
  if (several && (p.last - p.first) / p.step > kMaxPocketCircles) return CircularPocketError::kTooMany;
  CircleWriter writer(p.counter_clockwise ? 1.0 : -1.0, moves);
  writer.halfTo(p.first - p.tool_radius);
  writer.round();
  const double last = several ? p.last : p.first;
  for (int k = 1; several && p.first + (k - 1) * p.step < last - kSameCircleMm; ++k) {
    writer.halfTo(-writer.side() * (std::min(p.first + k * p.step, last) - p.tool_radius));
    writer.round();
  }
  writer.halfTo(0.0);
  return CircularPocketError::kNone;
}

}  // namespace proveout
