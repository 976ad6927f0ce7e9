// A plate with a boss, pockets, holes, slots and countersinks: cut under NCT with six tools.
#include "tests/study/planted.h"
#include "tests/support/lofts.h"

namespace proveout::study {
namespace {

using lofts::Hole;
using lofts::Profile;

struct Habit {
  bool passes, wear, peck, steps, levels, back, macro, helix, drill_first, plain_zero;
};
Habit habitOf(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed) * 7919u + 1u);
  const auto coin = [&] { return seed != 0 && random() % 2 == 0; };
  return {coin(), coin(), coin(), coin(), coin(), coin(), coin(), coin(), coin(), coin()};
}

/// Lengths of the tools; those of H are the same.
constexpr double kGauge[] = {0, 100, 100.4, 120, 100.9, 101.5, 99.2, 100.4, 120};

class Program {
 public:
  Program(const Plan& plan, int habit) : w(plan), h(habitOf(habit)) {}

  Planted write() {
    w.block("%");
    w.block("O0700 (PLATE)");
    w.text("plane", "G17").block("G21 G90 G94 G40 G49 G80");
    if (h.drill_first) drill();
    boss();
    pocket();
    if (!h.drill_first) drill();
    slots();
    roundPocket();
    sinks();
    w.block("G0 Z120 M5");
    w.block("M30");
    w.block("%");
    Planted out;
    out.program = w.program();
    for (const char* name : kNames) out.lines[name] = w.lineOf(name) > 0 ? w.lineOf(name) : w.beginOf(name);
    return out;
  }

  static constexpr const char* kNames[] = {
      "plane",     "boss_z",    "boss_side", "boss_comp", "boss_d",       "boss_r",   "boss_h",   "pocket_z",
      "pocket_x1", "pocket_x2", "pocket_y0", "pocket_y1", "pocket_t",     "pocket_h", "pocket_g", "hole_1x",
      "hole_1y",   "hole_2x",   "hole_3y",   "hole_4x",   "hole_r",       "drill_t",  "drill_h",  "blind_z",
      "blind_x",   "blind_y",   "slot_z",    "slot_h",    "slot_retract", "slot_y",   "slot2_z",  "round_z",
      "round_x",   "round_i",   "round_h",   "sink_z",    "sink_h",       "pocket",   "hole_4",   "slot2",
      "round",     "sinks",     "blind"};

 private:
  void tool(int number, const std::string& t_name, int speed, const std::string& system,
            const std::string& g_name, const std::string& place, const std::string& h_name) {
    w.text(t_name, "T" + std::to_string(number)).put("M6").end();
    w.block("S" + std::to_string(speed) + " M3");
    w.text(g_name, system).put("G0 " + place).end();
    w.put("G43 Z20").text(h_name, "H" + std::to_string(number)).end();
  }

  void boss() {
    tool(1, "boss_t", 4000, "G54", "boss_g", "X-12 Y-12", "boss_h");
    if (h.passes) round("-3", false);
    round("", true);
    w.block("G0 Z50");
  }
  void round(const std::string& z, bool last) {
    w.block("G0 Z2");
    if (last) {
      w.put("G1").word("Z", "boss_z", -6).put("F900").end();
    } else {
      w.block("G1 Z" + z + " F900");
    }
    w.text("boss_comp", "G41").text("boss_d", "D1").word("X", "boss_side", 5).put("Y-8").end();
    w.block("Y30");
    w.put("G2 X10 Y35").word("R", "boss_r", 5).end();
    w.block("G1 X50");
    w.block("G2 X55 Y30 R5");
    w.block("G1 Y10");
    w.block("G2 X50 Y5 R5");
    w.block("G1 X10");
    w.block("G2 X5 Y10 R5");
    w.block("G1 Y20");
    w.block("G40 X-14");
    w.block("G0 Y-12");
    w.block("X-12");
  }

