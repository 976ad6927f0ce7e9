#include "core/nc/flexnc/flexnc_motion.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/nc/flexnc/flexnc_origins.h"
#include "core/nc/services/arcs.h"
#include "core/nc/services/surface_speed.h"
#include "core/tool/tip.h"

namespace proveout::nc {

namespace {

constexpr double kRadiusTolerance = 0.01;     ///< mm; a larger difference makes a spiral of an arc
constexpr double kLeastTurn = degToRad(1.0);  ///< corners that turn by less get no arc
constexpr double kFarthest = 1e4;             ///< mm from its start; no arc of a lathe leads farther away
constexpr double kLeastRadius = 1e-3;         ///< mm; at the axis the speed would be infinite

WorkPlane turningPlane() { return WorkPlane(PlaneFrame(Plane::kZX)); }

double meanRpm(const FlexContext& c, double from, double to) {
  const FlexState& s = c.state;
  if (s.css != 86) return s.rpm;
  const double product = 1000.0 * s.surface / (2.0 * kPi), top = c.parameters.max_speed;
  return meanSurfaceRpm(product, from, to, {0.0, top > 0.0 ? top : product / kLeastRadius});
}

void warnOfUnlimitedSpeed(FlexContext& c, double from, double to) {
  const bool axis = from * to <= 0.0 || std::min(std::abs(from), std::abs(to)) < kLeastRadius;
  if (!axis || c.parameters.max_speed > 0.0) return;
  c.report.warnOnce("surface speed", "fnc-surface-speed",
                    "G86 to the axis without a limit of the spindle's speed: speed and time there are those "
                    "of no real machine; give MAX_SPEED in [control.flexnc]");
}

/// Feed per revolution becomes mm/min.
void feedPerRevolution(FlexContext& c, double from, double to, FeedStyle& feed) {
  double n = c.state.turns() ? meanRpm(c, from, to) : 0.0;
  if (!(n > 0.0)) {
    n = c.settings.default_spindle_rpm;
    c.report.warnOnce("feed without spindle", "fnc-spindle-off",
                      fmt::format("feed per revolution while the spindle stands: timed at {} 1/min", n));
  }
  feed.feed *= n;
}

/// The end of the motion, (x, z), machine frame.
Vec2 targetOf(FlexContext& c, const FlexAxisWords& words) {
  Vec2 target = c.at();
  const Vec2 zero = c.offset();
  const bool step = c.state.distance == 91;
  for (const int k : {0, 1}) {
    const FlexWord* const word = k == 0 ? words.x : words.z;
    if (word == nullptr) continue;
    const double value = word->value * (k == 0 && c.parameters.diameters ? 0.5 : 1.0);
    target[k] = step ? target[k] + value : zero[k] + value;
    recordFlexAxis(c, k == 0 ? OriginKind::kX : OriginKind::kZ, word, step);
  }
  return target;
}

bool moveLine(FlexContext& c, const FlexAxisWords& words) {
  if (words.i != nullptr || words.k != nullptr) {
    return c.report.fail("fnc-arc",
                         fmt::format("I and K give the centre of an arc: G{:02} has none", c.state.motion),
                         (words.i != nullptr ? words.i : words.k)->columns);
  }
  const Vec2 target = targetOf(c, words);
  PathItem item = flexMotion(c, PathItem::Kind::kLine, target);
  item.rapid = c.state.motion == 0;
  item.feed.join.stops = item.rapid;
  if (item.rapid && c.settings.rapid_by_default) {
    c.report.note("rapids", "fnc-rapid",
                  "the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the "
                  "machine turns a corner");
  }
  return (item.rapid || planFlexFeed(c, target.x(), item.feed)) && sendFlexMotion(c, item);
}

/// A sense of rotation that the machine's drawing turns over is the usual reason of such arcs.
void warnOfLongWay(FlexContext& c, double sweep) {
  if (std::abs(sweep) <= kPi + 1e-9 || std::abs(sweep) >= 2.0 * kPi - 1e-9) return;
  c.report.warnOnce("long arc", "fnc-arc-view",
                    fmt::format("the arc goes the long way round, {:.3g} degrees: does the machine draw X "
                                "{}? Then set arc_view in [control.flexnc]",
                                radToDeg(std::abs(sweep)), c.parameters.arcs_seen_x_up ? "down" : "up"));
}

bool resolveFlexArc(FlexContext& c, const FlexAxisWords& words, const Vec2& target, PlaneArc& arc) {
  const FlexState& s = c.state;
  const double scale = c.parameters.diameters ? 0.5 : 1.0;
  ArcRequest request;
  const AxisPoint end(target.x(), c.machine[1], target.y());
  request.start = turningPlane().of(c.machine);
  request.end = turningPlane().of(end);
  request.has_plane_end = words.x != nullptr || words.z != nullptr;
  request.counter_clockwise = (s.motion == 3) == c.parameters.arcs_seen_x_up;
  request.center_u = words.k != nullptr ? words.k->value : 0.0;
  request.center_v = words.i != nullptr ? scale * words.i->value : 0.0;
  ArcPolicy policy;
  policy.radius_tolerance = std::numeric_limits<double>::max();
  const ArcResolution resolved = resolveArc(request, policy);
  arc = resolved.arc;
  const double smallest = std::min(arc.startRadius(), arc.endRadius());
  if (!resolved.ok() || smallest < 1e-6)
    return c.report.fail("fnc-arc", "start or end lie on the centre: these words give no arc");
  if (const double away = farthestFromStart(arc); away > kFarthest) {
    return c.report.fail("fnc-arc",
                         fmt::format("the arc leads {:.0f} m away from its start: no machine gets there. Start and end "
                                     "are {:.4f} and {:.4f} mm from the centre; I and K count from the start to it",
                                     1e-3 * away, arc.startRadius(), arc.endRadius()));
  }
  if (resolved.radius_difference > kRadiusTolerance) {
    c.report.warn("fnc-arc-radius",
                  fmt::format("start and end are {:.4f} and {:.4f} mm from the centre: the radius changes "
                              "along the way, a spiral",
                              arc.startRadius(), arc.endRadius()));
  }
  warnOfLongWay(c, arc.sweep_rad);
  return true;
}

bool moveArc(FlexContext& c, const FlexAxisWords& words) {
  if (c.state.plane != 18) {
    return c.report.fail("fnc-arc", fmt::format("an arc in the plane of G{}: this machine has X and Z, put "
                                                "G18 before it",
                                                c.state.plane));
  }
  if (words.i == nullptr && words.k == nullptr) {
    return c.report.fail("fnc-arc",
                         fmt::format("the arc G{:02} has no centre: give I, K or both, from its "
                                     "start",
                                     c.state.motion),
                         words.first()->columns);
  }
  const Vec2 target = targetOf(c, words);
  recordFlexAxis(c, OriginKind::kI, words.i, false);
  recordFlexAxis(c, OriginKind::kK, words.k, false);
  PlaneArc arc;
  if (!resolveFlexArc(c, words, target, arc)) return false;
  PathItem item = flexMotion(c, PathItem::Kind::kArc, target);
  item.center = Vec3(arc.center.x(), arc.center.y(), c.machine[1]);
  item.sweep = arc.sweep_rad;
  return planFlexFeed(c, target.x(), item.feed) && sendFlexMotion(c, item);
}

bool checkCompensation(FlexContext& c) {
  if (c.state.plane != 18) {
    return c.report.fail("fnc-arc", fmt::format("compensation in the plane of G{}: this machine has X and "
                                                "Z, put G18 before it",
                                                c.state.plane));
  }
  if (c.state.d == 0) {
    c.report.warnOnce("no corrector", "fnc-corrector",
                      "compensation without a corrector: D is missing, its radius is taken for 0");
  }
  if (flexNoseRadius(c) < 0.0) {
    return c.report.fail("fnc-corrector",
                         fmt::format("the nose radius of corrector D{} is below 0", c.state.d));
  }
  return true;
}

/// Of the touch-off point from the nose centre of the corrector in force, machine frame.
Vec3 tipOf(const FlexContext& c) {
  const FlexParameters::Corrector& corrector = c.parameters.corrector(c.state.d);
  const Vec2 tip = corrector.nose_radius * tipDirection(corrector.tip);
  return {tip.x(), 0.0, tip.y()};
}

}  // namespace

double flexRpm(const FlexContext& c, double radius) {
  const FlexState& s = c.state;
  if (!s.turns()) return 0.0;
  const double top = c.parameters.max_speed;
  double n = s.rpm;
  if (s.css == 86) n = 1000.0 * s.surface / (2.0 * kPi * std::max(std::abs(radius), kLeastRadius));
  return top > 0.0 ? std::min(n, top) : n;
}

double flexNoseRadius(const FlexContext& c) {
  double radius = c.parameters.corrector(c.state.d).nose_radius;
  const auto row = c.settings.radius_offsets.find(c.state.d);
  if (row != c.settings.radius_offsets.end()) radius += row->second.geometry + row->second.wear;
  return radius;
}

bool planFlexFeed(FlexContext& c, double to_x, FeedStyle& feed) {
  const FlexState& s = c.state;
  if (!(s.feed > 0.0)) return c.report.fail("fnc-feed", "a motion at feed without a feed: F is missing");
  if (s.feed_unit != s.feed_mode) {
    c.report.warnOnce("stale feed", "fnc-feed-unit",
                      fmt::format("F{:g} was told in {}, and counts in {} since G{}: give F behind it",
                                  s.feed, s.feed_unit == 98 ? "mm/min" : "mm/rev",
                                  s.feed_mode == 98 ? "mm/min" : "mm/rev", s.feed_mode));
  }
  const double zero = c.origin().x() + s.corrector.x();
  const double from = c.machine[0] - zero, to = to_x - zero;
  feed.feed = s.feed;
  if (s.feed_mode == 99) feedPerRevolution(c, from, to, feed);
  if (s.css == 86 && s.turns()) {
    warnOfUnlimitedSpeed(c, from, to);
    feed.spindle = (s.spindle == 4 ? -1.0 : 1.0) * meanRpm(c, from, to);
  }
  if (!s.turns()) {
    c.report.warnOnce("cut without spindle", "fnc-spindle-off",
                      "a motion at feed while the spindle stands: M03 or M04 is missing before it");
  }
  return true;
}

PathItem flexMotion(FlexContext& c, PathItem::Kind kind, const Vec2& to) {
  PathItem item;
  item.kind = kind;
  item.space = PathItem::Space::kWork;
  item.plane = turningPlane();
  item.to = c.machine;
  item.to[0] = to.x();
  item.to[2] = to.y();
  item.in_plane = true;
  item.comp_on = c.state.comp != 40;
  const bool left = (c.state.comp == 41) != c.parameters.sides_seen_x_down;
  item.offset = item.comp_on ? (left ? 1.0 : -1.0) * flexNoseRadius(c) : 0.0;
  item.start = item.plane.of(c.machine).head<2>();
  item.level = true;
  item.source = c.report.here();
  return item;
}

bool sendFlexMotion(FlexContext& c, PathItem& item) {
  const Vec2 to(item.to[0], item.to[2]);
  if (item.comp_on && !checkCompensation(c)) return false;
  if (item.comp_on) c.comp_stage.setTip(tipOf(c));
  if (item.comp_on && !c.comp_stage.linked()) {
    c.comp_stage.engage(item.plane.of(c.machine), {.arc_least_turn_rad = kLeastTurn,
                                                   .around_at_ends = true,
                                                   .switches_in_arcs = true,
                                                   .negative_radius_runs = true});
  }
  if (!c.pipe.push(item)) return false;
  c.machine[0] = to.x();
  c.machine[2] = to.y();
  return true;
}

bool moveFlexAxes(FlexContext& c, const FlexAxisWords& words) {
  c.cycle.approached = false;
  return c.state.motion < 2 ? moveLine(c, words) : moveArc(c, words);
}

PathItem flexFunction(FlexContext& c, PathItem::Kind kind) {
  PathItem item;
  item.kind = kind;
  item.plane = turningPlane();
  item.to = c.machine;
  item.comp_on = c.state.comp != 40;
  item.source = c.report.here();
  return item;
}

bool sendFlexEvent(FlexContext& c, EventKind what) {
  PathItem item = flexFunction(c, PathItem::Kind::kEvent);
  item.event = std::make_unique<EventKind>(std::move(what));
  return c.pipe.push(item);
}

}  // namespace proveout::nc
