#include "core/nc/stages/time_stage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

constexpr double kAnySpeed = std::numeric_limits<double>::infinity();

double planeTurnDeg(const Vec3& from, const Vec3& to, const Vec3& normal) {
  return radToDeg(std::atan2(normal.dot(from.cross(to)), from.dot(to)));
}

/// Nothing of the motion's ends leaves the plane.
bool inPlane(const Vec3& direction, const Vec3& normal) {
  return std::abs(direction.dot(normal)) < 1e-9 * direction.norm();
}

}  // namespace

void TimeStage::configure(const MotionLimits& limits, int axes) {
  flush();
  limits_ = limits;
  bell_ = BellProfile(std::max(limits.bell_time_s, 1e-9));
  axes_ = axes;
}

void TimeStage::count(const Motion& motion) {
  summary_.cycle_s += motion.time_s;
  (motion.kind == MotionKind::kRapid ? summary_.rapid_s : summary_.cutting_s) += motion.time_s;
}

void TimeStage::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis, MotionPace pace,
                       const MotionJoin& join) {
  if (moving_) pace.corner_curve = cornerCurve(last_, pace);
  const double entry = entrySpeed(pace, join);
  if (insideCorner(pace, join)) {
    slowBefore();
    slow_left_ = slowdown_.after;
  }
  Waiting& w = waiting_.emplace_back();
  w.motion = motion;
  w.least_s = motion.time_s;
  least_s_ += motion.time_s;
  w.has_arc = arc != nullptr;
  w.has_axis = axis != nullptr;
  if (arc) w.arc = *arc;
  if (axis) w.axis = *axis;
  addStretches(pace, join, entry);
  last_ = pace;
  last_join_ = join;
  moving_ = true;
  if (waiting_.size() >= 2 * kWindow) emit(kWindow);
}

double TimeStage::entrySpeed(const MotionPace& pace, const MotionJoin& join) const {
  if (!moving_ || last_join_.stops) return 0.0;
  if (pace.rapid != last_.rapid) return 0.0;
  if (join.unbroken || last_join_.unbroken) return kAnySpeed;
  return cornerSpeed(limits_, last_, pace, axes_);
}

bool TimeStage::insideCorner(const MotionPace& pace, const MotionJoin& join) const {
  if (!moving_ || join.inside == 0 || last_join_.inside != join.inside || pace.rapid || last_.rapid)
    return false;
  const Vec3& from = last_.end.xyz;
  const Vec3& to = pace.begin.xyz;
  if (!inPlane(from, join.normal) || !inPlane(to, join.normal)) return false;
  const double turn = join.inside * planeTurnDeg(from, to, join.normal);
  return turn > 0.0 && 180.0 - turn < slowdown_.angle_deg;
}

void TimeStage::addStretches(const MotionPace& pace, const MotionJoin& join, double entry) {
  Stretch s;
  s.element = {pace.length, pace.speed, pace.acceleration, entry};
  s.motion = static_cast<std::uint32_t>(waiting_.size() - 1);
  s.corner = join.inside != 0 && !pace.rapid;
  if (!s.corner) slow_left_ = 0.0;
  if (slow_left_ > 0.0 && slow_left_ < pace.length) {
    Stretch first = s;
    first.element.length = slow_left_;
    slowDown(first);
    stretches_.push_back(first);
    s.element.length -= slow_left_;
    s.element.entry = kAnySpeed;
    slow_left_ = 0.0;
  } else if (slow_left_ > 0.0) {
    slow_left_ -= pace.length;
    slowDown(s);
  }
  stretches_.push_back(s);
}

/// Slows the way to the corner that the last motion ends in.
void TimeStage::slowBefore() {
  double left = slowdown_.before;
  for (std::size_t i = stretches_.size(); i-- > 0 && left > 0.0;) {
    Stretch& s = stretches_[i];
    if (!s.corner) return;
    if (s.element.length > left && !s.slow) {
      Stretch last = s;
      s.element.length -= left;
      last.element.length = left;
      last.element.entry = kAnySpeed;
      slowDown(last);
      stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(i) + 1, last);
      return;
    }
    left -= s.element.length;
    slowDown(s);
  }
}

void TimeStage::slowDown(Stretch& s) const {
  if (!s.slow) s.element.speed *= slowdown_.factor;
  s.slow = true;
}

const std::vector<SpeedElement>& TimeStage::elements() const {
  elements_.clear();
  for (const Stretch& s : stretches_) elements_.push_back(s.element);
  return elements_;
}