  void pocket() {
    tool(2, "pocket_t", 6000, "G55", "pocket_g", "X22 Y20", "pocket_h");
    if (!w.has("pocket")) return;
    w.put("G0").put("X17").word("Y", "pocket_y0", 18).end();
    w.block("Z1");
    if (h.levels) {
      w.block("G1 Z-2 F300");
      w.block("X27 F700");
      w.block("Y22");
      w.block("X17");
      w.block("Y18");
    }
    if (h.macro) w.block("#101=-4");
    if (h.macro) {
      w.block("G1 Z#101 F300");
    } else {
      w.put("G1").word("Z", "pocket_z", -4).put("F300").end();
    }
    if (h.steps) {
      w.block("G91 X10 F700");
      w.block("Y4");
      w.block("X-10");
      w.block("Y-4");
      w.block("G90");
    } else {
      w.word("X", "pocket_x1", 27).put("F700").end();
      w.word("Y", "pocket_y1", 22).end();
      w.word("X", "pocket_x2", 17).end();
      w.block("Y18");
    }
    w.block("G0 Z50");
  }

  void drill() {
    tool(3, "drill_t", 3000, "G54", "drill_g", "X12 Y11", "drill_h");
    w.put(h.peck ? "G98 G83" : "G98 G81").word("X", "hole_1x", 12).word("Y", "hole_1y", 11).put("Z-20");
    w.word("R", "hole_r", 2).put(h.peck ? "Q4 F200" : "F200").end();
    w.word("X", "hole_2x", 48).end();
    w.word("Y", "hole_3y", 29).end();
    if (w.has("hole_4")) w.word("X", "hole_4x", 12).end();
    if (w.has("blind"))
      w.put("G83")
          .word("X", "blind_x", 36)
          .word("Y", "blind_y", 11)
          .word("Z", "blind_z", -10)
          .put("R2 Q3")
          .end();
    w.block("G80");
    w.block("G0 Z50");
  }

  void slots() {
    tool(4, "slot_t", 8000, "G54", "slot_g", "X20 Y0", "slot_h");
    w.put("X20").word("Y", "slot_y", 31).end();
    w.block("Z2");
    w.put("G1").word("Z", "slot_z", -2).put("F200").end();
    w.block("X40 F500");
    if (h.back) w.block("X20");
    w.put("G0").word("Z", "slot_retract", 5).end();
    w.block("X20 Y8.5");
    if (w.has("slot2")) {
      w.put("G1").word("Z", "slot2_z", -1).put("F200").end();
      w.block("X30 F500");
    }
    w.block("G0 Z50");
  }

  void roundPocket() {
    tool(5, "round_t", 6000, "G55", "round_g", "X43 Y20", "round_h");
    if (!w.has("round")) return;
    w.block("Z1");
    w.put("G1").word("Z", "round_z", -3).put("F200").end();
    if (h.helix) {
      w.block("G0 Z1");
      w.block("G1 X45 Z0.5");
      w.block("G3 X45 Y20 Z-3 I-2 J0");
    } else {
      w.word("X", "round_x", 45).put("F500").end();
    }
    w.put("G3").word("I", "round_i", -2).put("J0").end();
    w.block("G1 X43");
    w.block("G0 Z50");
  }

  void sinks() {
    tool(6, "sink_t", 3000, "G54", "sink_g", "X12 Y11", "sink_h");
    if (w.has("sinks")) {
      w.put("G81").word("Z", "sink_z", -4).put("R2 F150").end();
      w.block("X48");
    }
    w.block("G80");
  }

  Writer w;
  Habit h;
};

