#include "core/nc/fanuc/lathe/lathe_moves.h"

#include <cmath>

#include "core/geometry/to_float.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

constexpr double kNoWayMm = 1e-9;

/// An angle in 0 <= angle < 360, degrees.
float turned(double degrees) {
  const double rest = degrees - 360.0 * std::floor(degrees / 360.0);
  const auto angle = toFloat(rest);
  return angle < 360.0F && angle >= 0.0F ? angle : 0.0F;
}

}  // namespace

std::optional<double> threadTurnsOf(double way, double lead, double change) {
  if (change == 0.0) return way / lead;
  const double root = lead * lead + 2.0 * change * way;
  if (root < 0.0) return std::nullopt;
  return 2.0 * way / (lead + std::sqrt(root));
}

LatheMoves::LatheMoves(IsoContext& c, BlockPlan& plan, bool compensated)
    : c_(c),
      plan_(plan),
      compensated_(compensated),
      work_(c.chain.workOf(c.position)),
      at_(work_[2], work_[0]) {}

Vec2 LatheMoves::pointOf(const AxisPoint& programmed) const {
  const AxisPoint work = c_.chain.workOf(programmed);
  return {work[2], work[0]};
}

bool LatheMoves::send(PathItem& item, const Vec2& to) {
  work_[2] = to.x();
  work_[0] = to.y();
  at_ = to;
  item.space = PathItem::Space::kWork;
  item.plane = WorkPlane(PlaneFrame(Plane::kZX));
  item.in_plane = true;
  item.to = work_;
  if (compensated_) {
    item.comp_on = plan_.next.compOn();
    item.offset = plan_.next.compOffset();
    item.tip = static_cast<std::uint8_t>(plan_.next.d_tip);
  }
  if (item.source.line == 0) item.source = c_.here();
  return c_.pipe.push(item);
}

/// The feed of a move from at() to `to`: with G96 the spindle turns as the way asks.
bool LatheMoves::takeFeed(const Vec2& to, FeedStyle& feed) {
  AxisPoint machine = work_;
  c_.chain.moveToMachine(machine);
  plan_.start = c_.chain.programOf(machine);
  machine = work_;
  machine[2] = to.x();
  machine[0] = to.y();
  c_.chain.moveToMachine(machine);
  plan_.motion.target = c_.chain.programOf(machine);
  return feedStyle(c_, plan_, feed);
}

bool LatheMoves::rapid(const Vec2& to) {
  if ((to - at_).norm() < kNoWayMm) return true;
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.rapid = true;
  return send(item, to);
}

bool LatheMoves::feed(const ContourElement& e, const SourceRef* source) {
  if (!e.arc && (e.to - at_).norm() < kNoWayMm) return true;
  PathItem item;
  item.kind = e.arc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
  if (!takeFeed(e.to, item.feed)) return false;
  if (e.arc) {
    item.center = {e.center.x(), e.center.y(), work_[1]};
    item.start = e.from;
    item.sweep = e.sweep;
  }
  if (source != nullptr) item.source = *source;
  return send(item, e.to);
}

bool LatheMoves::thread(const Vec2& to, double lead, double change) {
  const Vec2 way = to - at_;
  if (way.norm() < kNoWayMm) return true;
  const auto turns = threadTurnsOf(way.cwiseAbs().maxCoeff(), lead, change);
  if (!turns) return c_.fail("thread", "the lead falls to zero before the end of the thread");
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  if (!takeFeed(to, item.feed)) return false;
  item.feed.kind = MotionKind::kThread;
  item.feed.feed = way.norm() / *turns * turnsPerMinute(c_, plan_);
  item.feed.join.stops = false;
  item.feed.join.unbroken = true;
  item.feed.thread_start_deg = turned(angle_deg_);
  item.feed.thread_pitch_change = toFloat(change);
  angle_deg_ = std::fmod(angle_deg_ + 360.0 * *turns, 360.0);
  return send(item, to);
}

void LatheMoves::finish() {
  c_.machine = work_;
  c_.chain.moveToMachine(c_.machine);
  c_.position = c_.chain.programOf(c_.machine);
}

}  // namespace proveout::nc