/// Plans what waits, to a stand at its end, and sends the first motions.
void TimeStage::emit(std::size_t motions) {
  PROVEOUT_ASSERT(motions <= waiting_.size());
  planStretches();
  PROVEOUT_ASSERT(speeds_.size() == stretches_.size() + 1);
  const std::size_t used = timeByPlan(motions);
  if (limits_.bell_time_s > 0.0) timeByBell(motions);
  send(motions);
  entry_ = speeds_[used];
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(motions));
  stretches_.erase(stretches_.begin(), stretches_.begin() + static_cast<std::ptrdiff_t>(used));
  PROVEOUT_ASSERT(stretches_.empty() || stretches_.front().motion >= motions);
  for (Stretch& s : stretches_) s.motion -= static_cast<std::uint32_t>(motions);
}

/// Speeds at the ends of all stretches.
void TimeStage::planStretches() {
  planSpeeds(elements(), entry_, speeds_);
  if (limits_.bell_time_s <= 0.0) return;
  const std::size_t stretches = stretches_.size();
  holdSpeeds();
  if (stretches_.size() != stretches) planSpeeds(elements(), entry_, speeds_);
}

/// The average over the rise of the acceleration passes a place at the speed planned there only if that is
/// kept for the time of the rise: half of it before the place, half behind. Without it corners and ends of
/// slow blocks would be passed faster than they may. Stands are for BellProfile.
void TimeStage::holdSpeeds() {
  struct Place {
    std::size_t boundary;
    double speed;
    bool before, behind;
  };
  std::vector<Place> places;
  constexpr double kSlack = 1e-9;
  for (std::size_t i = 1; i < stretches_.size(); ++i) {
    const SpeedElement& before = stretches_[i - 1].element;
    const SpeedElement& behind = stretches_[i].element;
    const double limit = std::min({behind.entry, before.speed, behind.speed});
    const double speed = speeds_[i];
    if (!(speed > 0.0) || speed < limit * (1.0 - kSlack)) continue;
    const Place place{i, speed, before.speed > speed * (1.0 + kSlack), behind.speed > speed * (1.0 + kSlack)};
    if (place.before || place.behind) places.push_back(place);
  }
  for (std::size_t k = places.size(); k-- > 0;) {  // from behind: the indices before stay
    hold(places[k].boundary, places[k].speed, places[k].before, places[k].behind);
  }
}

/// Limits the speed on the way that half a rise takes, before a boundary of stretches and behind it.
void TimeStage::hold(std::size_t boundary, double speed, bool before, bool behind) {
  const double way = 0.5 * speed * limits_.bell_time_s;
  const auto limit = [&](Stretch& s) { s.element.speed = std::min(s.element.speed, speed); };
  double left = behind ? way : 0.0;
  for (std::size_t i = boundary; i < stretches_.size() && left > 0.0; ++i) {
    if (stretches_[i].element.length > left && stretches_[i].element.speed > speed) {
      Stretch rest = stretches_[i];
      rest.element.length -= left;
      rest.element.entry = kAnySpeed;
      stretches_[i].element.length = left;
      stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
    }
    left -= stretches_[i].element.length;
    limit(stretches_[i]);
  }
  left = before ? way : 0.0;
  for (std::size_t i = boundary; i-- > 0 && left > 0.0;) {
    if (stretches_[i].element.length > left && stretches_[i].element.speed > speed) {
      Stretch last = stretches_[i];
      stretches_[i].element.length -= left;
      last.element.length = left;
      last.element.entry = kAnySpeed;
      limit(last);
      stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(i) + 1, last);
      return;
    }
    left -= stretches_[i].element.length;
    limit(stretches_[i]);
  }
}

/// Times of the first motions with constant accelerations. Returns how many stretches they have.
std::size_t TimeStage::timeByPlan(std::size_t motions) {
  PROVEOUT_ASSERT(elements_.size() == stretches_.size());
  for (std::size_t i = 0; i < motions; ++i) waiting_[i].motion.time_s = 0.0;
  std::size_t used = 0;
  for (; used < stretches_.size() && stretches_[used].motion < motions; ++used) {
    waiting_[stretches_[used].motion].motion.time_s +=
        elementTime(elements_[used], speeds_[used], speeds_[used + 1]);
  }
  return used;
}

