#include "core/nc/flexnc/cycles/flexnc_cycles.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/geometry/to_float.h"
#include "core/nc/flexnc/flexnc_motion.h"
#include "core/nc/flexnc/flexnc_origins.h"

namespace proveout::nc {

namespace {

constexpr double kNoMove = 1e-9;  ///< mm; shorter moves are none

/// An angle in 0 <= angle < 360, degrees.
float angleOf(double turn) {
  const auto angle = toFloat(360.0 * (turn - std::floor(turn)));
  return angle < 360.0F ? angle : 0.0F;
}

bool readArguments(FlexContext& c, FlexCursor& cursor, CycleArguments& arguments) {
  for (; cursor.next < c.block.words.size(); ++cursor.next) {
    const FlexWord& word = c.block.words[cursor.next];
    if (arguments.set(word.address, word.value)) continue;
    return c.report.fail("fnc-param-extra", fmt::format("{} stands twice behind the code", word.address),
                         word.columns);
  }
  return true;
}

CycleCall callOf(const FlexContext& c, CycleCode code, const CycleArguments& arguments) {
  CycleCall call;
  call.code = code;
  call.arguments = arguments;
  call.arc_view = c.parameters.arcs_seen_x_up ? ArcView::kXUp : ArcView::kXDown;
  const Vec2 local = c.at() - c.offset();
  call.at = Vec2(local.y(), local.x());
  call.approached = c.cycle.approached;
  call.chain = c.cycle.chain;
  call.thread = c.cycle.thread;
  return call;
}

/// Feed and turns of a thread, whose way is known.
bool planThread(FlexContext& c, const CycleMove& move, FeedStyle& feed) {
  const Vec2 way = move.element.to - move.element.from;
  const double n = flexRpm(c, move.element.from.y());
  if (!(n > 0.0))
    return c.report.fail("fnc-spindle", "a thread while the spindle stands: M03 or M04 before it");
  const double along = std::abs(way.x()) > 0.0 ? std::abs(way.x()) : std::abs(way.y());
  feed.kind = MotionKind::kThread;
  feed.feed = way.norm() / along * move.lead * n;
  feed.spindle = c.state.spindle == 4 ? -n : n;
  feed.thread_start_deg = angleOf(move.turn);
  feed.join.stops = true;
  return true;
}

/// A move in (z, r) of the local system.
bool sendMove(FlexContext& c, const CycleMove& move) {
  const ContourElement& e = move.element;
  if (!e.arc && (e.to - e.from).norm() < kNoMove) return true;
  const Vec2 zero = c.offset(), to(e.to.y() + zero.x(), e.to.x() + zero.y());
  PathItem item = flexMotion(c, e.arc ? PathItem::Kind::kArc : PathItem::Kind::kLine, to);
  item.center = Vec3(e.center.x() + zero.y(), e.center.y() + zero.x(), c.machine[1]);
  item.sweep = e.sweep;
  item.rapid = move.kind == CycleMove::Kind::kRapid;
  item.feed.join.stops = item.rapid;
  if (move.kind == CycleMove::Kind::kThread && !planThread(c, move, item.feed)) return false;
  if (move.kind == CycleMove::Kind::kFeed && !planFlexFeed(c, to.x(), item.feed)) return false;
  return sendFlexMotion(c, item);
}

/// The moves with their places, and the place of what may come behind them.
bool sendMoves(FlexContext& c, std::size_t code, const std::vector<CycleMove>& moves) {
  FlexCycleOrigins origins(c, code);
  std::uint32_t number = 0;
  for (const CycleMove& move : moves) {
    origins.move(++number, move);
    if (c.watch.workOver(flowPlace(c.levels)) || !sendMove(c, move)) return false;
  }
  origins.place(number + 1);
  c.cycle.chain_source = c.report.here();
  return true;
}

/// The working point of G79.2 may be the edge away from the axis: the cut is the same.
void moveToOuterEdge(std::vector<CycleMove>& moves, double width) {
  for (CycleMove& move : moves) {
    for (Vec2* point : {&move.element.from, &move.element.to, &move.element.center}) point->y() += width;
  }
}

/// Sends the moves of an answer; cycles besides contours go without compensation.
bool runAnswer(FlexContext& c, std::size_t code, const CycleAnswer& answer) {
  const int comp = c.state.comp;
  if (comp != 40 && !answer.chain) {
    c.report.warnOnce("cycle under compensation", "fnc-cycle-comp",
                      "a cycle besides contour blocks while compensation is on: it runs without, G40 before "
                      "it");
    c.state.comp = 40;
  }
  const bool good = sendMoves(c, code, answer.moves);
  c.state.comp = comp;
  return good;
}

/// X and Z behind the code, X as a diameter; (z, r) of the local system.
bool readPoint(FlexContext& c, FlexCursor& cursor, const FlexWord& word, Vec2& point) {
  CycleArguments arguments;
  if (!readArguments(c, cursor, arguments)) return false;
  const std::string name = fmt::format("G{:g}", word.tenths / 10.0);
  if (!arguments.has('X') || !arguments.has('Z'))
    return c.report.fail("fnc-param-missing", name + " needs X, a diameter, and Z", word.columns);
  if (!(arguments.present().without("XZ")).empty())
    return c.report.fail("fnc-param-extra", name + " takes X and Z alone", word.columns);
  if (arguments.value('X') < 0.0)
    return c.report.fail("fnc-param-sign", name + ": the diameter X is below 0", word.columns);
  point = Vec2(arguments.value('Z'), 0.5 * arguments.value('X'));
  return true;
}

bool sendTo(FlexContext& c, const Vec2& point, bool rapid) {
  const Vec2 zero = c.offset(), to(point.y() + zero.x(), point.x() + zero.y());
  PathItem item = flexMotion(c, PathItem::Kind::kLine, to);
  item.rapid = rapid;
  item.feed.join.stops = rapid;
  return (rapid || planFlexFeed(c, to.x(), item.feed)) && sendFlexMotion(c, item);
}

void recordPoint(FlexContext& c, std::size_t code) {
  c.recorder.clear(KindSet::of(OriginKind::kX, OriginKind::kZ));
  for (std::size_t k = code + 1; k < c.block.words.size(); ++k) {
    const FlexWord& word = c.block.words[k];
    if (word.address == 'X') recordFlexAxis(c, OriginKind::kX, &word, false);
    if (word.address == 'Z') recordFlexAxis(c, OriginKind::kZ, &word, false);
  }
}

}  // namespace

bool performFlexCycle(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  const std::size_t code_at = cursor.next - 1;
  CycleArguments arguments;
  if (!readArguments(c, cursor, arguments)) return false;
  const CycleCode code = *cycleCode(word.tenths / 10.0);
  CycleAnswer answer = performCycle(callOf(c, code, arguments));
  for (const CycleNote& warning : answer.warnings) c.report.warn(std::string(warning.id), warning.text);
  if (answer.alarm) return c.report.fail(std::string(answer.alarm->id), answer.alarm->text);
  if (code == CycleCode::kG79_2 && c.parameters.ring_outer_edge)
    moveToOuterEdge(answer.moves, arguments.value('H'));
  if (answer.thread) c.cycle.thread = answer.thread;
  if (answer.moves.empty()) return true;
  c.cycle.approached = false;
  c.state.behind_cycle = 1;
  if (!runAnswer(c, code_at, answer)) return false;
  c.cycle.chain = answer.chain;
  c.cycle.chain_return = std::move(answer.chain_return);
  return true;
}

bool goesOnWithContour(const FlexContext& c) {
  bool in_template = false;
  for (const FlexWord& word : c.block.words) {
    if (in_template && word.address == 'K') return word.value == 0.0;
    if (in_template) continue;
    if (word.address == 'X' || word.address == 'Z' || word.address == 'M') return false;
    if (word.address != 'G' || word.tenths < 0) continue;
    const auto code = cycleCode(word.tenths / 10.0);
    if (code && !isTemplate(*code)) return false;
    in_template = code.has_value();
  }
  return false;
}

bool endFlexContours(FlexContext& c) {
  c.cycle.chain.reset();
  const std::vector<CycleMove> moves = std::exchange(c.cycle.chain_return, {});
  for (const CycleMove& move : moves) {
    const Vec2 zero = c.offset();
    PathItem item = flexMotion(c, PathItem::Kind::kLine,
                               Vec2(move.element.to.y() + zero.x(), move.element.to.x() + zero.y()));
    item.rapid = true;
    item.feed.join.stops = true;
    item.source = c.cycle.chain_source;
    if (!sendFlexMotion(c, item)) return false;
  }
  return true;
}

bool performFlexApproach(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  const std::size_t code_at = cursor.next - 1;
  Vec2 point;
  if (!readPoint(c, cursor, word, point)) return false;
  const double nose = flexNoseRadius(c);
  if (!(point.x() > nose)) {
    return c.report.fail("fnc-equi-z",
                         fmt::format("Z{:g} leaves no room for the nose radius {:g}: Z has to be larger, 3 "
                                     "radii at least",
                                     point.x(), nose),
                         word.columns);
  }
  if (point.x() < 3.0 * nose) {
    c.report.warn(
        "fnc-equi-z",
        fmt::format("Z{:g} is below 3 nose radii, {:g}: the manual asks for more", point.x(), 3.0 * nose),
        word.columns);
  }
  recordPoint(c, code_at);
  c.state.comp = 40;
  if (!sendTo(c, point, true)) return false;
  const bool right = word.tenths != 812;  // of the way along -Z: the larger radius
  c.state.comp = right != c.parameters.sides_seen_x_down ? 42 : 41;
  c.recorder.word(OriginKind::kCompensation, word.columns, word.value, word.reads, {});
  c.cycle.approached = sendTo(c, Vec2(0.0, point.y()), false);
  c.state.behind_cycle = 1;
  return c.cycle.approached;
}

bool performFlexEndBlock(FlexContext& c, FlexCursor& cursor, const FlexWord& word) {
  const std::size_t code_at = cursor.next - 1;
  Vec2 point;
  if (!readPoint(c, cursor, word, point)) return false;
  recordPoint(c, code_at);
  c.state.comp = 40;
  c.recorder.word(OriginKind::kCompensation, word.columns, word.value, word.reads, {});
  c.cycle.approached = false;
  c.state.behind_cycle = 1;
  return sendTo(c, point, true);
}

}  // namespace proveout::nc