std::string jobText(const Plan& plan, int habit) {
  const Habit h = habitOf(habit);
  std::string out = "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"p.nc\"\n";
  out += "[stock]\nshape = \"box\"\nmin = [0, 0, -16]\nmax = [60, 40, 0]\n";
  out += "[nominal]\nmesh = \"nominal.stl\"\ngouge = 0.05\nexcess = 0.05\n";
  const auto tool = [&](int number, const std::string& type, double diameter, const std::string& more) {
    out += "[[tool]]\nnumber = " + std::to_string(number) + "\ntype = \"" + type + "\"\ndiameter = " +
           Writer::number(plan.of("tools." + std::to_string(number) + ".diameter", diameter)) +
           "\ngauge_length = " + Writer::number(kGauge[number]) + "\n" + more;
  };
  tool(1, "flat", 12, "");
  tool(2, "flat", 6, "");
  tool(3, "drill", 5, "");
  tool(4, "ball", 6, "");
  tool(5, "bull", 8, "corner_radius = 1\n");
  tool(6, "cone", 10, "tip_diameter = 0\ncone_angle = 90\n");
  tool(7, "flat", 5.5, "");
  tool(8, "drill", 4.8, "");
  const auto vector = [&](const std::string& name, const Vec3& right) {
    out += name + " = [" + Writer::number(plan.of("offsets.work." + name + ".x", right.x())) + ", " +
           Writer::number(plan.of("offsets.work." + name + ".y", right.y())) + ", " +
           Writer::number(plan.of("offsets.work." + name + ".z", right.z())) + "]\n";
  };
  const Vec3 zero = h.plain_zero ? Vec3(0, 0, 0) : Vec3(310, 205, -400);
  out += "[offsets.work]\n";
  vector("G54", zero);
  vector("G55", zero);
  vector("G56", zero + Vec3(0.7, -0.4, 0.3));
  out += "[offsets.length]\n";
  for (int k = 1; k <= 8; ++k)
    out += std::to_string(k) + " = " +
           Writer::number(plan.of("offsets.length." + std::to_string(k), kGauge[k])) + "\n";
  out += "[offsets.radius]\n";
  const double d = plan.of("offsets.radius.1", 6.0);
  out += h.wear ? "1 = { geometry = 6.1, wear = -0.1 }\n" : "1 = " + Writer::number(d) + "\n";
  out += "2 = 5.6\n";
  return out;
}

/// Of a ball of radius 3 whose centre is so high; a vertex where it comes out of the face, as CAD exports
/// have it.
Profile ballSlot(double center) {
  const double rim = -radToDeg(std::asin(center / 3.0));
  return Profile().arc(0, center, 3, -90, rim).arc(0, center, 3, rim, 0).line(3, 3);
}

TriMesh plate(double chord) {
  const auto box = [](const Vec3& a, const Vec3& b) {
    TriMesh m;
    for (int k = 0; k < 8; ++k)
      m.positions.push_back(Eigen::Vector3f(static_cast<float>(k & 1 ? b.x() : a.x()),
                                            static_cast<float>(k & 2 ? b.y() : a.y()),
                                            static_cast<float>(k & 4 ? b.z() : a.z())));
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
  };
  TriMesh mesh = booleanOf(box({0, 0, -16}, {60, 40, -6}),
                           lofts::solid(Profile().line(5, -8).line(5, 0), {20, 10}, chord, {30, 20}),
                           BooleanKind::kUnion)
                     .value();
  const double tip = 2.5 / std::tan(degToRad(59.0));
  const Profile through = Profile().line(2.5, -20).line(2.5, 3);
  std::vector<Hole> holes = {{Profile().line(3, -4).line(3, 3), {22, 20}, {5, 2}}};
  for (const Vec2& at : {Vec2(12, 11), Vec2(48, 11), Vec2(48, 29), Vec2(12, 29)})
    holes.push_back({through, at, {0, 0}});
  holes.push_back({Profile().line(0, -10).line(2.5, -10 + tip).line(2.5, 3), {36, 11}, {0, 0}});
  holes.push_back({ballSlot(1), {30, 31}, {10, 0}});
  holes.push_back({ballSlot(2), {25, 8.5}, {5, 0}});
  holes.push_back({Profile().line(5, -3).arc(5, -2, 1, -90, 0).line(6, 3), {43, 20}, {0, 0}});
  for (const Vec2& at : {Vec2(12, 11), Vec2(48, 11)})
    holes.push_back({Profile().line(2, -2).line(6, 2), at, {0, 0}});
  return lofts::plateWith(mesh, holes, chord);
}