/// The same with acceleration that comes up in its time. What is planned behind these motions may still
/// become faster; that shifts a part of a rise from one motion to its neighbour and leaves their sum.
void TimeStage::timeByBell(std::size_t motions) {
  struct Arrival {
    double way, time;
    bool stands;
  };
  std::vector<Arrival> arrivals(motions);
  std::size_t settled = bell_.size();
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    if (speeds_[i] == 0.0 && bell_.size() > 0) bell_.stand(limits_.bell_time_s);
    bell_.add(elements_[i], speeds_[i], speeds_[i + 1]);
    if (stretches_[i].motion >= motions) continue;
    arrivals[stretches_[i].motion] = {bell_.way(), bell_.time(), speeds_[i + 1] == 0.0};
    settled = bell_.size();
  }
  for (std::size_t i = 0; i < motions; ++i) {
    // Where the axes come to a stand the average arrives too gently to be searched for; its lag is known.
    const double arrived = arrivals[i].stands ? arrivals[i].time + limits_.bell_time_s
                                              : bell_.arrival(arrivals[i].way, arrivals[i].time);
    waiting_[i].motion.time_s = arrived - bell_time_;
    bell_time_ = arrived;
  }
  bell_.cut(settled);
  bell_.forgetBefore(bell_.time() - limits_.bell_time_s);
}

/// Sends the first waiting motions and what came along with them, in order.
void TimeStage::send(std::size_t motions) {
  std::size_t aside = 0;
  const auto sendAsides = [&](std::size_t before) {
    for (; aside < asides_.size() && asides_[aside].before <= before; ++aside) {
      if (asides_[aside].event) sink_.event(*asides_[aside].event);
      if (asides_[aside].diagnostic) sink_.diagnostic(*asides_[aside].diagnostic);
    }
  };
  for (std::size_t i = 0; i < motions; ++i) {
    sendAsides(i);
    const Waiting& w = waiting_[i];
    least_s_ -= w.least_s;
    count(w.motion);
    sink_.motion(w.motion, w.has_arc ? &w.arc : nullptr, w.has_axis ? &w.axis : nullptr);
  }
  if (motions == waiting_.size()) {
    sendAsides(motions);
    least_s_ = 0.0;
  }
  asides_.erase(asides_.begin(), asides_.begin() + static_cast<std::ptrdiff_t>(aside));
  PROVEOUT_ASSERT(asides_.empty() || asides_.front().before >= motions);
  for (Aside& a : asides_) a.before -= motions;
}

void TimeStage::flush() {
  if (!waiting_.empty()) emit(waiting_.size());
  PROVEOUT_ASSERT(waiting_.empty() && stretches_.empty() && asides_.empty());
  entry_ = 0.0;
  slow_left_ = 0.0;
  moving_ = false;
  bell_.reset();
  bell_time_ = 0.0;
}

void TimeStage::event(PathEvent event, bool stands) {
  if (stands) flush();
  summary_.cycle_s += event.time_s;
  if (waiting_.empty()) {
    sink_.event(event);
  } else {
    asides_.push_back({waiting_.size(), std::move(event), {}});
  }
}

void TimeStage::diagnostic(const Diagnostic& diagnostic) {
  if (waiting_.empty()) {
    sink_.diagnostic(diagnostic);
  } else {
    asides_.push_back({waiting_.size(), {}, diagnostic});
  }
}

TimeStage::Elapsed TimeStage::elapsed() const {
  Elapsed sum{summary_.cycle_s, summary_.cutting_s};
  if (waiting_.empty()) return sum;
  if (limits_.bell_time_s > 0.0) return elapsedByBell();
  planSpeeds(elements(), entry_, speeds_);
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const double time = elementTime(elements_[i], speeds_[i], speeds_[i + 1]);
    sum.cycle_s += time;
    if (waiting_[stretches_[i].motion].motion.kind != MotionKind::kRapid) sum.cutting_s += time;
  }
  return sum;
}

/// The same with a plan of its own: places where speeds are held divide stretches.
TimeStage::Elapsed TimeStage::elapsedByBell() const {
  class NoSink final : public MotionSink {
    void file(std::uint32_t, const std::string&) override {}
    void motion(const Motion&, const ArcGeometry*, const AxisSweep*) override {}
    void event(const PathEvent&) override {}
    void diagnostic(const Diagnostic&) override {}
  } nobody;
  InterpretSummary summary = summary_;
  TimeStage copy(nobody, summary);
  copy.limits_ = limits_;
  copy.axes_ = axes_;
  copy.waiting_ = waiting_;
  copy.stretches_ = stretches_;
  copy.entry_ = entry_;
  copy.bell_ = bell_;
  copy.bell_time_ = bell_time_;
  copy.flush();
  return {summary.cycle_s, summary.cutting_s};
}

}  // namespace proveout::nc
