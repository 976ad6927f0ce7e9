#include "tests/soak/second/moved.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout::soak::second {
namespace {

using Kind = Step::Kind;

bool isPlace(const Step& s) {
  return s.kind == Kind::kRapid || s.kind == Kind::kLine || s.kind == Kind::kArc || s.kind == Kind::kHole ||
         s.kind == Kind::kWeave || s.kind == Kind::kCut;
}

Step movedStep(Step s, const Move& move) {
  const double up = move.shift.z();
  s.to = move(s.to);
  s.center = move(s.center);
  s.stride = move.turn * s.stride;
  s.level += s.kind == Kind::kHole ? up : 0;
  if (move.turn.determinant() > 0) return s;
  s.sense = -s.sense;
  if (s.kind == Kind::kSide && s.number != 40) s.number = 83 - s.number;
  if (s.kind == Kind::kLean && s.number != 50) s.number = 103 - s.number;
  return s;
}

/// An end of a round solid that lies along an axis before and after.
void moveRound(Solid& solid, const Move& move) {
  Spot along = Spot::Zero();
  along[solid.axis] = solid.length;
  const Spot one = move(solid.base), other = move(solid.base + along), way = other - one;
  way.cwiseAbs().maxCoeff(&solid.axis);
  solid.base = way[solid.axis] > 0 ? one : other;
}

Solid movedSolid(Solid solid, const Move& move) {
  if (solid.shape == Solid::Shape::kRound) {
    moveRound(solid, move);
  } else if (solid.shape == Solid::Shape::kBox) {
    const Spot a = move(solid.min), b = move(solid.max);
    solid.min = a.cwiseMin(b);
    solid.max = a.cwiseMax(b);
  } else {
    for (Spot& p : solid.points) p = move(p);
    if (move.turn.determinant() < 0)
      for (auto& face : solid.faces) std::swap(face[0], face[1]);
  }
  return solid;
}

void moveSteps(Clamping& c, const Move& move) {
  const bool cycles =
      std::any_of(c.steps.begin(), c.steps.end(), [](const Step& s) { return s.kind == Kind::kWords; });
  c.bottom += move.shift.z();
  if (turns(c.control) && cycles) {
    // Cycles of a lathe say depths, not places: its zero goes along.
    c.parameters += "g52_mode = \"shift\"\n";
    Step zero;
    zero.kind = Kind::kWords;
    zero.words = fmt::format("G52X0Z{:.6f}", move.shift.z());
    c.steps.insert(c.steps.begin(), zero);
    return;
  }
  for (Step& s : c.steps) s = movedStep(s, move);
}

/// The middle of a part of an arc that its radius can say: of a circle the other side, else by angle.
Spot middleOfArc(const Spot& from, const Step& arc, bool level_y) {
  const int v = level_y ? 2 : 1;  // lathes: X and Z
  const double x0 = from.x() - arc.center.x(), y0 = from[v] - arc.center[v];
  const double x1 = arc.to.x() - arc.center.x(), y1 = arc.to[v] - arc.center[v];
  double sweep = std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1) * arc.sense;
  if (sweep < 1e-9) sweep += 2 * std::numbers::pi;
  Spot middle = 0.5 * (from + arc.to);
  const double half = 0.5 * sweep * arc.sense, c = std::cos(half), s = std::sin(half);
  const bool whole = std::abs(sweep - 2 * std::numbers::pi) < 1e-9;
  middle.x() = arc.center.x() + (whole ? -x0 : x0 * c - y0 * s);
  middle[v] = arc.center[v] + (whole ? -y0 : x0 * s + y0 * c);
  return middle;
}

void splitStep(const Spot& at, const Step& s, const Clamping& c, std::vector<Step>& out) {
  Step first = s;
  first.round = 0;
  if (s.kind == Kind::kArc) {
    first.to = middleOfArc(at, s, turns(c.control));
    // What a wire's program says are micrometres: only arcs whose middles are such can be parted.
    const Spot um = 1000 * first.to;
    if (c.control != Control::kWedm || (um - um.array().round().matrix()).norm() < 1e-6) out.push_back(first);
  } else if ((s.to - at).norm() > 0.01) {
    first.to = 0.5 * (at + s.to);
    out.push_back(first);
  }
  out.push_back(s);
}

std::vector<Step> unrolled(const Step& weave) {
  std::vector<Step> lines;
  for (int k = 0; k < weave.number; ++k) {
    for (const Spot& from : {weave.to, weave.center}) {
      Step line;
      line.to = from + k * weave.stride;
      lines.push_back(line);
    }
  }
  return lines;
}

Clamping splitClamping(Clamping c) {
  std::vector<Step> plain, out;
  for (const Step& s : c.steps) {
    const std::vector<Step> lines = s.kind == Kind::kWeave ? unrolled(s) : std::vector<Step>{s};
    plain.insert(plain.end(), lines.begin(), lines.end());
  }
  Spot at = Spot::Zero();
  bool known = false;  // where it is
  bool joins =
      false;  // one motion has to stay one: behind a word, or where a rounded corner needs its length
  for (const Step& s : plain) {
    const bool motion = s.kind == Kind::kRapid || s.kind == Kind::kLine || s.kind == Kind::kArc;
    const bool wire_rapid = c.control == Control::kWedm && s.kind == Kind::kRapid;
    if (motion && known && !joins && !wire_rapid && s.round == 0) {
      splitStep(at, s, c, out);
    } else {
      out.push_back(s);
    }
    if (s.kind == Kind::kSide || s.kind == Kind::kLean) joins = true;
    if (motion) joins = s.round > 0;
    if (s.kind == Kind::kHole) at.head<2>() = s.to.head<2>();
    if (isPlace(s) && s.kind != Kind::kHole) at = s.to;
    if (s.kind == Kind::kTool || s.kind == Kind::kWords) known = false;
    if (isPlace(s) && s.kind != Kind::kHole) known = true;
  }
  c.steps = out;
  return c;
}

