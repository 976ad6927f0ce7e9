#include <fmt/format.h>

#include "tests/study/cause_parts.h"

namespace proveout::study {
namespace {

/// What a seed decides. Lengths mm.
struct Plate {
  double width, depth, height;  // of the blank
  Vec3 zero, back_zero;         // of G54 and G55 in the machine
  double mill, bull, corner, drill, point, sink, bore;
  double pocket_x, pocket_y, pocket_w, pocket_d, pocket_z, pocket_r;
  double hole_x, hole_y, pitch, hole_z;
  int repeats;
  double groove_x, groove_y, groove_angle, groove_half, groove_z;
  double ball, arc_x, arc_y, arc_half, arc_r;
  double bore_x, bore_y, bore_r, bore_z;
  bool comp_right, repeat_by_l;

  explicit Plate(std::uint32_t seed) {
    std::mt19937 random(seed * 2654435761U + 17U);
    const auto in = [&](double least, double most, double step) { return stepped(random, least, most, step); };
    width = in(90, 120, 1), depth = in(60, 80, 1), height = in(16, 24, 1);
    zero = {in(100, 400, 0.01), in(-300, -100, 0.01), in(-400, -200, 0.01)};
    back_zero = {in(100, 400, 0.01), in(-300, -100, 0.01), in(-400, -200, 0.01)};
    mill = in(6, 10, 2), bull = in(6, 8, 1), corner = in(0.5, 1.5, 0.5), drill = in(3, 5, 0.5);
    point = in(0, 1, 1) == 0 ? 118 : 140;
    sink = in(0, 1, 1) == 0 ? 90 : 60;
    bore = in(5, 8, 1);
    // The left half: pocket below, holes in a row above. The right half: groove below, arc above.
    pocket_w = in(24, 34, 1), pocket_d = in(18, 24, 1), pocket_z = -in(3, 6, 0.5);
    pocket_x = in(5, 8, 0.5), pocket_y = in(5, 8, 0.5), pocket_r = mill / 2 + in(0.5, 1.5, 0.5);
    repeats = static_cast<int>(in(2, 3, 1));
    pitch = in(8, 10, 0.5), hole_x = in(6, 8, 0.5), hole_y = depth - in(8, 12, 0.5), hole_z = -in(6, 9, 0.5);
    groove_half = in(6, 9, 0.5), groove_angle = in(10, 70, 5), groove_z = -in(1.5, 3, 0.5);
    groove_x = width - in(22, 26, 0.5), groove_y = in(18, 22, 0.5);
    ball = in(4, 8, 2), arc_half = in(6, 9, 0.5), arc_r = arc_half + in(3, 8, 0.5);
    arc_x = width - in(20, 26, 0.5), arc_y = depth - in(10, 14, 0.5);
    bore_r = in(8, 11, 0.5), bore_x = in(30, 60, 0.5), bore_y = in(24, 34, 0.5), bore_z = -in(2, 4, 0.5);
    comp_right = random() % 2 == 0;
    repeat_by_l = random() % 2 == 0;
  }
};

class Top {
 public:
  Top(const Plate& plate, const Plan& plan) : p(plate), w(plan), plan_(plan) {}

  const Writer& write() {
    w.block("G21 G17 G90 G40 G49 G69 G80 G94");
    pocket();
    holes();
    sinks();
    groove();
    arc();
    w.block("G0 Z100 M5");
    w.block("M30");
    return w;
  }

 private:
  void tool(int number, const std::string& spindle, double x, double y) {
    w.block(fmt::format("T{} M6", number));
    w.put("S3000").text(spindle, "M3").end();
    w.text("zero", "G54").put(fmt::format("G0 X{:g} Y{:g}", x, y)).end();
    w.block(fmt::format("G43 H{} Z20", number));
  }

