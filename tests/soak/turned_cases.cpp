// Random turned jobs for the wl4-lathe control; X words are diameters. No threads: their parts are laws of
// their own.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/soak/soak_case.h"

namespace proveout::soak {
namespace {

/// A bar from Z -length to 1.
struct Bar {
  double radius = 0.0, bore = 0.0, length = 0.0;
};

std::string barToml(const Bar& bar) {
  std::string text =
      fmt::format("[stock]\nshape = \"{}\"\nbase = [0, 0, {:.4f}]\nlength = {:.4f}\nradius = {:.4f}\n",
                  bar.bore > 0 ? "tube" : "cylinder", -bar.length, bar.length + 1, bar.radius);
  if (bar.bore > 0) text += fmt::format("inner_radius = {:.4f}\n", bar.bore);
  return text;
}

std::string tools(Random& random, const Bar& bar) {
  const double nose = random.number(0.1, 1.2), ball = random.number(0.5, 4.0);
  const double edge = std::max(6.0, 3 * nose);
  std::string text = fmt::format(
      "[[tool]]\nnumber = 1\ntype = \"insert\"\nnose_radius = {:.3f}\norientation = 3\ninsert_angle = 55\n"
      "lead_angle = 93\nedge_length = {:.2f}\n",
      nose, edge);
  text += fmt::format(
      "[[tool]]\nnumber = 2\ntype = \"insert\"\nshape = \"groove\"\nwidth = {:.3f}\nnose_radius = {:.3f}\n"
      "orientation = 3\nedge_length = {:.2f}\nside_relief = 1\n",
      random.number(1.0, 4.0), random.chance(0.3) ? 0.0 : 0.2, bar.radius + 2);
  text += fmt::format(
      "[[tool]]\nnumber = 3\ntype = \"insert\"\nshape = \"round\"\nnose_radius = {:.3f}\norientation = 8\n",
      ball);
  text += fmt::format("[[tool]]\nnumber = 4\ntype = \"drill\"\ndiameter = {:.3f}\npoint_angle = {:.1f}\n",
                      random.number(0.2, 1.2) * bar.radius, random.number(90, 140));
  return text;
}

class ProgramWriter {
 public:
  ProgramWriter(Random& random, const Bar& bar) : random_(random), bar_(bar) {}

  Program write() {
    out_.add("G54 G90 G95");
    const int pieces = random_.whole(1, 5);
    for (int i = 0; i < pieces; ++i) piece();
    out_.add("M5");
    out_.add("M2");
    return std::move(out_);
  }

 private:
  void piece() {
    const int tool = random_.whole(1, 4);
    out_.add(fmt::format("T{} M6", tool));
    out_.add("G97 S800 M3");
    if (tool == 4) {
      out_.add("G0 X0 Z4");
      out_.add(fmt::format("G1 Z{:.4f} F0.1", -random_.number(0.1, 1.1) * bar_.length));
    } else {
      x_ = 2 * bar_.radius * random_.number(0.3, 1.1);
      z_ = random_.number(-bar_.length, 2);
      out_.add(fmt::format("G0 X{:.4f} Z{:.4f}", 2 * bar_.radius + 10, tool == 2 ? z_ : 4.0));
      if (tool != 2) out_.add(fmt::format("G0 X{:.4f}", x_));
      const int cuts = random_.whole(1, 5);
      for (int k = 0; k < cuts; ++k) cut(tool);
    }
    out_.stops.push_back(out_.lines);
    if (tool == 4) {
      out_.add("G0 Z6");
    } else {
      out_.add(fmt::format("G1 X{:.4f} F1", 2 * bar_.radius + 12));
      out_.add("G0 Z6");
    }
  }
  void cut(int tool) {
    if (random_.chance(0.3)) out_.stops.push_back(out_.lines);
    const double x = 2 * bar_.radius * random_.number(-0.02, 1.15), z = random_.number(-bar_.length, 1.5);
    const int style = random_.whole(0, 5);
    if (tool == 2 || style == 0) {
      out_.add(fmt::format("G1 X{:.4f} F0.1", x_ = x));
    } else if (style == 1) {
      out_.add(fmt::format("G1 Z{:.4f} F0.1", z_ = z));
    } else if (style == 2) {
      arc();
    } else if (style == 3) {  // a layer as thin as rounding leaves it
      out_.add(fmt::format("G1 X{:.4f} Z{:.4f} F0.1", x_ += random_.number(-0.01, 0.01),
                           z_ += random_.number(-1, 1)));
    } else {
      out_.add(fmt::format("G1 X{:.4f} Z{:.4f} F0.1", x_ = x, z_ = z));
    }
  }
  /// A quarter or less, with R larger than half of its chord.
  void arc() {
    const double dx = random_.number(-0.3, 0.3) * bar_.radius, dz = random_.number(-0.3, 0.3) * bar_.length;
    x_ = std::max(0.1, x_ + 2 * dx);
    z_ += dz;
    out_.add(fmt::format("G{} X{:.4f} Z{:.4f} R{:.4f} F0.1", random_.whole(2, 3), x_, z_,
                         (0.6 + random_.number(0, 2)) * std::hypot(dx, dz) + 0.01 + std::abs(dx)));
  }