Step wordsStep(const std::string& words) {
  Step s;
  s.kind = Kind::kWords;
  s.words = words;
  return s;
}

Step toolStep() {
  Step s;
  s.kind = Kind::kTool;
  s.number = 1;
  return s;
}

Step to(Kind kind, const Spot& place) {
  Step s;
  s.kind = kind;
  s.to = place;
  return s;
}

std::string idleTool(Control control) {
  if (control == Control::kWedm) return "[[@tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.2\n";
  if (!turns(control)) return "[[@tool]]\nnumber = 1\ntype = \"ball\"\ndiameter = 2.6\n";
  return "[[@tool]]\nnumber = 1\ntype = \"insert\"\nnose_radius = 0.3\norientation = 3\ninsert_angle = 55\n"
         "lead_angle = 93\nedge_length = 6\n";
}

/// Beside the workpiece: in feed where it is a wire or the dice say so.
void idleSteps(Clamping& c, const Eigen::AlignedBox3d& around, Dice& dice) {
  const Spot top = around.max() + Spot(7, 7, 7);
  if (c.control == Control::kWedm) {
    c.steps = {to(Kind::kRapid, top), to(Kind::kLine, {top.x(), around.min().y(), 0})};
    return;
  }
  c.steps = {toolStep(), to(Kind::kRapid, top)};
  if (turns(c.control)) c.steps[1].to.x() = std::max(top.x(), top.y());
  const bool feeds = dice.oneIn(2);
  Spot next = c.steps[1].to;
  next.z() += 3;
  c.steps.push_back(to(feeds ? Kind::kLine : Kind::kRapid, next));
  if (c.control == Control::kNct && dice.oneIn(3)) c.steps.push_back(wordsStep("G4 P0.5"));
}

/// Where the blank is in a clamping in front of the k-th, `last` the move into it.
Eigen::AlignedBox3d boundsAt(const Plan& plan, std::size_t k, const Move& last) {
  Eigen::AlignedBox3d around = plan.blank.bounds();
  for (std::size_t i = 1; i <= k; ++i) around = movedBounds(around, i < k ? plan.clampings[i].move : last);
  return around;
}

}  // namespace

Move turnedBy(double about_x_deg, double about_z_deg) {
  const auto exact = [](double deg) -> Eigen::Vector2d {
    const double quarters = deg / 90, w = deg * std::numbers::pi / 180;
    if (quarters != std::round(quarters)) return {std::cos(w), std::sin(w)};
    constexpr int kCos[] = {1, 0, -1, 0};
    const int n = (static_cast<int>(quarters) % 4 + 4) % 4;
    return {kCos[n], kCos[(n + 3) % 4]};
  };
  const Eigen::Vector2d x = exact(about_x_deg), z = exact(about_z_deg);
  Eigen::Matrix3d about_x, about_z;
  about_x << 1, 0, 0, 0, x.x(), -x.y(), 0, x.y(), x.x();
  about_z << z.x(), -z.y(), 0, z.y(), z.x(), 0, 0, 0, 1;
  return {about_z * about_x, Spot::Zero()};
}

Eigen::AlignedBox3d movedBounds(const Eigen::AlignedBox3d& box, const Move& move) {
  Eigen::AlignedBox3d out;
  for (int corner = 0; corner < 8; ++corner)
    out.extend(move(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  return out;
}

Plan moved(const Plan& plan, std::size_t k, const Move& move) {
  Plan out = plan;
  Clamping& c = out.clampings[k];
  moveSteps(c, move);
  for (Solid& fixture : c.fixtures) fixture = movedSolid(fixture, move);
  if (k > 0) {
    c.move = move * c.move;
  } else {
    out.blank = movedSolid(plan.blank, move);
    for (StartHole& hole : out.start_holes) hole.at = move(hole.at);
  }
  if (k + 1 < out.clampings.size()) out.clampings[k + 1].move = plan.clampings[k + 1].move * move.inverse();
  return out;
}

Plan mirrored(const Plan& plan) {
  Move mirror;
  mirror.turn(0, 0) = -1;
  return moved(plan, 0, mirror);
}

bool canTurnFreely(const Plan& plan) {
  const Clamping& first = plan.clampings.front();
  const bool any = plan.blank.shape == Solid::Shape::kMesh ||
                   (plan.blank.shape == Solid::Shape::kRound && plan.blank.axis == 2);
  return any && mills(first.control) && first.fixtures.empty() && plan.clampings.size() == 1;
}

Plan split(const Plan& plan) {
  Plan out = plan;
  for (Clamping& c : out.clampings) c = splitClamping(c);
  return out;
}

Plan withIdle(const Plan& plan, std::size_t k, Control control, const Move& move, Dice& dice) {
  Plan out = plan;
  out.plain = false;
  Clamping idle;
  idle.control = control;
  idle.idle = true;
  idle.tools = idleTool(control);
  const Eigen::AlignedBox3d around = boundsAt(plan, k, move);
  idle.bottom = around.min().z();
  idle.height = around.sizes().z();
  idleSteps(idle, around, dice);
  if (k > 0) idle.move = move;
  if (k > 0 && k < plan.clampings.size()) out.clampings[k].move = plan.clampings[k].move * move.inverse();
  if (k == 0) out.clampings[0].move = Move{};
  out.clampings.insert(out.clampings.begin() + static_cast<std::ptrdiff_t>(k), idle);
  return out;
}

Plan finer(const Plan& plan) {
  Plan out = plan;
  out.grid *= 0.5;
  out.profile *= 0.5;
  return out;
}

}  // namespace proveout::soak::second
