#include "core/nc/wl4/cycles/wl4_cycles.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/nc/services/contour/contour_offset.h"
#include "core/nc/services/contour/contour_passes.h"
#include "core/nc/wl4/cycles/wl4_contour.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_output.h"
#include "core/nc/wl4/wl4_speeds.h"

namespace proveout::nc {

namespace {

struct CycleGeometry {
  Vec2 from;                    ///< A
  const PlaneContour& contour;  ///< as programmed
  double side;                  ///< +1: tool and allowance left of it in (u, v)
  double nose;                  ///< radius of the nose, where compensation is on
};

bool checkCycle(Wl4Context& c, const Wl4BlockPlan& p) {
  const Wl4Block& b = c.block;
  const auto refuse = [&](const char* why) { return c.report.fail("wl4-contour", why); };
  if (!c.setup.lathe) return refuse("G76 to G78 are cycles of the lathe");
  if (c.state.radius != 40) return refuse("compensation has to be off before G76 to G78: G40");
  if (!b.has('P') || !b.has('Q'))
    return refuse("P and Q are missing: the first and the last block of the contour");
  if (!b.hasCode(0) && !b.hasCode(1))
    return refuse("G0 or G1 is missing: it says how the tool goes to its passes");
  const bool equidistant = b.has('R'), sided = p.next.radius != 40, roughing = b.has('E');
  if (equidistant && !sided) return refuse("the allowance R needs G41 or G42");
  if (equidistant && (b.has('I') || b.has('K'))) return refuse("allowances are either I and K or R");
  if (roughing && !(b.value('E') > 0.0)) return refuse("the depth of cut E has to be above 0");
  const bool stock = b.has('U') || b.has('W') || b.has('C'), approaches = p.deed->code == 76;
  if (approaches && stock != roughing) return refuse("G76 needs the stock U, W or C together with E");
  if (!approaches && stock) return refuse("U, W and C belong to G76");
  return true;
}

/// What the block says stays on the contour, in (u, v) = (Z, X).
ContourAllowance finishOf(const Wl4Block& b) {
  return {b.find('R').value_or(0.0), Vec2(b.find('K').value_or(0.0), b.find('I').value_or(0.0))};
}

bool withAllowance(Wl4Context& c, const CycleGeometry& cycle, const ContourAllowance& allowance,
                   PlaneContour& out) {
  bool fits = true;
  Result<PlaneContour> contour =
      offsetContour(cycle.contour, cycle.side * (cycle.nose + allowance.offset), fits);
  if (!contour) return c.report.fail("wl4-negative-radius", contour.error().message);
  if (!fits) {
    c.report.warnOnce(
        "fits", "wl4-contour",
        "tool and allowance do not fit into the contour everywhere: blocks are left out or come too near");
  }
  shiftContour(*contour, allowance.shift);
  out = std::move(*contour);
  return true;
}

/// G76: along the contour, layer by layer.
bool approachPasses(Wl4Context& c, const CycleGeometry& cycle, std::vector<ContourMove>& moves) {
  const Wl4Block& b = c.block;
  const ContourAllowance finish = finishOf(b);
  ContourAllowance stock = finish;
  if (b.has('C')) {
    stock.offset = b.value('C');
  } else if (b.has('E')) {
    stock.shift = Vec2(b.find('W').value_or(0.0), b.find('U').value_or(0.0));
  }
  const double thickness = allowanceDepth(stock, finish), depth = b.find('E').value_or(1.0);
  if (b.has('E') && !(thickness > 0.0))
    return c.report.fail("wl4-contour", "the stock of G76 is not above the allowance");
  if (thickness / depth - 1e-9 > kMostRoughingPasses)
    return c.report.fail("wl4-contour", "E makes too many passes");
  for (const ContourAllowance& layer : contourLayers(stock, finish, depth)) {
    PlaneContour contour;
    if (!withAllowance(c, cycle, layer, contour)) return false;
    addApproachPass(contour, cycle.from, moves);
  }
  return true;
}

void warnOfContour(Wl4Context& c, int deed, int depth_axis, const CycleGeometry& cycle,
                   const PlaneContour& contour) {
  const Vec2 start = cycle.contour.front().from, way = contour.front().from - start;
  if (way[depth_axis] * (cycle.from - start)[depth_axis] < 0.0) {
    c.report.warn("wl4-allowance", "the allowance lies on the side away from the tool: is it G41 for G42?");
  }
  if (!goesOneWay(contour, 1 - depth_axis)) {
    c.report.warn("wl4-monotone",
                  fmt::format("the contour of G{} turns back along {}", deed, depth_axis == 1 ? "Z" : "X"));
  }
}

/// G77 and G78: parallel to an axis, or once along the contour.
bool axisPasses(Wl4Context& c, int deed, const CycleGeometry& cycle, std::vector<ContourMove>& moves) {
  const Wl4Block& b = c.block;
  const int depth_axis = deed == 78 ? 0 : 1;
  PlaneContour contour;
  if (!withAllowance(c, cycle, finishOf(b), contour)) return false;
  warnOfContour(c, deed, depth_axis, cycle, contour);
  if (!b.has('E')) {
    moves = finishingPass(contour, depth_axis, cycle.from);
    return true;
  }
  const double reach = std::abs(cycle.from[depth_axis]) + std::abs(contour.front().from[depth_axis]);
  if (reach / b.value('E') > kMostRoughingPasses) {
    return c.report.fail("wl4-contour",
                         fmt::format("E{} makes more than {} passes", b.value('E'), kMostRoughingPasses));
  }
  moves = roughingPasses(contour, {depth_axis, cycle.from, b.value('E')});
  return true;
}

/// Where the words of a pass were written: of what it cuts, of the contour's start, or those `before`.
const Wl4ContourWords& wordsOf(const ContourMove& pass, const Wl4BlockContour& contour,
                               const Wl4ContourWords& before) {
  const int source = pass.element.source;
  if (source >= 0) return contour.words[static_cast<std::size_t>(source)];
  return pass.speed == ContourMove::Speed::kInfeed ? contour.start : before;
}

/// `tip`: of the working point, which the path is told of, from the nose centre, whose way the passes are.
bool runPasses(Wl4Context& c, Wl4BlockPlan& p, const Vec2& tip, bool sided, const Wl4BlockContour& contour,
               const std::vector<ContourMove>& moves) {
  const AxisPoint from = c.machine;
  const WorkPlane w(p.next.frame());
  const double modal_feed = p.next.feed;
  p.next.feed = c.block.find('F').value_or(modal_feed);
  p.named.set(static_cast<std::size_t>(w.u));
  p.named.set(static_cast<std::size_t>(w.v));
  const bool rapid_infeed = p.next.motion == 0;
  const Wl4ContourWords before = c.origins.wordsInPlane(w);
  for (const ContourMove& pass : moves) {
    if (c.watch.workOver(flowPlace(c.levels))) return false;
    const Vec2 to = pass.element.to + tip, center = pass.element.center + tip;
    p.target = from;
    p.target[w.u] = to.x();
    p.target[w.v] = to.y();
    c.origins.recordPass(w, wordsOf(pass, contour, before));
    PathItem item = motionItem(c, p, pass.element.arc ? PathItem::Kind::kArc : PathItem::Kind::kLine);
    item.feed.compensated = sided;
    item.rapid = pass.speed == ContourMove::Speed::kRapid ||
                 (pass.speed == ContourMove::Speed::kInfeed && rapid_infeed);
    item.center = Vec3(center.x(), center.y(), c.machine[w.w]);
    item.sweep = pass.element.sweep;
    if (!item.rapid && !planFeed(c, p, item.feed)) return false;
    if (!sendMotion(c, p, item)) return false;
  }
  p.next.feed = modal_feed;
  p.target = c.machine;
  return true;
}

bool cutContour(Wl4Context& c, Wl4BlockPlan& p) {
  Wl4BlockContour contour;
  if (!readContour(c, p, contour)) return false;
  const bool sided = p.next.radius != 40;
  // Passes are the way of the nose centre, which stands off the working point all the time.
  const Vec2 tip = sided ? c.setup.tipOf(p.next) : Vec2(Vec2::Zero());
  const Vec2 from = WorkPlane(p.next.frame()).of(c.machine).head<2>() - tip;
  const double side = (p.next.radius == 41) != c.setup.flipped(p.next) ? 1.0 : -1.0;
  const CycleGeometry cycle{from, contour.elements, sided ? side : 1.0,
                            sided ? c.setup.compRadius(p.next) : 0.0};
  if (sided && cycle.nose < 0.0)
    return c.report.fail("wl4-contour", "the nose radius and the corrector D are negative together");
  std::vector<ContourMove> moves;
  const int deed = p.deed->code;
  if (!(deed == 76 ? approachPasses(c, cycle, moves) : axisPasses(c, deed, cycle, moves))) return false;
  p.next.radius = 40;
  return runPasses(c, p, tip, sided, contour, moves);
}

}  // namespace

bool performContourCycle(Wl4Context& c, Wl4BlockPlan& p) {
  if (!p.contour) return true;
  if (!checkCycle(c, p)) return false;
  const OriginRecorder::Slots words = c.recorder.slots();
  c.origins.recordContourCycle(p);
  const bool good = cutContour(c, p);
  c.recorder.restore(words, {});
  return good;
}

}  // namespace proveout::nc