  /// Once around inside, from the middle, against the clock or with it.
  void pocket() {
    const double x0 = p.pocket_x, y0 = p.pocket_y, x1 = x0 + p.pocket_w, y1 = y0 + p.pocket_d, r = p.pocket_r;
    const double xm = x0 + p.pocket_w / 2, ym = y0 + p.pocket_d / 2;
    tool(1, "pocket_m3", xm, ym);
    w.block("G0 Z2");
    w.put("G1").word("Z", "pocket_z", p.pocket_z).put("F300").end();
    const double step = std::max(0.5, p.pocket_d / 2 - p.mill * 0.9);
    for (const double y : {ym - step, ym + step}) {  // the middle is emptied without compensation
      w.block(fmt::format("G1 Y{:g} F600", y));
      w.block(fmt::format("X{:g}", x1 - p.mill));
      w.block(fmt::format("X{:g}", x0 + p.mill));
      w.block(fmt::format("X{:g}", xm));
    }
    w.block(fmt::format("Y{:g}", ym));
    const bool cw = p.comp_right;
    w.text("pocket_side", cw ? "G42" : "G41")
        .text("pocket_d", "D1")
        .word("X", "pocket_start", xm)
        .put(fmt::format("Y{:g} F600", y0))
        .end();
    const std::string turn = cw ? "G2" : "G3";
    const auto corner = [&](const std::string& name, double x, double y) {
      w.text(name, turn).put(fmt::format("X{:g} Y{:g} R{:g}", x, y, r)).end();
    };
    if (!cw) {
      w.put("G1").word("X", "pocket_x1", x1 - r).end();
      corner("corner_1", x1, y0 + r);
      w.put("G1").word("Y", "pocket_y1", y1 - r).end();
      corner("corner_2", x1 - r, y1);
      w.block(fmt::format("G1 X{:g}", x0 + r));
      corner("corner_3", x0, y1 - r);
      w.block(fmt::format("G1 Y{:g}", y0 + r));
      corner("corner_4", x0 + r, y0);
    } else {
      w.put("G1").word("X", "pocket_x1", x0 + r).end();
      corner("corner_1", x0, y0 + r);
      w.put("G1").word("Y", "pocket_y1", y1 - r).end();
      corner("corner_2", x0 + r, y1);
      w.block(fmt::format("G1 X{:g}", x1 - r));
      corner("corner_3", x1, y1 - r);
      w.block(fmt::format("G1 Y{:g}", y0 + r));
      corner("corner_4", x1 - r, y0);
    }
    w.block(fmt::format("G1 X{:g}", xm));
    w.block(fmt::format("G40 X{:g} Y{:g}", xm, ym));
    w.block("G0 Z50");
  }

  void holes() {
    tool(2, "hole_m3", p.hole_x, p.hole_y);
    w.text("hole_level", "G99").put("G81").word("Z", "hole_z", p.hole_z).put("R2 F200").end();
    w.text("hole_step", "G91")
        .word("X", "hole_pitch", p.pitch)
        .put("L" + Writer::number(plan_.of("hole_l", p.repeats)))
        .end();
    w.block("G90 G80");
    w.block("G0 Z50");
  }

  void sinks() {
    tool(4, "sink_m3", p.hole_x, p.hole_y);
    w.put("G99 G81")
        .word("Z", "sink_z", -(p.drill / 2 + 0.8) / std::tan(degToRad(p.sink / 2)))
        .put("R2 F200")
        .end();
    w.block(fmt::format("X{:g}", p.hole_x + p.pitch));
    w.block("G80");
    w.block("G0 Z50");
  }

  void groove() {
    tool(3, "groove_m3", p.groove_x, p.groove_y);
    w.text("turn", "G68")
        .word("X", "turn_x", p.groove_x)
        .word("Y", "turn_y", p.groove_y)
        .word("R", "turn_r", p.groove_angle)
        .end();
    w.block(fmt::format("G0 X{:g} Y{:g}", p.groove_x - p.groove_half, p.groove_y));
    w.block("G0 Z2");
    w.put("G1").word("Z", "groove_z", p.groove_z).put("F200").end();
    w.put("G1").word("X", "groove_x", p.groove_x + p.groove_half).put("F500").end();
    w.block("G0 Z50");
    w.text("unturn", "G69").end();
  }

  /// A ball sinks along an arc and comes up again.
  void arc() {
    tool(5, "arc_m3", p.arc_x - p.arc_half, p.arc_y);
    w.block("G0 Z2");
    w.block("G1 Z0 F200");
    w.text("plane", "G18")
        .text("arc_turn", "G2")
        .put(fmt::format("X{:g} Z0", p.arc_x + p.arc_half))
        .word("R", "arc_r", p.arc_r)
        .put("F300")
        .end();
    w.block("G17 G0 Z50");
  }

  const Plate& p;
  Writer w;
  const Plan& plan_;
};

class Back {
 public:
  Back(const Plate& plate, const Plan& plan) : p(plate), w(plan) {}
  const Writer& write() {
    w.block("G21 G17 G90 G40 G49 G80 G94");
    w.block("T6 M6");
    w.put("S2500").text("bore_m3", "M3").end();
    w.text("zero", "G55").put(fmt::format("G0 X{:g} Y{:g}", p.bore_x, p.bore_y)).end();
    w.block("G43 H6 Z5");
    w.put("G1").word("Z", "bore_z", p.bore_z).put("F150").end();
    const double r = p.bore_r - p.bore / 2;
    if (r > p.bore * 0.9) {
      w.block(fmt::format("G1 X{:g} F400", p.bore_x + r / 2));
      w.block(fmt::format("G3 I{:g}", -r / 2));
    }
    w.put("G1").word("X", "bore_x", p.bore_x + r).put("F400").end();
    w.text("bore_turn", "G3").word("I", "bore_i", -r).end();
    w.block(fmt::format("G1 X{:g}", p.bore_x));
    w.block("G0 Z50 M5");
    w.block("M30");
    return w;
  }