  Random& random_;
  Bar bar_;
  double x_ = 0.0, z_ = 0.0;
  Program out_;
};

}  // namespace

void makeTurned(Random& random, SoakCase& out) {
  Bar bar;
  bar.radius = random.chance(0.2) ? random.number(0.4, 2) : random.number(3, 30);
  bar.length = random.chance(0.2) ? random.number(0.4, 3) : random.number(5, 60);
  if (random.chance(0.3)) bar.bore = bar.radius * random.number(0.1, 0.95);
  const std::string top = "schema = \"proveout.job/1\"\n[control]\nname = \"wl4-lathe\"\n";
  const std::string head = "schema = \"proveout.job/1\"\n", control = "[control]\nname = \"wl4-lathe\"\n";
  std::string rest = tools(random, bar);
  if (random.chance(0.5))
    rest += fmt::format("[simulation]\nprofile_resolution = {:g}\n", random.chance(0.5) ? 0.05 : 0.02);
  const std::string idle =
      fmt::format("G54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X{:.4f} Z6\nG1 Z-1 F0.2\nM2\n", 2 * bar.radius + 10);
  std::string job = head, stay = head;
  const int setups = out.kind == Kind::kLatheSetups ? 2 : 1;
  std::string clampings, idle_clampings;
  for (int k = 0; k < setups; ++k) {
    const Program program = ProgramWriter(random, bar).write();
    const std::string name = fmt::format("p{}.nc", k + 1), quiet = fmt::format("i{}.nc", k + 1);
    out.files[name] = program.text;
    out.files[quiet] = idle;
    out.stops = program.stops;
    if (setups == 1) {
      job += "program = \"" + name + "\"\n";
      stay += "program = \"" + quiet + "\"\n";
      continue;
    }
    out.last_setup = fmt::format("s{}", k + 1);
    std::string setup = fmt::format("[[setup]]\nname = \"{}\"\nprogram = \"", out.last_setup), transform;
    if (k > 0)
      transform = fmt::format("[setup.transform]\nrotate = [{}, 0, 0]\ntranslate = [0, 0, {:.4f}]\n",
                              random.chance(0.5) ? 180 : 0, random.number(-0.5, 0.5) * bar.length);
    clampings += setup + name + "\"\n" + transform;
    idle_clampings += setup + quiet + "\"\n" + transform;
  }
  out.files["job.toml"] = job + control + barToml(bar) + clampings + rest;
  out.files["idle.toml"] = stay + control + barToml(bar) + idle_clampings + rest;
}

}  // namespace proveout::soak
