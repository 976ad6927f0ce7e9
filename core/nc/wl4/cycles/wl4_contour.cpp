#include "core/nc/wl4/cycles/wl4_contour.h"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

#include "core/nc/wl4/wl4_arcs.h"
#include "core/nc/wl4/wl4_axis_words.h"
#include "core/nc/wl4/wl4_plan.h"

namespace proveout::nc {

namespace {

constexpr std::size_t kMostContourBlocks = 200;

bool allowedInContour(int g) {
  return (g >= 0 && g <= 3) || g == 12 || g == 13 || (g >= 40 && g <= 42) || g == 90 || g == 91;
}

/// Lines from the first to the last block.
bool findBlocks(Wl4Context& c, std::size_t& first, std::size_t& last) {
  const Wl4Program& program = *c.levels.back().program;
  const auto from = std::llround(c.block.value('P')), to = std::llround(c.block.value('Q'));
  const auto begin = program.block(from), end = program.block(to);
  if (!begin || !end || *end < *begin)
    return c.report.fail("wl4-contour", fmt::format("there is no block N{} followed by N{}", from, to));
  if (*end - *begin >= kMostContourBlocks) {
    return c.report.fail("wl4-contour", fmt::format("the contour has {} blocks: at most {} are allowed",
                                                    *end - *begin + 1, kMostContourBlocks));
  }
  first = *begin;
  last = *end;
  return true;
}

/// What the contour's blocks change, for the cycle to find it as it was.
class Aside {
 public:
  explicit Aside(Wl4Context& c)
      : c_(c),
        block_(c.block),
        state_(c.state),
        machine_(c.machine),
        level_(c.levels.back()),
        words_(c.recorder.slots()) {}
  void restore() {
    c_.recorder.restore(words_, {});
    c_.block = block_;
    c_.state = state_;
    c_.machine = machine_;
    c_.levels.back() = level_;
    c_.origins.beginBlock(c_.block.text);
  }

 private:
  Wl4Context& c_;
  const Wl4Block block_;
  const Wl4State state_;
  const AxisPoint machine_;
  const Wl4Level level_;
  const OriginRecorder::Slots words_;
};

/// X and Z of the cycle's block.
void goToStart(Wl4Context& c) {
  for (const char letter : std::string_view("XZ")) {
    if (!c.block.has(letter)) continue;
    const int axis = letter == 'X' ? 0 : 2;
    const double value = c.block.value(letter) * (c.setup.wantsDiameter(axis) ? 0.5 : 1.0);
    c.machine[axis] = c.state.offset(axis) + c.state.sign(axis) * value;
    c.origins.recordStart(letter, axisKind(c.setup.axes.at(axis).name));
  }
}

/// The block on the line of the innermost level.
bool readBlock(Wl4Context& c) {
  const std::string_view line = c.levels.back().program->line(c.levels.back().block);
  c.origins.beginBlock(line);
  if (!c.reader.read(line, c.block))
    return c.report.fail("wl4-syntax", c.reader.error().message, c.reader.error().columns);
  c.levels.back().number = c.block.number;
  for (const Wl4Block::Code& g : c.block.g) {
    if (!allowedInContour(g.number)) {
      return c.report.fail("wl4-contour-code", fmt::format("forbidden code G{} in a contour", g.number),
                           g.columns);
    }
  }
  if (c.block.jump || c.block.has('L') || line.find("IF") != std::string_view::npos)
    return c.report.fail("wl4-contour-code", "IF, jumps and calls are not allowed in a contour");
  return true;
}

/// What the block moves along; of no length where it moves nothing in the plane.
bool elementOf(Wl4Context& c, const Wl4BlockPlan& q, const WorkPlane& plane, ContourElement& e) {
  e = lineElement(plane.of(c.machine).head<2>(), plane.of(q.target).head<2>());
  const int motion = q.next.motion;
  if (!q.moves) {
    e.to = e.from;
  } else if (motion == 2 || motion == 3) {
    PlaneArc arc;
    bool moves = false;
    if (!resolveBlockArc(c, q, arc, moves)) return false;
    if (moves) e = arcElement(arc.center, arc.start.head<2>(), arc.end.head<2>(), arc.sweep_rad);
  } else if (motion == 12 || motion == 13) {
    if (!resolveQuarter(c, q, e.center, e.sweep)) return false;
    e.arc = true;
  }
  return true;
}

bool addBlock(Wl4Context& c, Wl4BlockContour& contour, std::vector<double>& chamfers) {
  if (!readBlock(c)) return false;
  Wl4BlockPlan q;
  q.next = c.state;
  q.target = c.machine;
  for (const Wl4Block::Code& g : c.block.g) selectCode(q, *wl4GCode(g.number));
  if (!planPositions(c, q)) return false;
  c.origins.recordContourAxes(q);
  const WorkPlane plane(q.next.frame());
  ContourElement e;
  if (!elementOf(c, q, plane, e)) return false;
  if (e.arc || (e.to - e.from).norm() > 1e-9) {
    e.source = static_cast<int>(contour.words.size());
    contour.words.push_back(c.origins.recordContourBlock(plane));
    contour.elements.push_back(e);
    chamfers.push_back(q.chamfer);
  }
  c.state = q.next;
  c.machine = q.target;
  return true;
}

bool readBlocks(Wl4Context& c, std::size_t first, std::size_t last, Wl4BlockContour& contour) {
  std::vector<double> chamfers;
  for (std::size_t k = first; k <= last; ++k) {
    c.levels.back().block = k;
    if (!addBlock(c, contour, chamfers)) return false;
  }
  if (cutChamfers(contour.elements, chamfers) != CornerError::kNone)
    return c.report.fail("wl4-chamfer", "a chamfer of the contour does not fit its blocks");
  return !contour.elements.empty() || c.report.fail("wl4-contour", "the contour has no motion");
}

}  // namespace

bool readContour(Wl4Context& c, const Wl4BlockPlan& p, Wl4BlockContour& contour) {
  std::size_t first = 0, last = 0;
  if (!findBlocks(c, first, last)) return false;
  Aside aside(c);
  c.state = p.next;
  goToStart(c);
  contour.start = c.origins.wordsInPlane(WorkPlane(c.state.frame()));
  const bool good = readBlocks(c, first, last, contour);
  aside.restore();
  return good;
}

}  // namespace proveout::nc