/// Height of an arc of chord 5 * sqrt(2) and radius r over its chord.
double sagitta(double r) { return r - std::sqrt(r * r - 12.5); }

Defect wordDefect(const char* kind, const char* name, double right, double size,
                  std::optional<double> depth) {
  Defect d{kind, {}, size, depth, {name}, {}, false};
  d.plan.values[name] = right + size;
  return d;
}
Defect datumDefect(const char* kind, const std::string& key, double right, double size,
                   std::optional<double> depth) {
  Defect d{kind, {}, size, depth, {}, {key}, false};
  d.plan.values[key] = right + size;
  return d;
}
Defect textDefect(const char* kind, const char* name, const std::string& text, double size,
                  std::optional<double> depth) {
  Defect d{kind, {}, size, depth, {name}, {}, false};
  d.plan.texts[name] = text;
  return d;
}

Defect wrongZ(std::mt19937& random) {
  const double s = signedSize(random, 0.005, 2.0);
  switch (random() % 6) {
    case 0:
      return wordDefect("Z", "boss_z", -6, s, std::abs(s));
    case 1:
      return wordDefect("Z", "pocket_z", -4, s, std::abs(s));
    case 2:
      return wordDefect("Z", "blind_z", -10, s, std::abs(s));
    case 3:
      return wordDefect("Z", "round_z", -3, s, std::abs(s));
    case 4:
      return wordDefect("Z", "slot_z", -2, std::clamp(s, -2.0, 1.5), std::nullopt);
    default: {
      const double small = std::clamp(s, -0.8, 0.8);
      return wordDefect("Z", "sink_z", -4, small, std::abs(small) * std::sqrt(0.5));
    }
  }
}

Defect wrongXY(std::mt19937& random) {
  const double s = signedSize(random, 0.005, 2.0);
  switch (random() % 12) {
    case 0:
      return wordDefect("X, Y", "pocket_x1", 27, s, std::abs(s));
    case 1:
      return wordDefect("X, Y", "pocket_x2", 17, s, std::abs(s));
    case 2:
      return wordDefect("X, Y", "pocket_y0", 18, s, std::abs(s));
    case 3:
      return wordDefect("X, Y", "pocket_y1", 22, s, std::abs(s));
    case 4:
      return wordDefect("X, Y", "hole_1x", 12, s, std::nullopt);
    case 5:
      return wordDefect("X, Y", "hole_1y", 11, s, std::nullopt);
    case 6:
      return wordDefect("X, Y", "hole_2x", 48, s, std::nullopt);
    case 7:
      return wordDefect("X, Y", "hole_3y", 29, s, std::abs(s));
    case 8:
      return wordDefect("X, Y", "hole_4x", 12, s, std::abs(s));
    case 9:
      return wordDefect("X, Y", "blind_x", 36, s, std::abs(s));
    case 10:
      return wordDefect("X, Y", "blind_y", 11, s, std::abs(s));
    default:
      return wordDefect("X, Y", "slot_y", 31, std::clamp(s, -1.5, 0.9), std::nullopt);
  }
}

Defect wrongLength(std::mt19937& random) {
  const int tools[] = {1, 2, 5};
  const int t = tools[random() % 3];
  const double s = signedSize(random, 0.005, 1.5);
  return datumDefect("length (operator)", "offsets.length." + std::to_string(t), kGauge[t], s, std::abs(s));
}

