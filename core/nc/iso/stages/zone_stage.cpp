#include "core/nc/iso/stages/zone_stage.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/nc/iso/parameters/safety.h"

namespace proveout::nc {
namespace {

/// Along a way on which rotary axes turn about the tip.
constexpr int kPoseChords = 64;
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Whether the machine's PLC has chosen range B there: "Z+".
bool rangeB(const ZoneStage::Channel& c, int axis, char side) {
  const auto& chosen = c.settings.stroke_range_b;
  return std::find(chosen.begin(), chosen.end(), c.axes.at(axis).name + side) != chosen.end();
}

ZonePath pathOf(const ZoneStage::Channel& c, const PathItem& item) {
  ZonePath path(c.emitter.machine(), item.to, c.axes.count());
  if (item.kind != PathItem::Kind::kArc) return path;
  const WorkPlane& p = item.plane;
  if (p.u < kMainAxes && p.v < kMainAxes) {
    path.setArc(0, 1, 2, {item.center, item.normal, item.sweep});
  } else {
    path.setArc(p.u, p.v, p.w, {item.center, Vec3::UnitZ(), item.sweep});
  }
  return path;
}

}  // namespace

Zone endlessZone(bool outside) {
  Zone zone;
  zone.outside = outside;
  for (int k = 0; k < kMaxAxes; ++k) {
    zone.low[k] = -kFar;
    zone.high[k] = kFar;
  }
  return zone;
}

void boundZone(Zone& zone, int axis, double low, double high) {
  zone.axes.set(static_cast<std::size_t>(axis));
  zone.low[axis] = low;
  zone.high[axis] = high;
}

std::string checkRangeB(const ControlSettings& settings, const AxisTable& axes) {
  for (const std::string& side : settings.stroke_range_b) {
    const bool sign = side.size() > 1 && (side.back() == '+' || side.back() == '-');
    if (!sign || axes.find(std::string_view(side).substr(0, side.size() - 1)) < 0) {
      return fmt::format("range B: '{}' is not an axis with + or -", side);
    }
  }
  return {};
}

bool ZoneStage::addStroke() {
  Watched own{Area::kStroke, endlessZone(true)}, told{Area::kStroke, endlessZone(true), true};
  const IsoParameters& p = c_.parameters;
  for (int k = 0; k < c_.axes.count(); ++k) {
    const AxisInfo& axis = c_.axes.at(k);
    const int n = axis.number;
    const auto side = [&](char sign, SafetyParam a, SafetyParam b, double none) {
      const SafetyParam param = rangeB(c_, k, sign) ? b : a;
      return p.given(param, n) ? p.value(param, n) : none;
    };
    const double high = side('+', SafetyParam::kStrokeAHigh, SafetyParam::kStrokeBHigh, kFar);
    const double low = side('-', SafetyParam::kStrokeALow, SafetyParam::kStrokeBLow, -kFar);
    if (low > high) {
      return c_.alarms.fail("parameter",
                            fmt::format("stroke of axis {}: its positive end {} is below its negative end {}",
                                        axis.name, high, low));
    }
    if (std::isfinite(low) || std::isfinite(high)) {
      boundZone(own.zone, k, low, high);
    } else if (axis.limit) {
      boundZone(told.zone, k, axis.limit->min, axis.limit->max);
    }
  }
  if (own.zone.axes.any()) watched_.push_back(own);
  if (told.zone.axes.any() && check_before_) watched_.push_back(told);
  return true;
}

bool ZoneStage::addSecond() {
  if (const auto& programmed = c_.program_zone) {
    if (programmed->axes.any()) watched_.push_back({Area::kSecond, *programmed});
    return true;
  }
  const IsoParameters& p = c_.parameters;
  if (!p.flag(SafetyParam::kZone2On)) return true;
  Watched area{Area::kSecond, endlessZone(p.flag(SafetyParam::kZone2Outside))};
  for (int k = 0; k < c_.axes.count(); ++k) {
    const int n = c_.axes.at(k).number;
    if (!p.flag(SafetyParam::kZone2Axis, n)) continue;
    const double low = p.value(SafetyParam::kZone2Low, n), high = p.value(SafetyParam::kZone2High, n);
    if (!(high > low)) {
      return c_.alarms.fail("parameter",
                            fmt::format("zone 2 of axis {}: {} must be above {}", c_.axes.at(k).name,
                                        p.name(SafetyParam::kZone2High), p.name(SafetyParam::kZone2Low)));
    }
    boundZone(area.zone, k, low, high);
  }
  if (area.zone.axes.any()) watched_.push_back(area);
  return true;
}

bool ZoneStage::addThird() {
  const IsoParameters& p = c_.parameters;
  Watched area{Area::kThird, endlessZone(false)};
  for (int k = 0; k < c_.axes.count(); ++k) {
    const int n = c_.axes.at(k).number;
    if (!p.flag(SafetyParam::kZone3Axis, n)) continue;
    const double low = p.value(SafetyParam::kZone3Low, n), high = p.value(SafetyParam::kZone3High, n);
    if (!(high > low)) {
      return c_.alarms.fail("parameter",
                            fmt::format("zone 3 of axis {}: {} must be above {}", c_.axes.at(k).name,
                                        p.name(SafetyParam::kZone3High), p.name(SafetyParam::kZone3Low)));
    }
    boundZone(area.zone, k, low, high);
  }
  if (area.zone.axes.any()) watched_.push_back(area);
  return true;
}

bool ZoneStage::configure() {
  watched_.clear();
  check_before_ = c_.parameters.flag(SafetyParam::kCheckBefore);
  if (!addStroke() || !addSecond() || !addThird()) return false;
  if (watched_.empty()) {
    c_.pipe.unlink(*this);
  } else if (!linked()) {
    c_.pipe.link(*this);
  }
  return true;
}

double ZoneStage::ceiling(int axis) const {
  double end = kFar;
  for (const Watched& w : watched_) {
    if (w.zone.outside && w.zone.axes[static_cast<std::size_t>(axis)]) end = std::min(end, w.zone.high[axis]);
  }
  return end;
}

/// N1001.CBM: the end first, then the way (manual 22.4).
std::optional<ZoneStage::Found> ZoneStage::before(const ZonePath& path) const {
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const Watched& w = watched_[i];
    const bool stroke = w.area == Area::kStroke;
    const auto hit = forbidden(w.zone, path.end(), path.count());
    if (!hit) continue;
    const SharedAlarm above = stroke ? SharedAlarm::kEndAbove : SharedAlarm::kZoneEndAbove;
    const SharedAlarm below = stroke ? SharedAlarm::kEndBelow : SharedAlarm::kZoneEndBelow;
    const SharedAlarm inner =
        w.area == Area::kSecond ? SharedAlarm::kZoneEndInside2 : SharedAlarm::kZoneEndInside3;
    return Found{i, *hit, !w.zone.outside ? inner : hit->above ? above : below};
  }
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const Watched& w = watched_[i];
    if (w.zone.outside) continue;
    if (const auto hit = firstForbidden(w.zone, path))
      return Found{i, *hit, w.area == Area::kSecond ? SharedAlarm::kZoneEntry2 : SharedAlarm::kZoneEntry3};
  }
  return std::nullopt;
}

