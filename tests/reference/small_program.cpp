#include "tests/reference/small_program.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/soak/soak_case.h"
#include "tests/support/feed_motion.h"

namespace proveout::reference {

namespace {

using soak::Random;

constexpr int kToolKinds = 10;

Tool randomCutter(Random& random, int kind, int number) {
  Tool tool;
  tool.number = number;
  tool.diameter = random.number(4.0, 9.0);
  const double d = tool.diameter;
  switch (kind) {
    case 0:
      tool.type = ToolType::kFlat;
      break;
    case 1:
      tool.type = ToolType::kBall;
      break;
    case 2:
      tool.type = ToolType::kBull;
      tool.corner_radius = random.number(0.15, 0.4) * d;
      break;
    case 3:
      tool.type = ToolType::kCone;
      tool.tip_diameter = random.number(0.2, 0.5) * d;
      tool.cone_angle_deg = random.number(40, 100);
      break;
    case 4:
      tool.type = ToolType::kDrill;
      tool.point_angle_deg = random.number(90, 150);
      break;
    case 5:
      tool.type = ToolType::kTaperBall;
      tool.tip_diameter = random.number(0.4, 0.7) * d;
      tool.cone_angle_deg = random.number(10, 50);
      break;
    case 6:
      tool.type = ToolType::kTSlot;
      tool.cutter_height = random.number(0.3, 0.5) * d;
      tool.neck_diameter = 0.4 * d;
      tool.corner_radius = random.chance(0.5) ? 0.0 : 0.3 * tool.cutter_height;
      break;
    case 7:
      tool.type = ToolType::kLollipop;
      tool.neck_diameter = 0.5 * d;
      break;
    case 8:
      tool.type = ToolType::kThreadMill;
      tool.teeth = random.whole(1, 2);
      tool.pitch = random.number(0.3, 0.45) * d;
      tool.crest_flat = 0.2 * tool.pitch;
      tool.root_diameter = d - 0.7 * tool.pitch / std::tan(degToRad(30.0));
      break;
    default:
      tool.type = ToolType::kDovetail;
      tool.dovetail_angle_deg = random.number(45, 75);
      tool.cutter_height = 0.35 * d;
      tool.neck_diameter = 0.2 * d;
  }
  return tool;
}

/// On slopes rims leave tracks that are not promised (docs/decisions/020-one-integral.md).
bool hasRim(ToolType type) {
  return type != ToolType::kBall && type != ToolType::kBull && type != ToolType::kTaperBall &&
         type != ToolType::kLollipop;
}

class Writer {
 public:
  Writer(Random& random, SmallProgram& out) : random_(random), out_(out) {}

  void cut(const Tool& tool, int motions) {
    tool_ = &tool;
    at_ = {random_.number(4, 20), random_.number(4, 14), 2.0};
    if (random_.chance(0.3)) {
      at_.x() = -tool.diameter;  // from outside
      at_.z() = depth();
    } else {
      lineTo({at_.x(), at_.y(), depth()});
    }
    for (int i = 0; i < motions; ++i) motion();
  }

 private:
  double depth() { return -random_.number(0.4, 4.5); }

  void motion() {
    const int style = random_.whole(0, 9);
    if (style <= 3) return lineTo({random_.number(2, 22), random_.number(2, 16), at_.z()});
    if (style <= 5) {
      const Vec3 to(random_.number(2, 22), random_.number(2, 16), depth());
      return lineTo({to.x(), to.y(), hasRim(tool_->type) ? at_.z() : to.z()});
    }
    if (style == 6) return lineTo({at_.x(), at_.y(), depth()});
    arc();
  }

  void add(const Vec3& to, const ArcGeometry* arc) {
    Motion m = test::feedMotion(at_, to);
    m.tool = tool_->number;
    m.source.line = static_cast<int>(out_.path.motions.size()) + 1;
    if (arc != nullptr) {
      m.arc = static_cast<std::int32_t>(out_.path.arcs.size());
      out_.path.arcs.push_back(*arc);
    }
    out_.path.motions.push_back(m);
    at_ = to;
  }
  void lineTo(const Vec3& to) { add(to, nullptr); }

  void arc() {
    const double radius = tool_->diameter * random_.number(0.55, 1.2), out = random_.number(0, 2 * kPi);
    ArcGeometry arc;
    arc.center = at_ - radius * Vec3(std::cos(out), std::sin(out), 0.0);
    arc.sweep_rad = random_.chance(0.3) ? 2 * kPi : random_.number(0.4, 5.0);
    if (random_.chance(0.5)) arc.sweep_rad = -arc.sweep_rad;
    const Eigen::AngleAxisd turn(arc.sweep_rad, Vec3::UnitZ());
    const bool full = std::abs(arc.sweep_rad) == 2 * kPi;
    add(full ? at_ : Vec3(arc.center + turn * (at_ - arc.center)), &arc);
  }

  Random& random_;
  SmallProgram& out_;
  const Tool* tool_ = nullptr;
  Vec3 at_ = Vec3::Zero();
};

}  // namespace

SmallProgram smallProgram(std::uint64_t seed) {
  Random random(seed);
  SmallProgram out;
  out.block = {{random.number(-0.2, 0.2), random.number(-0.2, 0.2), -8.0 + random.number(-0.2, 0.2)},
               {24.0 + random.number(-0.2, 0.2), 18.0 + random.number(-0.2, 0.2), 0.0}};
  out.path.files = {"reference"};
  const int tools = random.chance(0.4) ? 2 : 1;
  for (int i = 0; i < tools; ++i) {
    const int kind = i == 0 ? static_cast<int>(seed % kToolKinds) : random.whole(0, kToolKinds - 1);
    out.tools.push_back(randomCutter(random, kind, i + 1));
  }
  Writer writer(random, out);
  for (const Tool& tool : out.tools) writer.cut(tool, random.whole(1, tools == 1 ? 3 : 2));
  return out;
}

std::string describe(const SmallProgram& program) {
  const auto& b = program.block;
  std::string text = fmt::format("stock box:{},{},{}:{},{},{}\n", b.min.x(), b.min.y(), b.min.z(), b.max.x(),
                                 b.max.y(), b.max.z());
  for (const Tool& t : program.tools) text += fmt::format("tool {}: {}\n", t.number, describe(t));
  for (const Motion& m : program.path.motions) {
    text += fmt::format("T{} X{:.6f} Y{:.6f} Z{:.6f} to X{:.6f} Y{:.6f} Z{:.6f}", m.tool, m.from.x(),
                        m.from.y(), m.from.z(), m.to.x(), m.to.y(), m.to.z());
    if (m.arc >= 0) {
      const ArcGeometry& arc = program.path.arcs[static_cast<std::size_t>(m.arc)];
      text += fmt::format(" about X{:.6f} Y{:.6f} by {:.6f} deg", arc.center.x(), arc.center.y(),
                          radToDeg(arc.sweep_rad));
    }
    text += "\n";
  }
  return text;
}

}  // namespace proveout::reference