 private:
  const Plate& p;
  Writer w;
};

class PlateJob {
 public:
  PlateJob(const Plate& plate, const Plan& plan) : p(plate), plan_(plan) {}

  std::string write() {
    out_ = "schema = \"proveout.job/1\"\nname = \"plate\"\ncontrol = \"nct\"\n[stock]\nshape = \"box\"\n";
    out_ += fmt::format("min = [0, 0, {:g}]\nmax = [{:g}, {:g}, 0]\n", -p.height, p.width, p.depth);
    out_ += "[simulation]\nresolution = 0.4\n";
    out_ += "[nominal]\nmesh = \"nominal.stl\"\ngouge = 0.05\nexcess = 0.05\n";
    tool(1, "flat", {{"diameter", p.mill}});
    tool(2, "drill", {{"diameter", p.drill}, {"point_angle", p.point}});
    tool(3, "bull", {{"diameter", p.bull}, {"corner_radius", p.corner}});
    tool(4, "cone", {{"diameter", 12}, {"tip_diameter", 0}, {"cone_angle", p.sink}});
    tool(5, "ball", {{"diameter", p.ball}});
    tool(6, "flat", {{"diameter", p.bore}});
    setup("top", "G54", p.zero, {1, 2, 3, 4, 5});
    setup("back", "G55", p.back_zero, {6});
    const double translate[] = {0, p.depth, -p.height};
    out_ += "[setup.transform]\n";
    out_ += fmt::format("rotate = [180, 0, {}]\n", number("setup.back.transform.rotate.z", 0));
    out_ +=
        fmt::format("translate = [{}, {}, {}]\n", number("setup.back.transform.translate.x", translate[0]),
                    number("setup.back.transform.translate.y", translate[1]),
                    number("setup.back.transform.translate.z", translate[2]));
    return out_;
  }

 private:
  std::string number(const std::string& key, double right) const {
    return Writer::number(plan_.of(key, right));
  }
  void tool(int number_, const char* type, const std::vector<std::pair<const char*, double>>& keys) {
    out_ += fmt::format("[[tool]]\nnumber = {}\ntype = \"{}\"\n", number_, type);
    for (const auto& [key, value] : keys)
      out_ += fmt::format("{} = {}\n", key, number(fmt::format("tools.{}.{}", number_, key), value));
  }
  void setup(const std::string& name, const std::string& system, const Vec3& zero,
             const std::vector<int>& tools) {
    out_ += fmt::format("[[setup]]\nname = \"{}\"\nprogram = \"{}.nc\"\n[setup.offsets.work]\n{} = [", name,
                        name, system);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string key = fmt::format("offsets.work.{}.{}", system, "xyz"[axis]);
      out_ += number(key, zero[axis]) + (axis < 2 ? ", " : "]\n");
    }
    out_ += "[setup.offsets.length]\n";
    for (const int t : tools)
      out_ += fmt::format("{} = {}\n", t, number(fmt::format("offsets.length.{}", t), 0));
    out_ += "[setup.offsets.radius]\n";
    for (const int t : tools)
      out_ += fmt::format("{} = {}\n", t, t == 1 ? number("offsets.radius.1", p.mill / 2) : "0");
    out_ += fmt::format("[setup.placement]\norigin = [{}, {}, {}]\n", Writer::number(zero.x()),
                        Writer::number(zero.y()), Writer::number(zero.z()));
  }

  const Plate& p;
  const Plan& plan_;
  std::string out_;
};

constexpr const char* kTopNames[] = {
    "zero",       "pocket_z",  "pocket_side", "pocket_d", "pocket_start", "pocket_x1", "pocket_y1",
    "corner_1",   "corner_2",  "corner_3",    "corner_4", "hole_level",   "hole_z",    "hole_step",
    "hole_pitch", "sink_z",    "turn",        "turn_x",   "turn_y",       "turn_r",    "groove_z",
    "groove_x",   "unturn",    "plane",       "arc_turn", "arc_r",        "pocket_m3", "hole_m3",
    "sink_m3",    "groove_m3", "arc_m3"};
constexpr const char* kBackNames[] = {"zero", "bore_z", "bore_x", "bore_turn", "bore_i", "bore_m3"};

Mistake value(const char* kind, const std::string& name, double wrong, bool datum = false) {
  Mistake m;
  m.kind = kind;
  m.what = fmt::format("{} = {}", name, Writer::number(wrong));
  m.plan.values[name] = wrong;
  if (datum) m.data = {name};
  return m;
}

Mistake text(const char* kind, const std::string& file, const std::string& name, const std::string& wrong) {
  Mistake m;
  m.kind = kind;
  m.what = file + ":" + name + " = " + wrong;
  m.plan.texts[name] = wrong;
  m.words = {file + ":" + name};
  return m;
}

}  // namespace

