// A shaft with chamfer, cone, radii, a groove and a bore: turned under WL4 from a bar.
#include "tests/study/planted.h"
#include "tests/support/lofts.h"

namespace proveout::study {
namespace {

using lofts::Profile;

struct Habit {
  double layer, allowance;
  bool constant_speed, bore_first, level_first;
};
Habit habitOf(int seed) {
  if (seed == 0) return {2.0, 0.3, true, false, false};
  std::mt19937 random(static_cast<unsigned>(seed) * 104729u + 3u);
  std::uniform_real_distribution<double> unit(0, 1);
  return {1.0 + 2.0 * unit(random), 0.15 + 0.3 * unit(random), random() % 2 == 0, random() % 2 == 0,
          random() % 2 == 0};
}

constexpr const char* kNames[] = {"c_x1",     "c_z1",   "c_z2",   "c_x2",     "c_x3",    "c_z3",
                                  "c_z4",     "c_x5",   "c_z5",   "c_x7",     "c_z7",    "c_z8",
                                  "c_r5",     "fin_t",  "fin_g",  "fin_comp", "rough_r", "groove_x",
                                  "groove_z", "bore_z", "face_z", "finish",   "groove",  "bore"};

class Program {
 public:
  Program(const Plan& plan, int habit) : w(plan), h(habitOf(habit)) {}

  Planted write() {
    w.block("%SHAFT");
    w.block("G54 G90 G95");
    rough();
    if (h.bore_first) bore();
    finish();
    groove();
    if (!h.bore_first) bore();
    w.block("M5");
    w.block("M2");
    contour();
    w.block("%");
    Planted out;
    out.program = w.program();
    for (const char* name : kNames) out.lines[name] = w.lineOf(name) > 0 ? w.lineOf(name) : w.beginOf(name);
    return out;
  }

 private:
  void rough() {
    w.block("N1 T1 M6");
    w.block("N2 G97 S1200 M3");
    w.block("N3 G0 X54 Z0.2");
    w.block("N4 G1 X-1.6 F0.2");
    w.block("N5 G0 Z3");
    w.block("N6 X52");
    w.put("N7 G77 G41 G0 X12 Z2 P200 Q209").word("R", "rough_r", h.allowance);
    w.put("E" + Writer::number(h.layer) + " F0.3").end();
    w.block("N8 G0 X80 Z20");
  }

  void finish() {
    w.put("N9").text("fin_t", "T2").put("M6").end();
    w.block(h.constant_speed ? "N10 G96 S180" : "N10 G97 S1500");
    w.put("N11").text("fin_g", "G55").put("G0 X30").word("Z", "face_z", 0).end();
    w.block("N12 G1 X-0.8 F0.1");
    w.block("N13 G0 Z3");
    w.block("N14 X52");
    if (w.has("finish")) w.put("N15 G77").text("fin_comp", "G41").put("G0 X12 Z2 P200 Q209 F0.1").end();
    w.block("N16 G0 X80 Z20");
    w.block("N17 G54");
  }

  void groove() {
    w.block("N20 T3 M6");
    w.block("N21 G97 S800");
    w.block("N22 G0 X52 Z20");
    if (w.has("groove")) {
      w.put("N23").word("Z", "groove_z", -56).end();
      w.put("N24 G1").word("X", "groove_x", 40).put("F0.06").end();
      w.block("N25 G0 X52");
    }
    w.block("N26 X80 Z20");
  }

  void bore() {
    w.block("N30 T4 M6");
    w.block("N31 G97 S1000");
    w.block("N32 G0 X0 Z5");
    if (w.has("bore")) {
      w.put("N33 G1").word("Z", "bore_z", -25).put("F0.1").end();
      w.block("N34 G0 Z5");
    }
    w.block("N35 X80 Z20");
  }

  void contour() {
    w.put("N200 G1").word("X", "c_x1", 20).word("Z", "c_z1", -2).end();
    w.put("N201").word("Z", "c_z2", -20).end();
    w.put("N202").word("X", "c_x2", 26).end();
    w.put("N203").word("X", "c_x3", 32).word("Z", "c_z3", -35).end();
    w.put("N204").word("Z", "c_z4", -42).end();
    w.put("N205 G3").word("X", "c_x5", 40).word("Z", "c_z5", -46).word("R", "c_r5", 4).end();
    w.block("N206 G1 X41");
    w.put("N207 G2").word("X", "c_x7", 45).word("Z", "c_z7", -48).put("R2").end();
    w.put("N208 G1").word("Z", "c_z8", -60).end();
    w.block("N209 X51");
  }