std::optional<ZoneStage::Found> ZoneStage::during(const ZonePath& path) const {
  std::optional<Found> first;
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const Watched& w = watched_[i];
    if (w.only_before) continue;
    const auto hit = firstForbidden(w.zone, path);
    if (!hit || (first && first->hit.t <= hit->t)) continue;
    const bool stroke = w.area == Area::kStroke;
    const SharedAlarm above = stroke ? SharedAlarm::kRanAbove : SharedAlarm::kZoneRanAbove;
    const SharedAlarm below = stroke ? SharedAlarm::kRanBelow : SharedAlarm::kZoneRanBelow;
    const SharedAlarm inner = w.area == Area::kSecond ? SharedAlarm::kZoneRan2 : SharedAlarm::kZoneRan3;
    first = Found{i, *hit, !w.zone.outside ? inner : hit->above ? above : below};
  }
  return first;
}

std::string ZoneStage::axisName(const ZoneHit& hit) const {
  return hit.axis < 0 ? "" : c_.axes.at(hit.axis).name;
}

/// The alarm, and with `moves` the motion up to it. Always false.
bool ZoneStage::stop(PathItem& item, const Found& found, const ZonePath& path, bool moves) {
  PROVEOUT_ASSERT(found.watched < watched_.size() && found.alarm != SharedAlarm::kCount);
  const Watched watched = watched_[found.watched];
  const std::string message = c_.alarms.table().message(found.alarm, axisName(found.hit));
  const int number = c_.alarms.table().number(found.alarm);
  const int axis = found.hit.axis;
  if (watched.area == Area::kStroke) {
    const double limit = found.hit.above ? watched.zone.high[axis] : watched.zone.low[axis];
    const double end = path.end()[axis];
    const bool beyond = found.hit.above ? end > limit : end < limit;
    c_.emitter.event(event::Overtravel{axisName(found.hit), beyond ? end : limit, limit, number}, 0.0,
                     item.source);
  } else {
    c_.emitter.event(event::ForbiddenZone{watched.area == Area::kSecond ? 2 : 3, number, message}, 0.0,
                     item.source);
  }
  if (moves && found.hit.t > 0.0) {
    PathItem part = item.copyMotion();
    part.to = path.at(found.hit.t);
    part.sweep *= found.hit.t;
    pass(part);
  }
  if (sameBlock(c_.calls.here(), item.source)) {
    c_.alarms.fail(found.alarm, message);
  } else {
    c_.alarms.sendLate(Severity::kError, found.alarm, message, item.source, item.record);
  }
  watched_.erase(watched_.begin() + static_cast<std::ptrdiff_t>(found.watched));
  if (watched_.empty()) c_.pipe.unlink(*this);
  c_.recovery.recover();
  return false;
}