StudyJob platesJob(std::uint32_t seed, const Plan& plan) {
  const Plate plate(seed);
  StudyJob out;
  const auto add = [&](const std::string& file, const Writer& w, const auto& names) {
    out.files.push_back({file, w.program()});
    for (const char* const name : names) out.lines[file + ":" + name] = w.lineOf(name);
  };
  Top top(plate, plan);
  Back back(plate, plan);
  add("top.nc", top.write(), kTopNames);
  add("back.nc", back.write(), kBackNames);
  out.files.push_back({"job.toml", PlateJob(plate, plan).write()});
  return out;
}

Mistake platesMistake(std::uint32_t seed) {
  const Plate p(seed);
  std::mt19937 random(seed * 40503U + 5U);
  const auto any = [&](auto... items) {
    const std::vector<std::string> all{items...};
    return all[random() % all.size()];
  };
  const unsigned axis = random() % 3;
  const std::string xyz(1, "xyz"[axis]);
  switch (random() % 14) {
    case 0:
      return value("zero", "offsets.work.G54." + xyz, p.zero[axis] + signedSize(random, 0.08, 1.5), true);
    case 1:
      return value("second setup's zero", "offsets.work.G55." + xyz,
                   p.back_zero[axis] + signedSize(random, 0.08, 1.5), true);
    case 2: {
      const double s = 2.0 * signedSize(random, 0.06, 0.4);
      return value("tool diameter", "tools.1.diameter", p.mill + s, true);
    }
    case 3:
      return value("corner radius", "tools.3.corner_radius",
                   random() % 2 == 0 ? p.corner + 0.75 : std::max(0.0, p.corner - 0.4), true);
    case 4:
      return value("cone angle", "tools.4.cone_angle",
                   p.sink == 90 ? (random() % 2 == 0 ? 82 : 60) : (random() % 2 == 0 ? 90 : 82), true);
    case 5:
      if (random() % 2 == 0)
        return value("drill", "tools.2.diameter", p.drill + signedSize(random, 0.15, 0.8), true);
      return value("drill", "tools.2.point_angle", p.point == 118 ? 140 : 118, true);
    case 6: {
      Mistake m = value("repeats", "hole_l", p.repeats + (random() % 2 == 0 ? 1 : -1));
      m.words = {"top.nc:hole_step"};
      return m;
    }
    case 7: {
      const std::string name = any("corner_1", "corner_2", "corner_3", "corner_4");
      return text("direction", "top.nc", name, p.comp_right ? "G3" : "G2");
    }
    case 8:
      return text("direction", "top.nc", "arc_turn", "G3");
    case 9:
      return text("plane", "top.nc", "plane", any("G17", "G19"));
    case 10:
      switch (random() % 3) {
        case 0: {
          Mistake m = value(
              "G68", "turn_r",
              p.groove_angle + (random() % 2 == 0 ? 1 : -1) * (2.0 + static_cast<double>(random() % 20)));
          m.words = {"top.nc:turn"};
          return m;
        }
        case 1: {
          Mistake m = value("G68", "turn_x", p.groove_x + signedSize(random, 0.3, 3));
          m.words = {"top.nc:turn"};
          return m;
        }
        default: {
          Mistake m = text("G68", "top.nc", "unturn", "G0");
          m.words = {"top.nc:turn", "top.nc:unturn"};
          return m;
        }
      }
    case 11: {
      const std::string name = any("pocket_m3", "hole_m3", "groove_m3", "bore_m3");
      return text("M5 for M3", name == "bore_m3" ? "back.nc" : "top.nc", name, "M5");
    }
    case 12: {
      if (random() % 4 == 0)
        return value("transform", "setup.back.transform.rotate.z", random() % 2 == 0 ? 0.5 : -1.0, true);
      const double right[] = {0, p.depth, -p.height};
      return value("transform", "setup.back.transform.translate." + xyz,
                   right[axis] + signedSize(random, 0.08, 1.5), true);
    }
    default: {
      const std::string side = p.comp_right ? "G42" : "G41", other = p.comp_right ? "G41" : "G42";
      switch (random() % 4) {
        case 0:
          return text("compensation", "top.nc", "pocket_side", other);
        case 1:
          return text("compensation", "top.nc", "pocket_side", "G40");
        case 2:
          return text("incremental", "top.nc", "hole_step", "G90");
        default:
          return value("radius row", "offsets.radius.1",
                       random() % 2 == 0 ? 0.0 : p.mill / 2 + signedSize(random, 0.06, 0.5), true);
      }
    }
  }
}

}  // namespace proveout::study
