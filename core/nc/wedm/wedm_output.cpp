#include "core/nc/wedm/wedm_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

namespace {

constexpr double kStanding = 1e-9;   ///< mm
constexpr double kSlowLength = 3.0;  ///< mm, of G34
constexpr int kSamples = 32;         ///< of leans and travels on the way

double wayOf(const ContourElement& e) {
  return e.arc ? (e.from - e.center).norm() * std::abs(e.sweep) : (e.to - e.from).norm();
}

WireTrack trackOf(const ContourElement& e) {
  WireTrack track;
  track.from = e.from;
  track.to = e.to;
  if (e.arc && wayOf(e) > kStanding) {
    track.center = e.center;
    track.sweep_rad = e.sweep;
  }
  return track;
}

/// An axis of the machine that may leave its travel.
struct Travelled {
  const char* axis;
  double low, high;  ///< limits, mm
  double worst = 0.0, over = 0.0;

  void look(double value) {
    const double beyond = std::max(low - value, value - high);
    if (beyond > over) {
      over = beyond;
      worst = value;
    }
  }
};

}  // namespace

double WedmOutput::tilt(const ContourElement& main, const ContourElement& second) const {
  double lean = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    const double f = static_cast<double>(k) / kSamples;
    lean = std::max(lean, (pointOn(second, f) - pointOn(main, f)).norm());
  }
  return std::atan(lean / std::abs(parameters_.rise()));
}

void WedmOutput::checkTravel(const ContourElement& main, const ContourElement& second,
                             const SourceRef& source) {
  const auto limitOf = [&](std::size_t axis) {
    return settings_.limits[axis].value_or(AxisLimit{-INFINITY, INFINITY});
  };
  const auto travelOf = [](double travel) { return travel > 0.0 ? travel : INFINITY; };
  const double u = travelOf(parameters_.u_travel), v = travelOf(parameters_.v_travel);
  std::array<Travelled, 4> axes{{{"X", limitOf(0).min, limitOf(0).max},
                                 {"Y", limitOf(1).min, limitOf(1).max},
                                 {"U", -u, u},
                                 {"V", -v, v}}};
  const Vec2 origin = settings_.work_offsets[0].head<2>();
  for (int k = 0; k <= kSamples; ++k) {
    const double f = static_cast<double>(k) / kSamples;
    const Vec2 m = pointOn(main, f), slope = (pointOn(second, f) - m) / parameters_.rise();
    const Vec2 guide = m + (parameters_.z_lower - parameters_.z_main) * slope + origin;
    const Vec2 uv = parameters_.guides() * slope;
    axes[0].look(guide.x());
    axes[1].look(guide.y());
    axes[2].look(uv.x());
    axes[3].look(uv.y());
  }
  for (const Travelled& axis : axes) {
    if (axis.over <= kStanding) continue;
    event(event::Overtravel{axis.axis, axis.worst, axis.worst > axis.high ? axis.high : axis.low, {}}, 0.0,
          source);
  }
}

double WedmOutput::rapidTime(const ContourElement& main, const ContourElement& second) const {
  const Vec2 way = (main.to - main.from).cwiseAbs().cwiseMax((second.to - second.from).cwiseAbs());
  return 60.0 * std::max(way.x() / settings_.rapid_mm_min.x(), way.y() / settings_.rapid_mm_min.y());
}

void WedmOutput::move(const ContourElement& main, const ContourElement& second, const WedmPace& pace) {
  const double way_main = wayOf(main), way_second = wayOf(second);
  if (std::max(way_main, way_second) < kStanding) return;
  checkTravel(main, second, pace.source);
  WireSweep sweep;
  const bool up = parameters_.rise() > 0.0;
  sweep.z_low = std::min(parameters_.z_main, parameters_.z_second);
  sweep.z_high = std::max(parameters_.z_main, parameters_.z_second);
  sweep.lower = trackOf(up ? main : second);
  sweep.upper = trackOf(up ? second : main);
  sweep.state = pace.wire;
  Motion motion;
  motion.from = Vec3(sweep.lower.from.x(), sweep.lower.from.y(), sweep.z_low);
  motion.to = Vec3(sweep.lower.to.x(), sweep.lower.to.y(), sweep.z_low);
  motion.source = pace.source;
  motion.compensated = pace.compensated;
  if (pace.rapid) {
    motion.time_s = rapidTime(main, second);
    summary_.rapid_s += motion.time_s;
  } else {
    motion.kind = MotionKind::kFeed;
    motion.feed = parameters_.feedOf(pace.condition);
    // The speed is that of the main plane; where its point stands, that of the other one.
    const double way = way_main > kStanding ? way_main : way_second;
    const double slow = pace.slow_end ? std::min(way, kSlowLength) : 0.0;
    motion.time_s = 60.0 * (way - slow + slow / parameters_.slow_share) / motion.feed;
    summary_.cutting_s += motion.time_s;
  }
  summary_.cycle_s += motion.time_s;
  ++summary_.motions;
  sink_.wireMotion(motion, sweep);
}

void WedmOutput::event(EventKind what, double time_s, const SourceRef& source) {
  summary_.cycle_s += time_s;
  PathEvent event;
  event.what = std::move(what);
  event.time_s = time_s;
  event.source = source;
  sink_.event(event);
}

}  // namespace proveout::nc
