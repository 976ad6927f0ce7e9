#include "core/nc/stages/rapid_overlap_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proveout::nc {
namespace {

double distance(const AxisPoint& a, const AxisPoint& b, int axes) {
  double sum = 0.0;
  for (int k = 0; k < axes; ++k) sum += (b[k] - a[k]) * (b[k] - a[k]);
  return std::sqrt(sum);
}

}  // namespace

void RapidOverlapStage::configure(const MotionLimits& limits, double share, bool stands) {
  limits_.count = axes_.count();
  limits_.rise_s = limits.bell_time_s;
  for (int k = 0; k < axes_.count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    limits_.speed[i] = (k < kMainAxes ? settings_.rapid_mm_min[k] : axes_.at(k).rapid) / 60.0;
    limits_.acceleration[i] = limits.axes[i].acceleration;
  }
  share_ = share;
  stands_ = stands;
}

bool RapidOverlapStage::push(PathItem& item) {
  const bool overlaps = item.kind == PathItem::Kind::kLine && item.rapid && !item.in_polar && !item.pose;
  if (!overlaps) return finish() && pass(item);
  return start(item);
}

bool RapidOverlapStage::start(PathItem& item) {
  const AxisPoint from = item_ ? item_->to : emitter_.machine();
  if (from == item.to) return true;
  RapidLeg next = rapidLeg(from, item.to, 0.0, limits_);
  if (item_) {
    double time = overlapStart(leg_, next, share_, limits_);
    if (has_tail_) time = std::max(time, tail_.end);
    if (!sendUntil(time)) return false;
    next.start += time;
    next.end += time;
    tail_ = leg_;
    has_tail_ = true;
  }
  leg_ = next;
  const bool stops = stands_ || item.feed.join.stops;
  item_ = std::move(item);
  return !stops || finish();
}

bool RapidOverlapStage::sendUntil(double time) {
  AxisPoint last = emitter_.machine();
  double waited = 0.0;
  sending_ = true;
  overlapChords(has_tail_ ? &tail_ : nullptr, leg_, sent_, time, limits_,
                [&](const AxisPoint& to, double duration) {
                  const double length = distance(last, to, limits_.count);
                  waited += duration;
                  if (!item_ || !(length > 0.0)) return;
                  PathItem piece = item_->copyMotion();
                  piece.to = to;
                  piece.rapid_speed = 60.0 * length / waited;
                  if (!pass(piece)) item_.reset();  // the axes do not go on behind an alarm
                  last = to;
                  waited = 0.0;
                });
  sending_ = false;
  sent_ = time;
  if (!item_) forget();
  return item_.has_value();
}

bool RapidOverlapStage::finish() {
  const bool good = !item_ || sendUntil(endOfRapids());
  forget();
  return good;
}

void RapidOverlapStage::forget() {
  item_.reset();
  has_tail_ = false;
  sent_ = 0.0;
}

bool RapidOverlapStage::flush(FlushReason reason) { return reason == FlushReason::kTransform || finish(); }

void RapidOverlapStage::clear() {
  if (sending_) {
    item_.reset();  // an alarm in the middle of it
  } else {
    finish();  // the axes are on their way: they come to a stand
  }
}

}  // namespace proveout::nc