Defect wrongRadius(std::mt19937& random) {
  const double s = signedSize(random, 0.005, 0.8);
  switch (random() % 3) {
    case 0:
      return datumDefect("radius (operator)", "offsets.radius.1", 6, s, std::abs(s));
    case 1:
      return datumDefect("radius (operator)", "tools.2.diameter", 6, 2 * s, std::abs(s));
    default:
      return datumDefect("radius (operator)", "tools.3.diameter", 5, 2 * s, std::abs(s));
  }
}

Defect wrongOffset(std::mt19937& random) {
  const char* const axes[] = {"x", "y", "z"};
  const double rights[] = {310, 205, -400};
  const unsigned axis = random() % 3;
  const double s = signedSize(random, 0.005, 1.5);
  // Farther off sideways the round pocket breaks into a countersink: the wall between is gone.
  const bool apart = axis == 2 || std::abs(s) < 0.25;
  Defect d = datumDefect("work offset (operator)", std::string("offsets.work.G55.") + axes[axis],
                         rights[axis], s, apart ? std::optional(std::abs(s)) : std::nullopt);
  return d;
}

Defect wrongCode(std::mt19937& random) {
  switch (random() % 7) {
    case 0:
      return textDefect("tool word", "pocket_t", "T7", 0.25, 0.25);
    case 1:
      return textDefect("tool word", "drill_t", "T8", 0.1, 0.1);
    case 2:
      return textDefect("H word", "pocket_h", "H4", 0.5, 0.5);
    case 3:
      return textDefect("H word", "round_h", "H4", 0.6, 0.6);
    case 4:
      return textDefect("offset word", "pocket_g", "G56", 0.7, std::nullopt);
    case 5:
      return textDefect("D word", "boss_d", "D2", 0.4, 0.4);
    default:
      return textDefect("compensation", "boss_comp", random() % 2 == 0 ? "G42" : "G40", 6, std::nullopt);
  }
}

Defect wrongShape(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  switch (random() % 5) {
    case 0: {
      const double r = 4.0 + 4.0 * unit(random);
      return wordDefect("corner", "boss_r", 5, r - 5, std::abs(sagitta(r) - sagitta(5)));
    }
    case 1: {
      const double s = signedSize(random, 0.005, 0.5);
      return wordDefect("arc", "round_i", -2, s, std::nullopt);
    }
    case 2:
      return wordDefect("retract", "slot_retract", 5, -5.2 - 1.5 * unit(random), std::nullopt);
    case 3:
      return wordDefect("plane of a cycle", "hole_r", 2, -2.2 - 2 * unit(random), std::nullopt);
    default:
      return textDefect("plane", "plane", "G18", 5, std::nullopt);
  }
}

Defect leftOut(std::mt19937& random) {
  const std::pair<const char*, double> features[] = {{"pocket", 4.0}, {"hole_4", -1}, {"slot2", 1.0},
                                                     {"round", 3.0},  {"sinks", -1},  {"blind", -1}};
  const auto& [name, depth] = features[random() % 6];
  Defect d{"left out", {}, 1.0, depth > 0 ? std::optional(depth) : std::nullopt, {name}, {}, true};
  d.plan.dropped.insert(name);
  return d;
}

}  // namespace

StudyPart milledPart() {
  StudyPart part;
  part.name = "milled";
  part.write = [](const Plan& plan, int habit) {
    Planted out = Program(plan, habit).write();
    out.job = jobText(plan, habit);
    return out;
  };
  part.nominal = plate;
  part.defect = [](std::mt19937& random) {
    const unsigned kind = random() % 20;
    if (kind < 5) return wrongZ(random);
    if (kind < 10) return wrongXY(random);
    if (kind < 12) return wrongLength(random);
    if (kind < 14) return wrongRadius(random);
    if (kind < 16) return wrongOffset(random);
    if (kind < 17) return wrongCode(random);
    if (kind < 19) return wrongShape(random);
    return leftOut(random);
  };
  return part;
}

}  // namespace proveout::study