/// A motion whose axes do not go straight: its way is looked at in chords, and where it would enter an area
/// it is left out.
bool ZoneStage::pushCurve(PathItem& item, int chords, const std::function<AxisPoint(double)>& at) {
  AxisPoint last = c_.emitter.machine();
  for (int i = 1; i <= chords; ++i) {
    const AxisPoint p = at(static_cast<double>(i) / chords);
    const ZonePath chord(last, p, c_.axes.count());
    if (const auto found = during(chord)) return stop(item, *found, chord, false);
    last = p;
  }
  return pass(item);
}

bool ZoneStage::pushPolar(PathItem& item) {
  constexpr int kChords = 256;
  const AxisPoint from = c_.emitter.machine();
  std::optional<PolarArc> arc;
  if (item.kind == PathItem::Kind::kArc) arc = PolarArc{item.center.head<2>(), item.sweep};
  const PolarPlane& plane = item.polar;
  const PolarLeg leg{plane.of(from), plane.of(item.to), arc};
  return pushCurve(item, kChords, [&](double t) {
    AxisPoint p = between(from, item.to, t);
    if (t >= 1.0) return p;
    const Vec2 q = leg.at(t);
    const double angle = plane.zero_deg + radToDeg(std::atan2(plane.sign * q.y(), plane.sign * q.x()));
    p[plane.linear] = plane.zero + plane.sign * q.norm();
    p[plane.rotary] += std::remainder(angle - p[plane.rotary], 360.0);
    return p;
  });
}

bool ZoneStage::push(PathItem& item) {
  if (item.kind != PathItem::Kind::kLine && item.kind != PathItem::Kind::kArc) return pass(item);
  if (item.in_polar) return pushPolar(item);
  if (item.pose) return pushCurve(item, kPoseChords, item.pose->at);
  const ZonePath path = pathOf(c_, item);
  if (check_before_) {
    if (const auto found = before(path)) return stop(item, *found, path, false);
  }
  if (const auto found = during(path)) return stop(item, *found, path, true);
  return pass(item);
}

}  // namespace proveout::nc