  Writer w;
  Habit h;
};

std::string jobText(const Plan& plan, int habit) {
  std::string out =
      "schema = \"proveout.job/1\"\nprogram = \"p.nc\"\n[control]\nname = "
      "\"wl4-lathe\"\n[control.wl4-lathe]\n"
      "RT.1 = 0.8\nTIP.1 = 3\n";
  out += "RT.2 = " + Writer::number(plan.of("control.wl4-lathe.RT.2", 0.4)) + "\nTIP.2 = 3\n";
  out += "[stock]\nshape = \"cylinder\"\nbase = [0, 0, -70]\ndiameter = 50\nlength = 71\n";
  out += "[nominal]\nmesh = \"nominal.stl\"\ngouge = 0.05\nexcess = 0.05\n";
  const auto corner = [&](int number, double nose) {
    out += "[[tool]]\nnumber = " + std::to_string(number) + "\ntype = \"insert\"\nnose_radius = " +
           Writer::number(plan.of("tools." + std::to_string(number) + ".nose_radius", nose)) +
           "\norientation = 3\ninsert_angle = 55\nlead_angle = 93\nedge_length = 13\n";
  };
  corner(1, 0.8);
  corner(2, 0.4);
  out +=
      "[[tool]]\nnumber = 3\ntype = \"insert\"\nshape = \"groove\"\nwidth = 4\nnose_radius = "
      "0.2\norientation = 3\n"
      "edge_length = 12\nside_relief = 1\n";
  out +=
      "[[tool]]\nnumber = 4\ntype = \"drill\"\ndiameter = " + Writer::number(plan.of("tools.4.diameter", 8)) +
      "\n";
  const double zero = habit % 3 == 1 ? 0.0 : -150.0;
  out += "[offsets.work]\nG54 = [0, 0, " + Writer::number(zero) + "]\n";
  out += "G55 = [" + Writer::number(plan.of("offsets.work.G55.x", 0)) + ", 0, " +
         Writer::number(plan.of("offsets.work.G55.z", 0) + zero) + "]\n";
  return out;
}

TriMesh shaft(double chord) {
  const double tip = 4.0 / std::tan(degToRad(59.0));
  return lofts::solid(Profile()
                          .line(25, -70)
                          .line(25, -60)
                          .arc(22.9, -59.6, 0.4, -90, -180)
                          .line(22.5, -56)
                          .arc(20.2, -55.8, 0.2, -90, -180)
                          .arc(20.2, -52.2, 0.2, 180, 90)
                          .line(22.5, -52)
                          .arc(20.5, -48, 2, 0, 90)
                          .arc(20, -42, 4, -90, -180)
                          .line(16, -35)
                          .line(13, -20)
                          .arc(10.4, -19.6, 0.4, -90, -180)
                          .line(10, -2)
                          .line(8, 0)
                          .line(4, 0)
                          .line(4, -25 + tip)
                          .line(0, -25),
                      {0, 0}, chord);
}

Defect word(const char* kind, const char* name, double right, double size, std::optional<double> depth) {
  Defect d{kind, {}, size, depth, {name}, {}, false};
  d.plan.values[name] = right + size;
  return d;
}
Defect datum(const char* kind, const std::string& key, double right, double size,
             std::optional<double> depth) {
  Defect d{kind, {}, size, depth, {}, {key}, false};
  d.plan.values[key] = right + size;
  return d;
}

Defect defectOf(std::mt19937& random) {
  const double s = signedSize(random, 0.005, 1.0), half = 0.5 * std::abs(s);
  switch (random() % 16) {
    case 0:
      return word("X", "c_x1", 20, s, std::nullopt);
    case 1:
      return word("Z", "c_z2", -20, s, std::abs(s));
    case 2:
      return word("X", "c_x3", 32, s, std::nullopt);
    case 3:
      return word("Z", "c_z3", -35, s, std::nullopt);
    case 4:
      return word("Z", "c_z5", -46, std::clamp(s, -0.5, 0.5), std::nullopt);
    case 5:
      return word("X", "c_x7", 45, s, half);
    case 6:
      return word("Z", "c_z8", -60, s, std::abs(s));
    case 7:
      return word("X", "groove_x", 40, s, half);
    case 8:
      return word("Z", "groove_z", -56, s, std::abs(s));
    case 9:
      return word("Z", "bore_z", -25, s, std::abs(s));
    case 10:
      return datum("work offset (operator)", "offsets.work.G55.x", 0, std::clamp(s, -0.5, 0.5), std::nullopt);
    case 11:
      return datum("work offset (operator)", "offsets.work.G55.z", 0, std::clamp(s, -0.5, 0.5), std::nullopt);
    case 12: {
      Defect d = datum("radius (operator)", "control.wl4-lathe.RT.2", 0.4, 0.4, std::nullopt);
      d.data.insert("tools.2.nose_radius");
      return d;
    }
    case 13: {
      Defect d{"tool word", {}, 0.4, std::nullopt, {"fin_t"}, {}, false};
      d.plan.texts["fin_t"] = "T1";
      return d;
    }
    case 14: {
      Defect d = datum("radius (operator)", "tools.4.diameter", 8, s, half);
      return d;
    }
    default: {
      const char* const features[] = {"finish", "groove", "bore"};
      const char* const name = features[random() % 3];
      Defect d{"left out", {}, 1.0, std::nullopt, {name, "rough_r"}, {}, true};
      d.plan.dropped.insert(name);
      return d;
    }
  }
}

}  // namespace

StudyPart turnedPart() {
  StudyPart part;
  part.name = "turned";
  part.write = [](const Plan& plan, int habit) {
    Planted out = Program(plan, habit).write();
    out.job = jobText(plan, habit);
    return out;
  };
  part.nominal = shaft;
  part.defect = defectOf;
  return part;
}

}  // namespace proveout::study
