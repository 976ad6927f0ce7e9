// Open cycles: program %1. Contour cycles: G76, G77, G78 with P and Q (digest wl4, 9 and 10).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/services/arcs.h"
#include "core/nc/wl4/wl4_control.h"

namespace proveout::nc {

namespace {

constexpr std::size_t kMostContourBlocks = 200;

bool allowedInContour(int g) {
  return (g >= 0 && g <= 3) || g == 12 || g == 13 || (g >= 40 && g <= 42) || g == 90 || g == 91;
}

}  // namespace

Wl4Control::Go Wl4Control::openCycle(const Plan& p) {
  state_.open_cycle = p.deed;
  const OriginRecorder::Slot fixed_cycle = origins_.slot(OriginKind::kCycle);
  for (const Wl4Block::Code& word : block_.g) {
    if (word.number == p.deed) recordCode(word, OriginKind::kCycle);
  }
  tellPlainWords();
  const Go go = call("1", 1);
  origins_.put(OriginKind::kCycle, fixed_cycle);
  return go;
}

bool Wl4Control::contourCycle(Plan& p) {
  const Wl4Block& b = block_;
  const auto refuse = [&](const char* why) { return fail("wl4-contour", why); };
  if (!lathe_) return refuse("G76 to G78 are cycles of the lathe");
  if (state_.radius != 40) return refuse("compensation has to be off before G76 to G78: G40");
  if (!b.has('P') || !b.has('Q'))
    return refuse("P and Q are missing: the first and the last block of the contour");
  if (!b.hasCode(0) && !b.hasCode(1))
    return refuse("G0 or G1 is missing: it says how the tool goes to its passes");
  const bool equidistant = b.has('R'), sided = p.next.radius != 40, roughing = b.has('E');
  if (equidistant && !sided) return refuse("the allowance R needs G41 or G42");
  if (equidistant && (b.has('I') || b.has('K'))) return refuse("allowances are either I and K or R");
  if (roughing && !(b.value('E') > 0.0)) return refuse("the depth of cut E has to be above 0");
  const bool stock = b.has('U') || b.has('W') || b.has('C');
  if (p.deed == 76 && stock != roughing) return refuse("G76 needs the stock U, W or C together with E");
  if (p.deed != 76 && stock) return refuse("U, W and C belong to G76");

  const OriginRecorder::Slots words = origins_.slots();
  recordContourCycle(p);
  const bool good = cutContour(p, sided);
  origins_.restore(words, {});
  return good;
}

bool Wl4Control::cutContour(Plan& p, bool sided) {
  const Wl4Block& b = block_;
  PlaneContour contour;
  if (!readContour(p, contour)) return false;
  const WorkPlane w(plane(p.next));
  // Passes are the way of the nose centre, which stands off the working point all the time.
  const Vec2 from = w.of(machine_).head<2>() - (sided ? tipOf(p.next) : Vec2(Vec2::Zero()));
  const double side = (p.next.radius == 41) != flipped(p.next) ? 1.0 : -1.0;
  CycleGeometry cycle{from, contour, sided ? side : 1.0, sided ? compRadius(p.next) : 0.0};
  if (sided && cycle.nose < 0.0)
    return fail("wl4-contour", "the nose radius and the corrector D are negative together");
  std::vector<ContourMove> moves;
  if (!passes(p, b, cycle, moves)) return false;
  p.next.radius = 40;
  return runPasses(p, b, sided, moves);
}

bool Wl4Control::allowed(const CycleGeometry& cycle, const ContourAllowance& allowance, PlaneContour& out) {
  bool fits = true;
  Result<PlaneContour> contour =
      offsetContour(cycle.contour, cycle.side * (cycle.nose + allowance.offset), fits);
  if (!contour) return fail("wl4-negative-radius", contour.error().message);
  if (!fits) {
    warnOnce(
        "fits", "wl4-contour",
        "tool and allowance do not fit into the contour everywhere: blocks are left out or come too near");
  }
  shiftContour(*contour, allowance.shift);
  out = std::move(*contour);
  return true;
}

bool Wl4Control::passes(const Plan& p, const Wl4Block& b, const CycleGeometry& cycle,
                        std::vector<ContourMove>& moves) {
  // In (u, v) = (Z, X).
  const double r = b.find('R').value_or(0.0);
  const Vec2 linear(b.find('K').value_or(0.0), b.find('I').value_or(0.0));
  const int depth_axis = p.deed == 78 ? 0 : 1;
  if (p.deed == 76) return approachPasses(b, cycle, moves);
  PlaneContour contour;
  if (!allowed(cycle, {r, linear}, contour)) return false;
  const Vec2 way = contour.front().from - cycle.contour.front().from;
  if (way[depth_axis] * (cycle.from - cycle.contour.front().from)[depth_axis] < 0.0) {
    warn("wl4-allowance", "the allowance lies on the side away from the tool: is it G41 for G42?");
  }
  if (!goesOneWay(contour, 1 - depth_axis)) {
    warn("wl4-monotone",
         fmt::format("the contour of G{} turns back along {}", p.deed, depth_axis == 1 ? "Z" : "X"));
  }
  if (!b.has('E')) {
    moves = finishingPass(contour, depth_axis, cycle.from);
    return true;
  }
  const double reach = std::abs(cycle.from[depth_axis]) + std::abs(contour.front().from[depth_axis]);
  if (reach / b.value('E') > kMostRoughingPasses) {
    return fail("wl4-contour",
                fmt::format("E{} makes more than {} passes", b.value('E'), kMostRoughingPasses));
  }
  moves = roughingPasses(contour, {depth_axis, cycle.from, b.value('E')});
  return true;
}

bool Wl4Control::approachPasses(const Wl4Block& b, const CycleGeometry& cycle,
                                std::vector<ContourMove>& moves) {
  const Vec2 linear(b.find('K').value_or(0.0), b.find('I').value_or(0.0));
  const ContourAllowance finish{b.find('R').value_or(0.0), linear};
  ContourAllowance stock = finish;
  if (b.has('C')) {
    stock.offset = b.value('C');
  } else if (b.has('E')) {
    stock.shift = Vec2(b.find('W').value_or(0.0), b.find('U').value_or(0.0));
  }
  const double thickness = allowanceDepth(stock, finish), depth = b.find('E').value_or(1.0);
  if (b.has('E') && !(thickness > 0.0))
    return fail("wl4-contour", "the stock of G76 is not above the allowance");
  if (thickness / depth - 1e-9 > kMostRoughingPasses) return fail("wl4-contour", "E makes too many passes");
  for (const ContourAllowance& layer : contourLayers(stock, finish, depth)) {
    PlaneContour contour;
    if (!allowed(cycle, layer, contour)) return false;
    addApproachPass(contour, cycle.from, moves);
  }
  return true;
}

bool Wl4Control::runPasses(Plan& p, const Wl4Block& b, bool sided, const std::vector<ContourMove>& moves) {
  const AxisPoint from = machine_;
  const WorkPlane w(plane(p.next));
  // The contour is the way of the nose centre; the path is told of the working point.
  const Vec2 tip = sided ? tipOf(p.next) : Vec2(Vec2::Zero());
  const double modal_feed = p.next.feed;
  p.next.feed = b.find('F').value_or(modal_feed);
  p.named.set(static_cast<std::size_t>(w.u));
  p.named.set(static_cast<std::size_t>(w.v));
  const bool rapid_infeed = p.next.motion == 0;
  const ContourWords before = wordsInPlane(w);
  for (const ContourMove& pass : moves) {
    if (workOver()) return false;
    const Vec2 to = pass.element.to + tip;
    p.target = from;
    p.target[w.u] = to.x();
    p.target[w.v] = to.y();
    const int source = pass.element.source;
    recordPass(w, source >= 0 ? contour_words_[static_cast<std::size_t>(source)]
                  : pass.speed == ContourMove::Speed::kInfeed ? contour_start_
                                                              : before);
    PathItem item;
    item.kind = pass.element.arc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
    fill(p, item);
    item.feed.compensated = sided;
    item.rapid = pass.speed == ContourMove::Speed::kRapid ||
                 (pass.speed == ContourMove::Speed::kInfeed && rapid_infeed);
    item.center = Vec3(pass.element.center.x() + tip.x(), pass.element.center.y() + tip.y(), machine_[w.w]);
    item.sweep = pass.element.sweep;
    if (item.rapid ? false : !feedOf(p, item.feed)) return false;
    if (!send(p, item)) return false;
  }
  p.next.feed = modal_feed;
  p.target = machine_;
  return true;
}

bool Wl4Control::readContour(const Plan& p, PlaneContour& contour) {
  const Wl4Block cycle = block_;
  const Wl4State state = state_;
  const AxisPoint machine = machine_;
  const Level level = levels_.back();
  const Wl4Program& program = *level.program;
  const auto number = [&](char letter) { return std::llround(cycle.value(letter)); };
  const auto first = program.block(number('P')), last = program.block(number('Q'));
  if (!first || !last || *last < *first) {
    return fail("wl4-contour",
                fmt::format("there is no block N{} followed by N{}", number('P'), number('Q')));
  }
  if (*last - *first >= kMostContourBlocks) {
    return fail("wl4-contour", fmt::format("the contour has {} blocks: at most {} are allowed",
                                           *last - *first + 1, kMostContourBlocks));
  }
  // The start of the contour, then block by block as if they ran.
  bool good = true;
  const OriginRecorder::Slots words = origins_.slots();
  contour_words_.clear();
  state_ = p.next;
  for (const char letter : std::string_view("XZ")) {
    if (!cycle.has(letter)) continue;
    const int axis = letter == 'X' ? 0 : 2;
    const double value = cycle.value(letter) * (wantsDiameter(axis) ? 0.5 : 1.0);
    machine_[axis] = state_.offset(axis) + state_.sign(axis) * value;
    recordLetter(letter, axisKind(axes_.at(axis).name), false, false);
  }
  contour_start_ = wordsInPlane(WorkPlane(plane(state_)));
  std::vector<double> chamfers;
  for (std::size_t k = *first; good && k <= *last; ++k) {
    levels_.back().line = k;
    good = contourBlock(contour, chamfers);
  }
  if (good && cutChamfers(contour, chamfers) != CornerError::kNone)
    good = fail("wl4-chamfer", "a chamfer of the contour does not fit its blocks");
  if (good && contour.empty()) good = fail("wl4-contour", "the contour has no motion");
  origins_.restore(words, {});
  block_ = cycle;
  state_ = state;
  machine_ = machine;
  levels_.back() = level;
  beginBlock(block_.text);
  return good;
}

bool Wl4Control::contourBlock(PlaneContour& contour, std::vector<double>& chamfers) {
  const std::string_view line = levels_.back().program->line(levels_.back().line);
  beginBlock(line);
  if (!reader_.read(line, block_))
    return fail("wl4-syntax", reader_.error().message, reader_.error().columns);
  levels_.back().number = block_.number;
  for (const Wl4Block::Code& g : block_.g) {
    if (!allowedInContour(g.number)) {
      return fail("wl4-contour-code", fmt::format("forbidden code G{} in a contour", g.number), g.columns);
    }
  }
  if (block_.jump || block_.has('L') || line.find("IF") != std::string_view::npos) {
    return fail("wl4-contour-code", "IF, jumps and calls are not allowed in a contour");
  }
  Plan q;
  q.next = state_;
  q.target = machine_;
  for (const Wl4Block::Code& g : block_.g) planCode(q, *wl4GCode(g.number));
  if (!planAxes(q)) return false;
  recordAxes(q);
  tellPlainWords();
  const WorkPlane w(plane(q.next));
  ContourElement e;
  e.from = w.of(machine_).head<2>();
  e.to = w.of(q.target).head<2>();
  if (q.moves) {
    const int motion = q.next.motion;
    if (motion == 2 || motion == 3) {
      PlaneArc arc;
      bool moves = false;
      if (!arcOf(q, arc, moves)) return false;
      if (moves) e = {true, arc.start.head<2>(), arc.end.head<2>(), arc.center, arc.sweep_rad};
    } else if (motion == 12 || motion == 13) {
      if (!cornerOf(q, e.center, e.sweep)) return false;
      e.arc = true;
    }
    if (e.arc || (e.to - e.from).norm() > 1e-9) {
      e.source = static_cast<int>(contour_words_.size());
      contour_words_.push_back(recordContourBlock(w));
      contour.push_back(e);
      chamfers.push_back(q.chamfer);
    }
  }
  state_ = q.next;
  machine_ = q.target;
  return true;
}

}  // namespace proveout::nc
